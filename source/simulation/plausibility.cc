// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/expression.h>
#include <waker/base/text.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/nodes/fixity_conflicts.h>
#include <waker/particles/layer_gaps.h>
#include <waker/simulation/plausibility.h>

#include "prismatic_warnings.h"
#include "strange_b_bar.h"
#include "strange_cam_clay.h"
#include "strange_pore_water.h"
#include "strange_strengths.h"
#include "strange_water.h"
#include "toe_warnings.h"
#include "uplift_warnings.h"
#include "wall_warnings.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// Stiffnesses in one cell that differ by more leave marks in the stress
    /// when loads change.
    constexpr double smallest_ratio = 1.5;


    /// A phreatic line above the ground, with no water on it.
    template <int dim>
    void
    check_line(const Case<dim> &the_case, std::vector<std::string> &warnings)
    {
      const Parameters &p      = the_case.parameters;
      bool              is_wet = false;
      for (const TractionParameters &traction : p.tractions)
        is_wet = is_wet || traction.kind == TractionKind::hydrostatic;
      const MaterialPoints<dim> &points = the_case.initial_points;
      if (the_case.pore_water.empty() || is_wet || points.n_points() == 0)
        return;
      // Where water stands it may: up to the crest.
      const WaterSideOfCrest<dim> water_side(the_case);
      const auto                  stands_at = [&](const double x) {
        return p.water.stands() && water_side.holds(x);
      };
      double most = 0., at = 0.;
      for (std::size_t q = 0; q < points.n_points(); ++q)
        {
          const Point<dim> &x = points.initial_position[q];
          if (stands_at(x[0]))
            continue;
          const double ground = x[1] + the_case.ground.depths()
                                         .at(x, the_case.layers_of_points[q])
                                         .below_surface;
          const double above = the_case.pore_water.line().height(x[0]) - ground;
          if (above > most)
            {
              most = above;
              at   = x[0];
            }
        }
      std::ostringstream text;
      text << "Pore water/Phreatic line lies " << most
           << " m above the ground at x = " << at
           << " m, and no water stands there: the soil will boil";
      if (most > 0.5 * p.grid.cell_size)
        warnings.push_back(text.str());
    }


    /// A polygon that cuts off what a height map has beyond it.
    void
    check_maps(const LayerParameters    &layer,
               const LayerBody          &body,
               std::vector<std::string> &warnings)
    {
      double low = body.corners[0][1], high = low;
      for (const auto &corner : body.corners)
        {
          low  = std::min(low, corner[1]);
          high = std::max(high, corner[1]);
        }
      const double       round_off = 1e-6 * (high - low);
      std::ostringstream text;
      text << "Soil profile/" << layer.name << "/";
      if (body.top != nullptr && body.top->range()[1] > high + round_off)
        text << "Top rises to " << body.top->range()[1]
             << " m, but Polygon ends at " << high;
      else if (body.bottom != nullptr &&
               body.bottom->range()[0] < low - round_off)
        text << "Bottom falls to " << body.bottom->range()[0]
             << " m, but Polygon begins at " << low;
      else
        return;
      text << " m: the layer is cut there";
      warnings.push_back(text.str());
    }


    constexpr double usual_traction = 1000.; // kPa
    constexpr double usual_weights  = 5.;    // of all soil


    /// The largest that the numbers of a traction become (kPa), of those that
    /// are the same everywhere; at some times from the start to the end.
    double
    largest_value(const TractionParameters &traction, const double end_time)
    {
      double largest = 0.;
      if (traction.kind == TractionKind::hydrostatic)
        return largest;
      for (const std::string &part : split(traction.value, ';'))
        {
          const Expression<3>    value(part,
                                    "Tractions/" + traction.name + "/Value");
          constexpr unsigned int n = 8;
          for (unsigned int i = 0; value.is_uniform() && i <= n; ++i)
            largest =
              std::max(largest,
                       std::abs(value.value(Point<3>(), end_time * i / n)));
        }
      return largest;
    }


    /// Of loads in their units: kPa, and weights of the soil.
    template <int dim>
    void
    check_loads(const Case<dim> &the_case, std::vector<std::string> &warnings)
    {
      const Parameters &p      = the_case.parameters;
      double            weight = 0.; // kN
      for (const double mass : the_case.initial_points.mass)
        weight += mass * p.gravity.density_acceleration();
      const auto compare = [&](const std::string &path,
                               const std::string &of,
                               const double       force) {
        if (!(force > usual_weights * weight))
          return;
        std::ostringstream text;
        text << path << ": " << of << " is " << force << " kN, "
             << force / weight << " times the weight of all soil, " << weight
             << " kN; loads usually have up to " << usual_weights;
        warnings.push_back(text.str());
      };

      for (std::size_t i = 0; i < p.tractions.size(); ++i)
        {
          const TractionParameters &traction = p.tractions[i];
          const std::string         path     = "Tractions/" + traction.name;
          const auto               &start    = the_case.initial_tractions[i];
          const double              mean =
            start.measure > 0. ? start.force.norm() / start.measure : 0.;
          const double largest =
            std::max(mean, largest_value(traction, p.time.end_time));
          if (largest > usual_traction)
            {
              std::ostringstream text;
              text << path
                   << (traction.kind == TractionKind::hydrostatic ? ""
                                                                  : "/Value")
                   << " is " << largest << " kPa; loads on soil have up to "
                   << usual_traction << " kPa";
              warnings.push_back(text.str());
            }
          compare(path, "its resultant at t = 0", start.force.norm());
        }
      for (const PointLoadParameters &load : p.point_loads)
        {
          double square = 0.;
          for (const double component : load.force)
            square += component * component;
          compare("Point loads/" + load.name + "/Force",
                  "its size",
                  std::sqrt(square));
        }
    }
  } // namespace


  template <int dim>
  std::vector<std::string>
  strange_things(const Case<dim> &the_case)
  {
    const Parameters        &p        = the_case.parameters;
    std::vector<std::string> warnings = strange_parameters(p);
    const double             h        = the_case.grid.cell_size();
    check_strengths_of_points(the_case, warnings);
    check_line(the_case, warnings);
    warn_of_b_bar(the_case, warnings);
    warn_of_soil_in_water(the_case, warnings);
    warn_of_consolidation(the_case, warnings);
    warn_of_unsupported_water(the_case, warnings);
    warn_of_level_ground(the_case, warnings);
    warn_of_uplift_to_come(the_case, warnings);
    warn_of_feather_edge(the_case, warnings);
    check_loads(the_case, warnings);
    warn_of_walls(the_case, warnings);
    const double cells =
      chosen_courant_number(p.time, the_case.materials, h).value_or(0.);
    if (cells > 20.)
      {
        std::ostringstream text;
        text << "Time stepping/Time step is " << p.time.time_step
             << " s: waves cross " << std::round(cells)
             << " cells in a step; a smaller one is more accurate, and "
                "converges better";
        warnings.push_back(text.str());
      }

    double fastest = 0.;
    for (const Tensor<1, dim> &v : the_case.initial_points.velocity)
      fastest = std::max(fastest, v.norm());
    if (scheme_traits(p.time).is_implicit && fastest * p.time.time_step > h)
      {
        std::ostringstream text;
        text << "Soil profile: soil begins at " << fastest
             << " m/s and crosses " << fastest * p.time.time_step / h
             << " cells in the first time step";
        warnings.push_back(text.str());
      }

    for (std::size_t l = 0; l < p.layers.size(); ++l)
      check_maps(p.layers[l], the_case.ground.depths().bodies()[l], warnings);
    for (const BodyGap &gap :
         body_gaps(the_case.ground.depths().bodies(), 0.5 * p.grid.cell_size))
      {
        std::ostringstream text;
        text << "Soil profile: between " << p.layers[gap.lower].name << " and "
             << p.layers[gap.upper].name << " above it there is a gap of up to "
             << gap.height << " m over " << gap.area << " m^2, around ("
             << gap.middle[0] << ", " << gap.middle[1] << ", " << gap.middle[2]
             << ") m; layers usually touch";
        warnings.push_back(text.str());
      }

    for (const std::string &text :
         prismatic_warnings(p, the_case.ground.depths().bodies()))
      warnings.push_back(text);
    for (const std::string &text : fixity_conflicts(the_case.grid, p.fixities))
      warnings.push_back(text);

    unsigned int n_failures = 0;
    for (const StageReport &stage : the_case.stages)
      n_failures += stage.gravity.strong_failures +
                    (stage.balance ? stage.balance->strong_failures : 0);
    if (n_failures > 0)
      warnings.push_back(
        "Initial stress: multigrid could not be set up in " +
        std::to_string(n_failures) +
        " solve(s): conjugate gradients went on with the diagonal, which takes "
        "more iterations to the same result");

    const MixedCells &mixed = the_case.gravity_report.mixed_cells;
    if (mixed.ratio >= smallest_ratio)
      {
        std::ostringstream text;
        text << "Soil profile: " << mixed.n_points << " points lie in "
             << mixed.n_cells << " cells of two stiffnesses, up to "
             << mixed.ratio
             << " times apart: when loads change, stresses there will differ "
                "by as much from point to point; joints on lines of the grid "
                "avoid it";
        warnings.push_back(text.str());
      }
    return warnings;
  }


  template std::vector<std::string>
  strange_things(const Case<2> &);
  template std::vector<std::string>
  strange_things(const Case<3> &);
} // namespace Waker
