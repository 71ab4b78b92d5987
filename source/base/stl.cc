// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/stl.h>
#include <waker/base/text.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

namespace Waker
{
  std::vector<StlTriangle>
  parse_stl(const std::string &text,
            const std::string &file,
            const std::string &path)
  {
    using dealii::Point;
    const auto refuse = [&](const std::string &what) {
      throw UserError(path,
                      "\"" + file + "\" " + what,
                      std::string("an STL file, text or binary") +
                        decimals_with_a_point);
    };
    std::vector<StlTriangle> triangles;

    // Binary: 80 bytes, the number of triangles, and for each a normal and
    // three vertices as floats and two bytes more. Only the size tells.
    constexpr std::size_t header = 84, per_triangle = 50;
    std::uint32_t         n = 0;
    if (text.size() >= header)
      std::memcpy(&n, text.data() + 80, sizeof n);
    if (text.size() >= header && text.size() == header + n * per_triangle)
      {
        for (std::uint32_t i = 0; i < n; ++i)
          {
            float x[12];
            std::memcpy(x, text.data() + header + i * per_triangle, sizeof x);
            StlTriangle triangle;
            for (unsigned int k = 0; k < 3; ++k)
              triangle[k] = Point<3>(x[3 + 3 * k], x[4 + 3 * k], x[5 + 3 * k]);
            triangles.push_back(triangle);
          }
      }
    else
      {
        std::istringstream stream(text);
        std::string        word;
        StlTriangle        triangle;
        unsigned int       k = 0;
        // A text has no zeros; a binary file that is not of the size of its
        // facets may begin with "solid", too.
        if (text.size() >= header && text.find('\0') != std::string::npos)
          refuse("is no text, and as binary STL it is damaged: it announces " +
                 counted(n, "facet") + ", with which it would have " +
                 std::to_string(header + std::uint64_t(n) * per_triangle) +
                 " bytes, but it has " + std::to_string(text.size()));
        if (!(stream >> word) || word != "solid")
          refuse("is no STL file");
        while (stream >> word)
          if (word == "vertex")
            {
              Point<3> x;
              if (k == 3 || !(stream >> x[0] >> x[1] >> x[2]))
                refuse("has a facet that is no triangle");
              triangle[k++] = x;
            }
          else if (word == "endfacet")
            {
              if (k != 3)
                refuse("has a facet that is no triangle");
              triangles.push_back(triangle);
              k = 0;
            }
      }
    for (const StlTriangle &triangle : triangles)
      for (const Point<3> &x : triangle)
        for (unsigned int d = 0; d < 3; ++d)
          if (!std::isfinite(x[d]))
            refuse("has a vertex that is not a number");
    return triangles;
  }
} // namespace Waker
