// SPDX-License-Identifier: LGPL-2.1-or-later
#include "toe_warnings.h"

#include <waker/base/places.h>
#include <waker/loads/water_level.h>
#include <waker/mechanics/time_scheme.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

namespace Waker
{
  namespace
  {
    /// Of a slope of 1:3 on cells of half a metre, 8 s long: with 0.08 of the
    /// outermost cell filled the toe is calm, with 0.06 it boils; under 2.1
    /// times its strength it is calm, under 3.1 times it boils.
    constexpr double calm_fill = 0.07, calm_pressure = 2.5;

    /// Vertical lines in a cell, over whose soil its filling is averaged.
    constexpr unsigned int n_lines = 16;


    template <int dim>
    struct Toe
    {
      double     fill = 0.; // of the cell, -
      Point<dim> middle;    // of the soil in it
    };


    /// The soil of the profile in a cell whose lowest corner is `low`: its
    /// share, its middle, and whether there is soil right below.
    template <int dim>
    std::pair<Toe<dim>, bool>
    soil_in_cell(const SoilDepths<dim> &depths,
                 const Point<dim>      &low,
                 const double           h)
    {
      Toe<dim> toe;
      bool     has_soil_below = false;
      for (unsigned int i = 0; i < n_lines; ++i)
        {
          Point<dim> x = low;
          for (unsigned int d = 0; d < dim; ++d)
            x[d] += 0.5 * h;
          x[0] = low[0] + (i + 0.5) * h / n_lines;
          for (const auto &part : depths.column(x))
            {
              const double bottom = std::max(part.stretch.low, low[1]);
              const double top    = std::min(part.stretch.high, low[1] + h);
              has_soil_below =
                has_soil_below || part.stretch.low < low[1] - 1e-6 * h;
              if (!(top > bottom))
                continue;
              const double share = (top - bottom) / (h * n_lines);
              x[1]               = 0.5 * (top + bottom);
              toe.fill += share;
              toe.middle += share / toe.fill * (x - toe.middle);
            }
        }
      return {toe, has_soil_below};
    }


    /// The outermost soil at the side of the water that ends on the base below
    /// the level (m), in the plane at z.
    template <int dim>
    std::optional<Toe<dim>>
    find_toe(const Case<dim> &the_case, const double level, const double z)
    {
      const double      h     = the_case.grid.cell_size();
      const Point<dim> &lower = the_case.grid.lower_corner();
      const Point<dim> &upper = the_case.grid.upper_corner();
      const auto n = static_cast<int>(std::round((upper[0] - lower[0]) / h));
      const bool is_left = the_case.parameters.water.side == WaterSide::left;
      for (int i = 0; i < n; ++i)
        {
          Point<dim> low = lower;
          low[0] += h * (is_left ? i : n - 1 - i);
          if (dim == 3)
            low[dim - 1] = z;
          for (; low[1] < level; low[1] += h)
            {
              const auto [toe, has_soil_below] =
                soil_in_cell(the_case.ground.depths(), low, h);
              if (has_soil_below)
                return {};
              if (toe.fill > 0.)
                return toe;
            }
        }
      return {};
    }


    /// s_u (kPa) of the point nearest to a place; NaN if its law has none.
    template <int dim>
    double
    strength_at(const MaterialPoints<dim> &points, const Point<dim> &x)
    {
      const int number   = points.find_scalar("undrained shear strength");
      double    nearest  = std::numeric_limits<double>::infinity();
      double    strength = nan;
      for (std::size_t p = 0; number >= 0 && p < points.n_points(); ++p)
        {
          const double distance = points.initial_position[p].distance_square(x);
          if (distance < nearest)
            {
              nearest  = distance;
              strength = points.scalars[number].values[p];
            }
        }
      return strength > 0. ? strength : nan;
    }
  } // namespace


  template <int dim>
  void
  warn_of_feather_edge(const Case<dim>          &the_case,
                       std::vector<std::string> &warnings)
  {
    const Parameters &p = the_case.parameters;
    if (!p.water.stands() || !(p.water.minimum_support > 0.) ||
        !scheme_traits(p.time).has_inertia)
      return;
    const double h     = the_case.grid.cell_size();
    const double level = WaterLevel(p.water).at(0.);
    const double begin = dim == 3 ? the_case.grid.lower_corner()[dim - 1] : 0.;
    const double end =
      dim == 3 ? the_case.grid.upper_corner()[dim - 1] : 0.5 * h;
    std::optional<Toe<dim>> worst;
    double                  times = calm_pressure, strength = nan;
    for (double z = begin; z < end - 1e-6 * h; z += h)
      if (const auto toe = find_toe(the_case, level, z))
        {
          if (!(toe->fill < calm_fill))
            continue;
          const double own = strength_at(the_case.initial_points, toe->middle);
          const double now =
            p.water.unit_weight * (level - toe->middle[1]) / own;
          if (!(now > times))
            continue;
          times    = now;
          strength = own;
          worst    = toe;
        }
    if (!worst)
      return;
    std::ostringstream text;
    text.precision(3);
    text << "Soil profile: the toe ends under water in a feather edge on the "
            "base, at "
         << place_text(worst->middle) << " m, which fills " << worst->fill
         << " of its cell under " << times * strength << " kPa, " << times
         << " times its strength, " << strength
         << " kPa: such an edge boils, and the dyke may not come to rest. Not "
            "with "
         << calm_fill
         << " of the cell filled (Grid/Lower corner and Upper corner moved "
            "along x by part of the cell size), or with Water/Minimum support "
            "= 0; with smaller cells not as long";
    warnings.push_back(text.str());
  }


  template void
  warn_of_feather_edge(const Case<2> &, std::vector<std::string> &);
  template void
  warn_of_feather_edge(const Case<3> &, std::vector<std::string> &);
} // namespace Waker
