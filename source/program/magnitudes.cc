// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/program/magnitudes.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace Waker
{
  namespace
  {
    constexpr double least = 1e-15, largest = 1e15;


    bool
    is_of_a_word(const char c)
    {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
             c == '.';
    }


    /// Does it hold numbers, by itself or in lists, tables and expressions?
    /// What has a name or a path says so.
    bool
    holds_numbers(const DeclaredParameter &parameter)
    {
      const auto begins = [](const std::string &text,
                             const std::string &start) {
        return text.compare(0, start.size(), start) == 0;
      };
      const std::string &pattern = parameter.pattern;
      if (begins(pattern, "[Bool") || begins(pattern, "[Selection") ||
          begins(pattern, "[Integer") || begins(pattern, "[FileName"))
        return false;
      return !begins(pattern, "[Anything") ||
             !(begins(parameter.documentation, "Name") ||
               parameter.path() == "Output/Directory" ||
               parameter.path() == "Sweep/Parameter" ||
               parameter.name == "Material");
    }
  } // namespace


  std::optional<std::string>
  odd_magnitude(const std::string &text)
  {
    const char *const end = text.data() + text.size();
    for (const char *begin = text.data(); begin < end;)
      {
        if (!is_of_a_word(*begin))
          {
            ++begin;
            continue;
          }
        double      number = 0.;
        const auto  read   = std::from_chars(begin, end, number);
        const char *stop   = std::max(begin + 1, read.ptr);
        const bool  is_one = read.ptr > begin &&
                            (stop == end || !is_of_a_word(*stop)) &&
                            read.ec != std::errc::invalid_argument;
        const double size = std::abs(number);
        if (is_one && (read.ec == std::errc::result_out_of_range ||
                       (size != 0. && !(size >= least && size <= largest))))
          return std::string(begin, stop);
        begin = stop;
        while (begin < end && is_of_a_word(*begin))
          ++begin;
      }
    return {};
  }


  void
  check_magnitudes(const std::vector<DeclaredParameter> &parameters)
  {
    for (const DeclaredParameter &parameter : parameters)
      if (parameter.value != parameter.default_value &&
          holds_numbers(parameter))
        if (const auto number = odd_magnitude(parameter.value))
          throw UserError(parameter.path(),
                          "has the number " + *number +
                            ", beyond what can be computed with",
                          "0, or numbers from 1e-15 to 1e15 in size");
  }
} // namespace Waker
