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


  /// @param path "Materials/<name>/"
  /// @param cohesion kPa
  inline void
  check_cohesion(const std::string &path, const double cohesion, Ranges &ranges)
  {
    constexpr double least = 0.1;
    // Points at a free surface have no pressure that would give them strength.
    ranges.check(path + "Cohesion",
                 cohesion,
                 least,
                 200.,
                 " kPa",
                 cohesion < least ? "slopes of less shed their skin, or slide, "
                                    "far below their angle; soils have"
                                  : "soils have");
  }


  /// @param path "Materials/<name>/"
  /// @param angle degrees
  inline void
  check_friction_angle(const std::string &path,
                       const double       angle,
                       Ranges            &ranges)
  {
    ranges.check(path + "Friction angle",
                 angle,
                 10.,
                 50.,
                 " degrees",
                 angle == 0.
                   ? "clay without drainage is Model = von Mises softening, or "
                     "Pore fluid stiffness; soils with friction have"
                   : "soils have");
  }


  /// @param path "Walls/<name>/" or "Boundary conditions/<name>/"
  inline void
  check_penalty_factor(const std::string &path,
                       const double       factor,
                       Ranges            &ranges)
  {
    ranges.check(path + "Penalty factor",
                 factor,
                 10.,
                 1e6,
                 "",
                 factor < 10.
                   ? "softer springs give way by a tenth of the soil's own "
                     "strain and more; usual is"
                   : "usual is");
  }


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
