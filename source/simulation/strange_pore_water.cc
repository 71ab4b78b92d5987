// SPDX-License-Identifier: LGPL-2.1-or-later
#include "strange_pore_water.h"

#include <waker/base/numbers.h>
#include <waker/base/places.h>
#include <waker/loads/water_level.h>

#include <algorithm>
#include <sstream>

namespace Waker
{
  namespace
  {
    constexpr double round_off = 1e-6; // kPa


    /// Two lines of heads, at t = 0.
    void
    warn_of_crossing(const HeadLineParameters &a,
                     const HeadLineParameters &b,
                     const double              level,
                     std::vector<std::string> &warnings)
    {
      const PhreaticLine one = a.lines().at(level), other = b.lines().at(level);
      std::vector<double> corners;
      for (const PhreaticLine *const line : {&one, &other})
        for (const auto &corner : line->all())
          corners.push_back(corner[0]);
      std::sort(corners.begin(), corners.end());
      double before = 0., at = 0.;
      for (const double x : corners)
        {
          const double now = one.height(x) - other.height(x);
          if (now * before < 0.)
            {
              const double where = at + (x - at) * before / (before - now);
              std::ostringstream text;
              text << "Head lines/" << a.name << " and " << b.name
                   << " cross at x = " << where << " m, at "
                   << one.height(where)
                   << " m: on one side of it water flows up, on the other down";
              warnings.push_back(text.str());
              return;
            }
          if (now != 0.)
            {
              before = now;
              at     = x;
            }
        }
    }


    /// A line that lags behind the water where that stands on the soil.
    void
    warn_of_delay(const Parameters &p, std::vector<std::string> &warnings)
    {
      const PoreWaterParameters &water = p.pore_water;
      if (!water.follows_water() ||
          std::none_of(p.materials.begin(),
                       p.materials.end(),
                       [](const MaterialParameters &m) {
                         return m.is_drained() && m.pore_fluid_stiffness == 0.;
                       }))
        return;
      const LineDelay delay = water.following().delay();
      const auto     &outer =
        p.water.side == WaterSide::right ? delay.all().back() : delay.all()[0];
      std::ostringstream text;
      text << "Pore water/Delay is " << outer[1]
           << " s on the outer side, too: there the water outside presses the "
              "grains together while it rises, and the soil boils when it "
              "falls; a table with 0 at the outer slope is usual";
      if (outer[1] > 0.)
        warnings.push_back(text.str());
    }


    void
    warn_of_locking(const Parameters         &p,
                    const MaterialParameters &m,
                    std::vector<std::string> &warnings)
    {
      constexpr double locks = 0.48, slow = 0.4975; // Poisson's ratios
      if (!(m.pore_fluid_stiffness > 0.))
        return;
      const double       ratio = m.undrained_poissons_ratio();
      std::ostringstream text;
      text << "Materials/" << m.name << "/Pore fluid stiffness is "
           << m.pore_fluid_stiffness
           << " kPa, so that the soil has an undrained Poisson's ratio of "
           << ratio << ": ";
      if (ratio > locks &&
          p.mapping.volumetric_strain == VolumetricStrain::standard)
        warnings.push_back(text.str() +
                           "cells lock, and the soil seems too strong; "
                           "Kinematics and mapping/Volumetric strain = B-bar");
      else if (ratio > slow)
        warnings.push_back(text.str() +
                           "steps take long to solve; 0.49 to 0.495 is as "
                           "undrained as soil needs to be");
    }


    /// Soil below the line of which no law says what its water does.
    template <int dim>
    void
    warn_of_no_law(const Case<dim>          &the_case,
                   std::vector<std::string> &warnings)
    {
      const MaterialPoints<dim>             &points = the_case.initial_points;
      const std::vector<MaterialParameters> &materials =
        the_case.parameters.materials;
      for (unsigned int m = 0; m < materials.size(); ++m)
        {
          if (materials[m].model != MaterialModel::linear_elastic)
            continue;
          std::size_t n    = 0;
          double      most = 0.;
          for (std::size_t p = 0; p < points.n_points(); ++p)
            if (points.material[p] == m)
              {
                const double u =
                  the_case.pore_water.pressure(points.initial_position[p]);
                n += u > 0. ? 1 : 0;
                most = std::max(most, u);
              }
          std::ostringstream text;
          text << "Materials/" << materials[m].name << "/Model is "
               << name_of(materials[m].model) << ", but " << n
               << " of its points lie below the phreatic line, under up to "
               << most << " kPa: the law is one of total stress, without "
               << "strength, and knows nothing of the water";
          if (n > 0)
            warnings.push_back(text.str());
        }
    }
  } // namespace


  template <int dim>
  void
  warn_of_soil_in_water(const Case<dim>          &the_case,
                        std::vector<std::string> &warnings)
  {
    if (the_case.pore_water.empty())
      return;
    warn_of_no_law(the_case, warnings);
    if (!(the_case.parameters.gravity.acceleration > 0.))
      return;
    const MaterialPoints<dim> &points = the_case.initial_points;
    double                     least  = -round_off;
    Point<dim>                 at;
    std::size_t                n = 0;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const Point<dim> &x = points.initial_position[p];
        const double      stress =
          the_case.ground.at(x, the_case.layers_of_points[p]).vertical_stress;
        n += stress < -round_off ? 1 : 0;
        if (stress < least)
          {
            least = stress;
            at    = x;
          }
      }
    if (n == 0)
      return;
    std::ostringstream text;
    text << "Pore water: at " << n << " points the water carries more than "
         << "the soil above weighs, most at " << place_text(at) << " m, where "
         << the_case.parameters.pore_water.name_of_line_at(at[0], at[1])
         << " makes a pressure of " << the_case.pore_water.pressure(at)
         << " kPa and the effective vertical stress " << least
         << " kPa: the soil is lifted up";
    warnings.push_back(text.str());
  }


  void
  warn_of_pore_water(const Parameters &p, std::vector<std::string> &warnings)
  {
    const double level = WaterLevel(p.water).at(0.);
    const auto  &lines = p.pore_water.head_lines;
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        warn_of_crossing(lines[j], lines[i], level, warnings);
    warn_of_delay(p, warnings);
    for (const MaterialParameters &m : p.materials)
      warn_of_locking(p, m, warnings);
  }


  template void
  warn_of_soil_in_water(const Case<2> &, std::vector<std::string> &);
  template void
  warn_of_soil_in_water(const Case<3> &, std::vector<std::string> &);
} // namespace Waker
