// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/loads/phreatic_line.h>

#include <algorithm>

namespace Waker
{
  PhreaticLine::PhreaticLine(const std::string &text, const std::string &path)
  {
    if (tidy(text).empty())
      return;
    const std::string allowed =
      "two corners or more, \"x, y; x, y\" (m), x ascending";
    std::vector<std::string> items = split(text, ';');
    if (tidy(items.back()).empty())
      items.pop_back(); // a semicolon at the end
    for (const std::string &item : items)
      {
        const std::vector<std::string> numbers = split(item, ',');
        std::array<double, 2>          corner;
        if (numbers.size() != 2 || !read_number(numbers[0], corner[0]) ||
            !read_number(numbers[1], corner[1]))
          throw UserError(path,
                          "corner " + std::to_string(corners.size() + 1) +
                            " is \"" + tidy(item) + "\", not two numbers",
                          allowed);
        if (!corners.empty() && !(corner[0] > corners.back()[0]))
          throw UserError(path,
                          "corner " + std::to_string(corners.size() + 1) +
                            " has x = " + in_digits(corner[0]) +
                            " m after x = " + in_digits(corners.back()[0]) +
                            " m",
                          allowed);
        corners.push_back(corner);
      }
    if (corners.size() < 2)
      throw UserError(path,
                      "\"" + tidy(text) + "\" has " +
                        std::to_string(corners.size()) + " corner",
                      allowed);
  }


  double
  PhreaticLine::height(const double x) const
  {
    if (x <= begin())
      return corners.front()[1];
    if (x >= end())
      return corners.back()[1];
    const auto next =
      std::upper_bound(corners.begin(),
                       corners.end(),
                       x,
                       [](const double value, const auto &corner) {
                         return value < corner[0];
                       });
    const auto  &b = *next, &a = *(next - 1);
    const double share = (x - a[0]) / (b[0] - a[0]);
    return a[1] + share * (b[1] - a[1]);
  }
} // namespace Waker
