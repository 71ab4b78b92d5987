// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wall_warnings.h"

#include <deal.II/base/numbers.h>

#include <waker/base/expression_pattern.h>
#include <waker/nodes/wall_spots.h>

#include "plausible_ranges.h"
#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// The most that one of the soils has: of cohesion or strength without
    /// drainage (kPa), and of friction if all have some; nothing if one has an
    /// expression.
    struct OwnStrength
    {
      std::optional<double> cohesion = 0., tan_phi = 0.;
    };


    OwnStrength
    own_strength(const std::vector<MaterialParameters> &materials)
    {
      const auto at_least = [](std::optional<double>       &most,
                               const std::optional<double> &value) {
        if (!value)
          most.reset();
        else if (most)
          most = std::max(*most, *value);
      };
      OwnStrength most;
      for (const MaterialParameters &m : materials)
        {
          const auto undrained = m.undrained_strength();
          if (m.has_friction())
            {
              at_least(most.cohesion, plain_number(m.mohr_coulomb.cohesion));
              auto phi = plain_number(m.mohr_coulomb.friction_angle);
              if (phi)
                phi = std::tan(*phi * numbers::PI / 180.);
              at_least(most.tan_phi, phi);
            }
          else
            {
              at_least(most.cohesion,
                       undrained ? plain_number(*undrained)
                                 : std::optional<double>());
              most.tan_phi.reset(); // its strength knows no pressure
            }
        }
      return most;
    }
  } // namespace


  void
  warn_of_friction(const Parameters &p, std::vector<std::string> &warnings)
  {
    constexpr double  round_off = 1e-9;
    const OwnStrength soil      = own_strength(p.materials);
    Ranges            ranges(warnings);
    for (const WallParameters &wall : p.walls)
      {
        const std::string path  = "Walls/" + wall.name + "/";
        const bool        given = wall.friction() > 0. || wall.adhesion > 0.;
        check_penalty_factor(path, wall.penalty_factor, ranges);
        if (wall.type != WallType::frictional)
          {
            if (given)
              warnings.push_back(
                path +
                (wall.adhesion > 0.         ? "Adhesion"
                 : wall.friction_angle > 0. ? "Friction angle"
                                            : "Friction coefficient") +
                " is not used with Type = " + name_of(wall.type));
            continue;
          }
        if (!given)
          warnings.push_back(path + "Friction coefficient, Friction angle and "
                                    "Adhesion are 0: the soil slides freely");
        const std::string name =
          path + (wall.friction_angle > 0. ? "Friction angle"
                                           : "Friction coefficient");
        ranges.check(
          name + " (tangent)", wall.friction(), 0., 1.2, "", "soils have");
        std::ostringstream text;
        if (soil.tan_phi && wall.friction() > *soil.tan_phi * (1. + round_off))
          text << name << " makes " << wall.friction()
               << ", more than the tangent of the soil's own angle, "
               << *soil.tan_phi << ": the soil will shear above the wall";
        else if (soil.cohesion &&
                 wall.adhesion > *soil.cohesion * (1. + round_off))
          text << path << "Adhesion is " << wall.adhesion
               << " kPa, more than the soil's own, " << *soil.cohesion
               << " kPa: the soil will shear above the wall";
        if (!text.str().empty())
          warnings.push_back(text.str());
      }
  }


  template <int dim>
  void
  warn_of_walls(const Case<dim> &the_case, std::vector<std::string> &warnings)
  {
    const std::vector<WallParameters> &walls = the_case.parameters.walls;
    for (const unsigned int w : the_case.idle_walls)
      warnings.push_back("Walls/" + walls[w].name +
                         ": no soil touches it at the start");
    for (const WallParameters &wall : walls)
      if (wall.type == WallType::frictional &&
          (faces_along_walls(the_case.grid, {wall}).closed &
           the_case.fixities.closed_faces()) != 0)
        warnings.push_back("Walls/" + wall.name +
                           " lies along a face whose nodes a boundary "
                           "condition holds: soil stops a cell before it, and "
                           "does not slide as it says");
    for (const WallParameters &wall : walls)
      if (wall.type == WallType::frictional &&
          is_along_grid_line(the_case.grid, wall))
        {
          std::ostringstream text;
          text << "Walls/" << wall.name
               << " lies along a line of the grid, whose nodes beyond it "
                  "nothing holds: soil that rests on it will settle and not "
                  "come to rest. Shift Grid/Lower corner and Upper corner by "
                  "half a cell, "
               << 0.5 * the_case.grid.cell_size() << " m, across the wall";
          warnings.push_back(text.str());
        }
  }


  template void
  warn_of_walls(const Case<2> &, std::vector<std::string> &);
  template void
  warn_of_walls(const Case<3> &, std::vector<std::string> &);
} // namespace Waker
