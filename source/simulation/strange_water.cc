// SPDX-License-Identifier: LGPL-2.1-or-later
#include "strange_water.h"

#include <waker/base/last_change.h>
#include <waker/base/places.h>
#include <waker/base/time_function.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// A thousandth of a full node is as good as nothing.
    bool
    has_no_support(const WaterParameters &water)
    {
      return water.stands() && water.minimum_support < 1e-3;
    }
  } // namespace


  void
  warn_of_water(const Parameters &p, std::vector<std::string> &warnings)
  {
    if (p.surface.method == SurfaceMethod::contour &&
        !std::isnan(p.water.level) &&
        p.initial_failure.limits.width_change < p.grid.cell_size)
      {
        std::ostringstream text;
        text << "Initial failure/Width change: "
             << p.initial_failure.limits.width_change
             << " m, but on the contour the width moves in steps of up to a "
                "cell, "
             << p.grid.cell_size
             << " m, where a support domain passes the level";
        warnings.push_back(text.str());
      }
    if (has_no_support(p.water) && !p.pore_water.is_there())
      {
        std::ostringstream text;
        text << "Water/Minimum support: water may load nodes with hardly any "
                "soil ("
             << p.water.minimum_support
             << "; 0.01 is usual): the soil there may move for ever, or the "
                "dyke seem to fail";
        warnings.push_back(text.str());
      }
  }


  namespace
  {
    /// The highest level of the water (m), or infinity if nobody knows.
    double
    highest_level(const Parameters &p)
    {
      for (const LoadProgrammeParameters &programme : p.load_programmes)
        if (programme.drives == LoadTarget::water)
          return std::numeric_limits<double>::infinity();
      const TimeFunction rise(p.water.rise, "Water/Rise");
      if (rise.last_change() == LastChange::unknown)
        return std::numeric_limits<double>::infinity();
      return p.water.level + rise.value(rise.time_of_largest());
    }


    template <int dim>
    bool
    has_soil(const SoilDepths<dim> &depths, const Point<dim> &x)
    {
      const auto column = depths.column(x);
      return std::any_of(column.begin(), column.end(), [&](const auto &part) {
        return part.stretch.low <= x[1] && x[1] <= part.stretch.high;
      });
    }


    /// Of the soil on the vertical line through x (m).
    template <int dim>
    double
    top_of_soil(const SoilDepths<dim> &depths, const double x)
    {
      Point<dim> at;
      at[0]      = x;
      double top = -std::numeric_limits<double>::infinity();
      for (const auto &part : depths.column(at))
        top = std::max(top, part.stretch.high);
      return top;
    }
  } // namespace


  template <int dim>
  void
  warn_of_unsupported_water(const Case<dim>          &the_case,
                            std::vector<std::string> &warnings)
  {
    const Parameters          &p      = the_case.parameters;
    const MaterialPoints<dim> &points = the_case.initial_points;
    if (!has_no_support(p.water) || !p.pore_water.is_there() ||
        points.n_points() == 0)
      return;
    const double level = highest_level(p);
    const double depth =
      the_case.grid.cell_size() / p.points.points_per_direction;
    const WaterSideOfCrest<dim> water_side(the_case);
    std::vector<bool>           is_loaded(the_case.materials.size(), false);
    std::size_t                 n = 0, first = 0;
    for (std::size_t q = 0; q < points.n_points(); ++q)
      {
        const Point<dim>  &x = points.initial_position[q];
        const unsigned int m = points.material[q];
        if (the_case.materials[m]->is_of_effective_stress() ||
            !(x[1] < level) || !water_side.holds(x[0]))
          continue;
        // At the surface, but not below a feather edge of other soil; or at a
        // face that is steep.
        const Depths depths =
          the_case.ground.depths().at(x, the_case.layers_of_points[q]);
        const bool is_at_surface =
          depths.below_surface < depth &&
          depths.in_layer > depths.below_surface - 1e-6 * depth;
        Point<dim> outside = x;
        outside[0] += p.water.side == WaterSide::left ? -depth : depth;
        // Beyond the grid the soil goes on.
        outside[0] = std::clamp(outside[0],
                                the_case.grid.lower_corner()[0],
                                the_case.grid.upper_corner()[0]);
        if (!is_at_surface && has_soil(the_case.ground.depths(), outside))
          continue;
        is_loaded[m] = true;
        first        = n == 0 ? q : first;
        ++n;
      }
    if (n == 0)
      return;
    std::string names;
    for (unsigned int m = 0; m < is_loaded.size(); ++m)
      if (is_loaded[m])
        names += (names.empty() ? "" : ", ") + p.materials[m].name;
    std::ostringstream text;
    text << "Water/Minimum support: water may load nodes with hardly any soil ("
         << p.water.minimum_support
         << "), and it comes to soil of total stress (" << names << ", " << n
         << " points at its surface, as at "
         << place_text(points.initial_position[first])
         << " m): the soil there may move for ever, or the dyke seem to fail. "
            "0.01 is usual; drained soil with water in it needs 0: then let "
            "all soil that the water touches be drained";
    warnings.push_back(text.str());
  }


  template <int dim>
  void
  warn_of_level_ground(const Case<dim>          &the_case,
                       std::vector<std::string> &warnings)
  {
    const Parameters &p     = the_case.parameters;
    const double      level = the_case.measuring_level;
    // Of a foreland at the level of the water a warning of its own tells.
    if (dim != 2 || !std::isfinite(level) ||
        (p.water.stands() && !the_case.water_touches))
      return;
    constexpr unsigned int n_lines = 16;   // in a cell
    constexpr double       near    = 0.05; // cells: what soil soon settles
    const double           h       = the_case.grid.cell_size();
    const double           low     = the_case.grid.lower_corner()[0];
    const auto             n       = static_cast<unsigned int>(
      std::round((the_case.grid.upper_corner()[0] - low) * n_lines / h));
    const SoilDepths<dim> &depths  = the_case.ground.depths();
    double                 longest = 0., end = 0., length = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double x = low + (i + 0.5) * h / n_lines;
        length         = std::abs(top_of_soil(depths, x) - level) < near * h
                           ? length + h / n_lines
                           : 0.;
        if (length > longest)
          {
            longest = length;
            end     = x + 0.5 * h / n_lines;
          }
      }
    const double limit = p.initial_failure.limits.width_change;
    if (!(longest > limit))
      return;
    std::ostringstream text;
    text.precision(4);
    text << "Water/Level: W is measured at " << level
         << " m, and the ground is level there, at "
         << top_of_soil(depths, end - 0.5 * longest)
         << " m from x = " << end - longest << " to " << end
         << " m: where it sinks past the level W jumps by up to " << longest
         << " m, more than Initial failure/Width change, " << limit
         << " m, and a dyke at rest has failed. Another level, with Water/Rise "
            "from there, avoids it";
    warnings.push_back(text.str());
  }


  template void
  warn_of_unsupported_water(const Case<2> &, std::vector<std::string> &);
  template void
  warn_of_unsupported_water(const Case<3> &, std::vector<std::string> &);
  template void
  warn_of_level_ground(const Case<2> &, std::vector<std::string> &);
  template void
  warn_of_level_ground(const Case<3> &, std::vector<std::string> &);
} // namespace Waker
