// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/sizes.h>
#include <waker/base/text.h>
#include <waker/case/load_programmes.h>
#include <waker/case/parameters.h>
#include <waker/loads/water_level.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/particles/layer.h>

#include "long_step_checks.h"
#include "pore_water_checks.h"
#include "stiffness_checks.h"
#include <algorithm>
#include <limits>

namespace Waker
{
  namespace
  {
    std::string
    number(const double value)
    {
      return in_digits(value);
    }


    void
    check_length(const std::string         &path,
                 const std::vector<double> &values,
                 const unsigned int         length,
                 const std::string         &reason)
    {
      if (values.size() != length)
        throw UserError(path,
                        "has " + counted(values.size(), "number"),
                        std::to_string(length) + " numbers (" + reason + ")" +
                          decimals_with_a_point);
    }


    /// Far beyond these, products of densities are no numbers.
    void
    check_density(const MaterialParameters &material,
                  const GravityParameters  &gravity)
    {
      constexpr double least = 1e-9, largest = 1e9; // Mg/m^3
      const double     g       = gravity.density_acceleration();
      const double     density = material.unit_weight / g;
      if (density >= least && density <= largest)
        return;
      const bool odd_gravity = !(g >= 1e-3 && g <= 1e6);
      throw UserError(odd_gravity
                        ? "Gravity/Acceleration"
                        : "Materials/" + material.name + "/Unit weight",
                      "is " + number(odd_gravity ? g : material.unit_weight) +
                        ": the material \"" + material.name +
                        "\" would have a density of " + number(density) +
                        " Mg/m^3",
                      "unit weight divided by acceleration from 1e-9 to 1e9 "
                      "Mg/m^3");
    }


    void
    check_layer(const LayerParameters                 &layer,
                const std::vector<MaterialParameters> &materials,
                const unsigned int                     dim)
    {
      const std::string path = "Soil profile/" + layer.name + "/";
      std::string       names;
      bool              known = false;
      for (const MaterialParameters &material : materials)
        {
          known = known || material.name == layer.material;
          names += (names.empty() ? "" : ", ") + material.name;
        }
      if (!known)
        throw UserError(path + "Material",
                        "there is no material \"" + layer.material + "\"",
                        "one of " + names);

      if (!layer.extent.empty())
        {
          if (dim == 2)
            throw UserError(path + "Extent",
                            "is given in two dimensions",
                            "only with Dimension = 3");
          check_length(path + "Extent", layer.extent, 2, "from z to z");
          if (!(layer.extent[0] < layer.extent[1]))
            throw UserError(path + "Extent",
                            "reaches from " + number(layer.extent[0]) + " to " +
                              number(layer.extent[1]) + " m",
                            "the smaller number first");
        }
      if (dim == 2 && !(layer.top.empty() && layer.bottom.empty()))
        throw UserError(path + (layer.top.empty() ? "Bottom" : "Top"),
                        "is given in two dimensions",
                        "only with Dimension = 3");
      layer.velocity_components(dim);
      layer.stress_components(dim);
      layer.corners();
    }


    void
    check_water(const WaterParameters              &water,
                const std::vector<LayerParameters> &layers,
                const GridParameters               &grid,
                const unsigned int                  dim)
    {
      water.check();
      if (!water.stands())
        return;
      const double z_begin = grid.lower_corner.back();
      const double z_end   = grid.upper_corner.back();
      const double crest =
        drawn_crest(layers, dim, z_begin, z_end, grid.cell_size);
      double base = std::numeric_limits<double>::max();
      for (const LayerParameters &layer : layers)
        base = std::min(base, level_range(layer, z_begin, z_end)[0]);
      // It would load nothing, and the soil would have no width there.
      if (water.level < base)
        throw UserError("Water/Level",
                        "is " + number(water.level) +
                          " m, below all soil, which begins at " +
                          number(base) + " m",
                        "at least " + number(base) +
                          " m (or Water/Side = none)");
      // The detected surface may lie a little higher than the drawn one.
      if (water.level >= crest)
        throw UserError("Water/Level",
                        "is " + number(water.level) +
                          " m, not below the crest at " + number(crest) + " m",
                        "less than " + number(crest) +
                          " m (or Water/Side = none)");
      // Nor may the water, which need not begin at this level. (Where the
      // detected surface is lower, the case says so.)
      const double at_start = WaterLevel(water).at(0.);
      if (at_start >= crest)
        throw UserError("Water/Rise",
                        "puts the water at " + number(at_start) +
                          " m at the start, not below the crest at " +
                          number(crest) + " m: the dyke is flooded",
                        "a level at t = 0, Level + Rise, of less than " +
                          number(crest) + " m (or Water/Side = none)");
    }
  } // namespace


  void
  GridParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Lower corner",
                      lower_corner,
                      "Lower corner x, y[, z] of the box (m) in which soil may "
                      "move; y is vertical. Leave room for the slide.",
                      Patterns::List(Patterns::Double(), 2, 3));
    prm.add_parameter("Upper corner",
                      upper_corner,
                      "Upper corner x, y[, z] of the box (m), a whole number "
                      "of cells from the lower one.",
                      Patterns::List(Patterns::Double(), 2, 3));
    prm.add_parameter("Cell size",
                      cell_size,
                      "Edge length h of the square (cubic) cells (m), above 0. "
                      "With softening, results depend on it.",
                      Patterns::Double(0.));
  }


  void
  GridParameters::check(const unsigned int dim) const
  {
    const std::string reason = "Dimension = " + std::to_string(dim);
    check_length("Grid/Lower corner", lower_corner, dim, reason);
    check_length("Grid/Upper corner", upper_corner, dim, reason);
    if (!(cell_size > 0.))
      throw UserError("Grid/Cell size",
                      "is " + number(cell_size) + " m",
                      "a length above 0");
    for (unsigned int d = 0; d < dim; ++d)
      if (!(upper_corner[d] - lower_corner[d] > 0.5 * cell_size))
        throw UserError("Grid/Upper corner",
                        "in direction " + std::string(1, "xyz"[d]) +
                          " the box reaches from " + number(lower_corner[d]) +
                          " to " + number(upper_corner[d]) + " m: no cell",
                        "above the lower corner in each direction");

    // Before anything else is measured by the box. The grid itself sees to its
    // memory.
    double unknowns = dim;
    for (unsigned int d = 0; d < dim; ++d)
      unknowns *= (upper_corner[d] - lower_corner[d]) / cell_size + 3.;
    checked_count("Grid/Cell size",
                  unknowns,
                  "unknowns on the grid",
                  2147483647.,
                  "larger cells, or a smaller box");
  }


  double
  GridParameters::longest_side() const
  {
    double longest = 0.;
    for (std::size_t d = 0; d < lower_corner.size(); ++d)
      longest = std::max(longest, upper_corner[d] - lower_corner[d]);
    return longest;
  }


  void
  StrengthReductionParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Lower factor",
                      lower_factor,
                      "A factor (-) by which strengths can be divided without "
                      "failure, above 0.",
                      Patterns::Double(0.));
    prm.add_parameter("Upper factor",
                      upper_factor,
                      "A factor (-) with which the dyke fails, above the lower "
                      "one.",
                      Patterns::Double(0.));
    prm.add_parameter("Tolerance",
                      tolerance,
                      "The search by halving ends when the bracket is at most "
                      "this wide (-), above 0.",
                      Patterns::Double(0.));
    add_choice(prm,
               "Reading",
               reading,
               "What initial failure is read off: displacement of a "
               "body, which sees every slide; width or height, which "
               "may miss some; width, the thesis's; or any, whichever "
               "of the first two comes first. Limits: section \"Initial "
               "failure\".");
  }


  void
  StrengthReductionParameters::check() const
  {
    require_positive("Strength reduction/Lower factor", lower_factor);
    if (!(upper_factor > lower_factor))
      throw UserError("Strength reduction/Upper factor",
                      "is " + number(upper_factor) + ", the lower factor " +
                        number(lower_factor),
                      "above the lower factor");
    require_positive("Strength reduction/Tolerance", tolerance);
    checked_count("Strength reduction/Tolerance",
                  (upper_factor - lower_factor) / tolerance,
                  "steps between the two factors",
                  1e6,
                  "a larger tolerance");
  }


  void
  RankParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Largest imbalance",
                      largest_imbalance,
                      "One realisation on several ranks: material points of "
                      "the rank that has most, over the mean of all ranks (-), "
                      "at least 1. Above it the points are dealt out anew, "
                      "which is looked at every 20 steps.",
                      Patterns::Double(1.));
  }


  void
  RankParameters::check() const
  {
    if (!(largest_imbalance >= 1.) || !std::isfinite(largest_imbalance))
      throw UserError("Ranks/Largest imbalance",
                      "is " + number(largest_imbalance),
                      "a finite number, at least 1");
  }


  void
  Parameters::check() const
  {
    if (dimension != 2 && dimension != 3)
      throw UserError("Dimension", "is " + std::to_string(dimension), "2 or 3");
    grid.check(dimension);
    if (points.points_per_direction == 0)
      throw UserError("Material points/Points per direction",
                      "is 0",
                      "at least 1");

    if (materials.empty())
      throw UserError("Materials/Names",
                      "there is no material",
                      "the names of the materials, separated by commas");
    for (const MaterialParameters &material : materials)
      {
        material.check(dimension, grid.cell_size);
        if (material.regularisation == Regularisation::nonlocal &&
            material.softens())
          material.nonlocal.check_used("Materials/" + material.name + "/",
                                       grid.cell_size /
                                         points.points_per_direction,
                                       grid.longest_side());
      }

    if (layers.empty())
      throw UserError("Soil profile/Layers",
                      "there is no layer",
                      "the names of the layers, separated by commas");
    for (const LayerParameters &layer : layers)
      {
        check_layer(layer, materials, dimension);
        if (gravity.initial_stress && !layer.initial_stress.empty())
          throw UserError("Soil profile/" + layer.name + "/Initial stress",
                          "is given, but the gravity step sets the stress",
                          "nothing, or Gravity/Initial stress = false");
      }

    for (const FixityParameters &fixity : fixities)
      fixity.check(dimension);
    gravity.check();
    for (const MaterialParameters &material : materials)
      check_density(material, gravity);
    if (gravity.initial_stress && fixities.empty() && walls.empty())
      throw UserError("Boundary conditions/Names",
                      "no boundary condition carries the soil, so the static "
                      "step for the initial stress has no solution",
                      "at least one, or Gravity/Initial stress = false");
    check_water(water, layers, grid, dimension);
    check_pore_water(*this);
    for (const TractionParameters &traction : tractions)
      traction.check(dimension, mapping.functions);
    for (const PointLoadParameters &load : point_loads)
      load.check(dimension);
    check_load_programmes(*this);
    for (const WallParameters &wall : walls)
      wall.check(dimension);
    if (!walls.empty())
      require_implicit(time, "there are walls off the grid");
    outflow.open_faces(dimension);
    for (const OutletParameters &outlet : outlets)
      outlet.check(dimension);
    for (const InflowParameters &inflow : inflows)
      inflow.check(dimension);

    surface.check();
    mapping.check();
    time.check();
    check_time_scheme(time, gravity, mapping);
    check_long_steps(*this);
    check_stiffness(*this);
    newton.check();
    initial_failure.check();
    sliding.check();
    stop.check();
    strength_reduction.check();
    ranks.check();
    output.check();
    check_initial_stress(*this);
  }
} // namespace Waker
