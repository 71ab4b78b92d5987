// SPDX-License-Identifier: LGPL-2.1-or-later
#include "strange_softening.h"

#include <waker/mechanics/nonlocal_average.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Waker
{
  namespace
  {
    void
    check_snap_back(const MaterialParameters &m,
                    const double              scale,
                    std::vector<std::string> &warnings)
    {
      constexpr double   near_by = 0.8, usual_pressure = 200.; // -, kPa
      const std::string  path = "Materials/" + m.name + "/";
      std::ostringstream text;
      switch (m.model)
        {
          case MaterialModel::linear_elastic:
            return;
          case MaterialModel::von_mises_softening:
            {
              const double limit =
                m.von_mises.snap_back_modulus(m.elastic, scale);
              if (-m.von_mises.softening_modulus < near_by * limit)
                return;
              text << path << "Softening modulus is "
                   << m.von_mises.softening_modulus
                   << " kPa, and points snap back from " << -limit
                   << " kPa on; within a fifth of that "
                   << (m.regularisation == Regularisation::nonlocal
                         ? "softening lags five steps or more behind"
                         : "Newton may not converge");
              break;
            }
          case MaterialModel::mohr_coulomb:
            {
              const double strain = m.mohr_coulomb.softening_strain;
              const double least =
                m.mohr_coulomb.snap_back_strain(m.elastic, scale, 0.);
              const double deep =
                m.mohr_coulomb.snap_back_strain(m.elastic,
                                                scale,
                                                usual_pressure);
              if (!(strain > 0.) || strain > deep)
                return;
              text << path << "Softening strain is " << strain
                   << ": points under a pressure (s_1 + s_3)/2 of more than "
                   << usual_pressure * (strain - least) / (deep - least)
                   << " kPa lose their friction at once (snap-back)";
              break;
            }
          case MaterialModel::modified_cam_clay:
            return; // see warn_of_cam_clay()
        }
      warnings.push_back(text.str());
    }


    void
    check_nonlocal(const MaterialParameters &m,
                   const double              spacing,
                   const GridParameters     &grid,
                   std::vector<std::string> &warnings)
    {
      const std::string path = "Materials/" + m.name + "/";
      const double      l    = m.nonlocal.length;
      const auto        warn = [&](const std::ostringstream &text) {
        warnings.push_back(text.str());
      };
      if (l < (2. - 1e-9) * spacing)
        {
          std::ostringstream text;
          text << path << "Averaging length is " << l << " m, only "
               << l / spacing
               << " times the distance between points: slip surfaces are as "
                  "wide as the cells let them; from twice that on they are not";
          warn(text);
        }
      if (m.nonlocal.over_weight == 1.)
        {
          std::ostringstream text;
          text << path
               << "Over-weight is 1: slip surfaces may still narrow with the "
                  "cells; 2 is usual";
          warn(text);
        }
      const std::size_t dim    = grid.lower_corner.size();
      double            in_box = 1.; // points, of soil everywhere
      for (std::size_t d = 0; d < dim; ++d)
        in_box *= (grid.upper_corner[d] - grid.lower_corner[d]) / spacing;
      const double in_reach =
        std::min(in_box,
                 (dim == 2 ? 1. : 4. / 3.) * std::acos(-1.) *
                   std::pow(NonlocalAverage<2>::reach * l / spacing, dim));
      constexpr double many = 20000., most_of_it = 0.5;
      if (in_reach > many || in_reach > most_of_it * in_box)
        {
          std::ostringstream text;
          text << path << "Averaging length is " << l
               << " m: averages are over up to " << std::round(in_reach)
               << " points each, " << std::round(100. * in_reach / in_box)
               << " % of what the grid has room for, and steps take long";
          warn(text);
        }
    }
  } // namespace


  void
  check_softening(const MaterialParameters &m,
                  const GridParameters     &grid,
                  const unsigned int        points_per_direction,
                  std::vector<std::string> &warnings)
  {
    check_snap_back(m,
                    m.softening_measure(grid.cell_size).of_uniform_strain(),
                    warnings);
    if (m.regularisation == Regularisation::nonlocal && m.softens())
      check_nonlocal(m, grid.cell_size / points_per_direction, grid, warnings);
  }
} // namespace Waker
