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
        const double below = the_case.ground.depths()
                               .at(x, the_case.layers_of_points[q])
                               .below_surface;
        if (!(below < depth && x[1] + below < level))
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
    double longest = 0., end = 0., height = 0., length = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        Point<dim> x;
        x[0]       = low + (i + 0.5) * h / n_lines;
        double top = -std::numeric_limits<double>::infinity();
        for (const auto &part : the_case.ground.depths().column(x))
          top = std::max(top, part.stretch.high);
        length = std::abs(top - level) < near * h ? length + h / n_lines : 0.;
        if (length > longest)
          {
            longest = length;
            end     = x[0] + 0.5 * h / n_lines;
            height  = top;
          }
      }
    const double limit = p.initial_failure.limits.width_change;
    if (!(longest > limit))
      return;
    std::ostringstream text;
    text.precision(4);
    text << "Water/Level: W is measured at " << level
         << " m, and the ground is level there, at " << height
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
