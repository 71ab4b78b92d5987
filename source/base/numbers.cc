// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/numbers.h>

#include <charconv>
#include <cmath>

namespace Waker
{
  const char *const decimals_with_a_point =
    "; decimals with a point (0.25), not a comma";


  bool
  read_number(const std::string &text, double &number)
  {
    // Of the signs the library reads the minus only.
    const bool        plus   = text.size() > 1 && text[0] == '+';
    const char *const begin  = text.data() + (plus && text[1] != '-' ? 1 : 0);
    const char *const end    = text.data() + text.size();
    double            value  = 0.;
    const auto        result = std::from_chars(begin, end, value);
    if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value))
      return false;
    number = value;
    return true;
  }


  std::string
  in_digits(const double number)
  {
    char       text[32];
    const auto end = std::to_chars(text, text + sizeof text, number).ptr;
    return std::string(text, end);
  }


  bool
  may_be_titles(const std::string &line)
  {
    const char *const separators = ",; \t\r\"'";
    std::size_t       begin      = 0;
    while ((begin = line.find_first_not_of(separators, begin)) !=
           std::string::npos)
      {
        const std::size_t digit = line.find_first_not_of("+-.", begin);
        if (digit != std::string::npos && line[digit] >= '0' &&
            line[digit] <= '9')
          return false;
        begin = line.find_first_of(separators, begin);
      }
    return true;
  }
} // namespace Waker
