// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_stl_h
#define waker_base_stl_h

#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <vector>

namespace Waker
{
  using StlTriangle = std::array<dealii::Point<3>, 3>;

  /**
   * The triangles of an STL file, text or binary; each has vertices of its own.
   *
   * @param text the contents of the file
   * @param file its name, for the error
   * @param path of the parameter with the name
   * @throws UserError at `path`: no STL, facets that are no triangles, vertices
   * that are no numbers
   */
  std::vector<StlTriangle>
  parse_stl(const std::string &text,
            const std::string &file,
            const std::string &path);
} // namespace Waker

#endif
