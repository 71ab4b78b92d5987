// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/loads/pore_water.h>
#include <waker/mapping/stencil.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    const char *const scalar_name = "pore pressure";
  } // namespace


  void
  PoreWaterParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Phreatic line",
      phreatic_line,
      "Corners \"x, y; x, y; ...\" (m), x ascending, of the line "
      "at which the pressure of the water in the ground is 0; "
      "in 3D the same along z. Below it the pressure is "
      "hydrostatic, with Water/Unit weight. It must reach over "
      "all soil; beyond its ends it is level. It stays as it "
      "is, whatever the water outside does. Empty: no water in "
      "the ground, and stresses are total.",
      Patterns::Anything());
    prm.add_parameter(
      "Daily phreatic line",
      daily_phreatic_line,
      "The line, like that, under which the soil consolidated: it decides on "
      "daily_vertical_stress, and on nothing else, for strengths that "
      "follow from stresses (Materials/<name>/Strength from). Empty: the "
      "same line.",
      Patterns::Anything());
    prm.add_parameter("Largest suction",
                      largest_suction,
                      "Suction (kPa) that the soil above the line has at most, "
                      "at least 0: it grows with the height above the line "
                      "like the pressure below it. 0: none.",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Lines by level",
      lines_by_level,
      "Instead of Phreatic line: lines that follow the water outside, "
      "\"level: x, y; x, y; ... | level: ...\", two or more, levels (m) "
      "ascending. Between two levels the height of the line is "
      "interpolated at each x; below the first it is the first line, above the "
      "last the last. It follows at once, step by step. Weights, materials "
      "and strengths stay those of the line at the start.",
      Patterns::Anything());
    add_choice(prm,
               "Pressure of",
               pressure_of,
               "What decides on the pressure in soil that moves: the place "
               "where it is, or the soil, which keeps the pressure of its "
               "place at the start.");
  }


  bool
  PoreWaterParameters::is_there() const
  {
    return !tidy(phreatic_line).empty() || follows_water();
  }


  bool
  PoreWaterParameters::follows_water() const
  {
    return !tidy(lines_by_level).empty();
  }


  PhreaticLines
  PoreWaterParameters::lines() const
  {
    if (follows_water())
      return PhreaticLines(lines_by_level, "Pore water/Lines by level");
    return PhreaticLines(
      PhreaticLine(phreatic_line, "Pore water/Phreatic line"));
  }


  PoreWaterParameters
  PoreWaterParameters::of_the_daily_water() const
  {
    PoreWaterParameters daily = *this;
    if (!tidy(daily_phreatic_line).empty())
      {
        daily.phreatic_line  = daily_phreatic_line;
        daily.lines_by_level = "";
      }
    return daily;
  }


  void
  PoreWaterParameters::check() const
  {
    if (!(largest_suction >= 0. && std::isfinite(largest_suction)))
      throw UserError("Pore water/Largest suction",
                      "is " + in_digits(largest_suction) + " kPa",
                      "at least 0");
    if (follows_water() && !tidy(phreatic_line).empty())
      throw UserError("Pore water/Lines by level",
                      "is there, and so is Phreatic line",
                      "one of them");
    lines();
    PhreaticLine(daily_phreatic_line, "Pore water/Daily phreatic line");
  }


  template <int dim>
  PoreWater<dim>::PoreWater(const PoreWaterParameters &parameters,
                            const double               unit_weight,
                            const std::vector<bool>   &of_effective_stress,
                            const double               level)
    : lines(parameters.lines())
    , line_at_start(lines.at(level))
    , unit_weight(unit_weight)
    , largest_suction(parameters.largest_suction)
    , pressure_of(parameters.pressure_of)
    , takes_part(of_effective_stress)
  {}


  template <int dim>
  double
  PoreWater<dim>::pressure(const PhreaticLine &line, const Point<dim> &x) const
  {
    return std::max(unit_weight * (line.height(x[0]) - x[1]), -largest_suction);
  }


  template <int dim>
  double
  PoreWater<dim>::pressure(const Point<dim> &x) const
  {
    return pressure(line_at_start, x);
  }


  template <int dim>
  void
  PoreWater<dim>::record(MaterialPoints<dim> &points, const double level) const
  {
    if (empty())
      return;
    const PhreaticLine   line   = lines.at(level);
    std::vector<double> &values = points.scalar(scalar_name);
    for (std::size_t p = 0; p < points.n_points(); ++p)
      values[p] = pressure(line,
                           pressure_of == PorePressureOf::place
                             ? points.position[p]
                             : points.initial_position[p]);
  }


  template <int dim>
  void
  PoreWater<dim>::add_nodal_forces(const MaterialPoints<dim> &points,
                                   const Weights<dim>        &weights,
                                   NodalVector               &force) const
  {
    if (empty())
      return;
    const std::vector<double> &values = points.scalar(scalar_name);
    const Stencil<dim>         stencil(weights.background_grid());
    for (std::size_t p = 0; p < points.n_points(); ++p)
      if (takes_part[points.material[p]] && values[p] != 0.)
        {
          Tensor<2, dim> P;
          for (unsigned int d = 0; d < dim; ++d)
            P[d][d] = points.volume[p] * values[p];
          stencil.scatter_gradient(weights[p], P, force.begin());
        }
  }


  template class PoreWater<2>;
  template class PoreWater<3>;
} // namespace Waker
