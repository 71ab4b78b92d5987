// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_plausible_ranges_h
#define waker_simulation_plausible_ranges_h

#include <sstream>
#include <string>
#include <vector>

namespace Waker
{
  /// Appends a warning unless the value lies in the range.
  class Ranges
  {
  public:
    explicit Ranges(std::vector<std::string> &warnings)
      : warnings(warnings)
    {}

    void
    check(const std::string &path,
          const double       value,
          const double       low,
          const double       high,
          const std::string &unit,
          const std::string &whose)
    {
      if (value >= low && value <= high)
        return;
      std::ostringstream text;
      text << path << " is " << value << unit << "; " << whose << " " << low
           << " to " << high << unit;
      warnings.push_back(text.str());
    }

  private:
    std::vector<std::string> &warnings;
  };


  /// The strength of a soil, and its stiffness as a multiple of it.
  inline void
  check_strength(const std::string &path,
                 const std::string &name,
                 const double       strength,
                 const double       youngs_modulus,
                 Ranges            &ranges)
  {
    ranges.check(path + name, strength, 0.5, 2000., " kPa", "soils have");
    ranges.check(path + "Young's modulus by strength",
                 youngs_modulus / strength,
                 20.,
                 10000.,
                 "",
                 "usual is");
  }
} // namespace Waker

#endif
