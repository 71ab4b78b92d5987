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
    const char *const of_loads    = "pore pressure of loads";
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
      "the ground, and stresses are total. Heads that differ from it deeper "
      "down: sections Head lines and Reference lines.",
      Patterns::Anything());
    prm.add_parameter(
      "Daily phreatic line",
      daily_phreatic_line,
      "The line, like that, under which the soil consolidated: it decides on "
      "daily_vertical_stress, for strengths that follow from stresses "
      "(Materials/<name>/Strength from), and with Initial stress/Daily stage "
      "on the stress of that stage; on nothing else. Empty: the same line.",
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
      "ascending, a millimetre apart at least. Between two levels the height of the line is "
      "interpolated at each x; below the first it is the first line, above the "
      "last the last. It follows at once, step by step, or with a Delay. "
      "Weights, materials and strengths stay those of the line at the start.",
      Patterns::Anything());
    prm.add_parameter(
      "Delay",
      delay,
      "With Lines by level: how long the line takes to follow (s), at least 0. "
      "The level that it follows nears the level outside as exp(-t/delay); it "
      "begins in balance. A number, or a table \"x: delay, x: delay, "
      "...\" (m, s) with 0 at the outer slope and more towards the inside; "
      "between two places what has arrived is interpolated, beyond them it is "
      "constant.",
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


  bool
  PoreWaterParameters::anything_follows_water() const
  {
    return follows_water() || std::any_of(head_lines.begin(),
                                          head_lines.end(),
                                          [](const HeadLineParameters &line) {
                                            return line.follows_water();
                                          });
  }


  FollowingLine
  PoreWaterParameters::following() const
  {
    return FollowingLine(lines(), LineDelay(delay, "Pore water/Delay"));
  }


  PhreaticLines
  PoreWaterParameters::lines() const
  {
    if (follows_water())
      return PhreaticLines(lines_by_level, "Pore water/Lines by level");
    return PhreaticLines(
      PhreaticLine(phreatic_line, "Pore water/Phreatic line"));
  }


  std::string
  PoreWaterParameters::name_of_line_at(const double x, const double y) const
  {
    const std::string phreatic = follows_water() ? "Pore water/Lines by level"
                                                 : "Pore water/Phreatic line";
    const auto        named    = [&](const std::string &head_line) {
      return tidy(head_line).empty() ? phreatic
                                               : "Head lines/" + tidy(head_line);
    };
    // As Heads::at().
    std::string over;
    for (const unsigned int i : from_top_to_bottom(reference_lines))
      {
        const ReferenceLineParameters &line = reference_lines[i];
        if (y >= line.place().height(x))
          {
            if (over.empty())
              return phreatic;
            const std::string under = named(line.top_head_line);
            return over == under ? over : over + " and " + under;
          }
        over = named(line.bottom_head_line);
      }
    return over.empty() ? phreatic : over;
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
    for (HeadLineParameters &line : daily.head_lines)
      line = line.of_the_daily_water();
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
    following();
    PhreaticLine(daily_phreatic_line, "Pore water/Daily phreatic line");
    for (const HeadLineParameters &line : head_lines)
      line.check();
    for (const ReferenceLineParameters &line : reference_lines)
      line.check();
  }


  namespace
  {
    /// Number of a line of heads: 0 for the phreatic one.
    unsigned int
    number_of(const std::string                     &name,
              const std::vector<HeadLineParameters> &lines)
    {
      if (tidy(name).empty())
        return 0;
      for (unsigned int i = 0; i < lines.size(); ++i)
        if (lines[i].name == tidy(name))
          return i + 1;
      AssertThrow(false, ExcMessage("no head line " + name));
      return 0;
    }
  } // namespace


  template <int dim>
  PoreWater<dim>::PoreWater(const PoreWaterParameters &parameters,
                            const double               unit_weight,
                            const std::vector<bool>   &of_effective_stress,
                            const double               level)
    : heads_at_start({}, {})
    , unit_weight(unit_weight)
    , largest_suction(parameters.largest_suction)
    , pressure_of(parameters.pressure_of)
    , takes_part(of_effective_stress)
  {
    if (!parameters.is_there())
      return;
    lines.push_back(parameters.following());
    for (const HeadLineParameters &line : parameters.head_lines)
      lines.push_back(line.following());
    for (const unsigned int i : from_top_to_bottom(parameters.reference_lines))
      {
        const ReferenceLineParameters &line = parameters.reference_lines[i];
        references.push_back(
          {line.place(),
           number_of(line.top_head_line, parameters.head_lines),
           number_of(line.bottom_head_line, parameters.head_lines)});
      }
    heads_at_start = heads(start(level));
    line_at_start  = heads_at_start.phreatic();
  }


  template <int dim>
  PoreWaterRecord
  PoreWater<dim>::start(const double level) const
  {
    PoreWaterRecord record;
    record.level = level;
    for (const FollowingLine &line : lines)
      record.arrived.push_back(line.delay().start(level));
    return record;
  }


  template <int dim>
  void
  PoreWater<dim>::follow(const double     level,
                         const double     dt,
                         PoreWaterRecord &record) const
  {
    for (std::size_t i = 0; i < lines.size(); ++i)
      lines[i].delay().follow(record.level, level, dt, record.arrived[i]);
    record.level = level;
  }


  template <int dim>
  double
  PoreWater<dim>::time_to_settle() const
  {
    constexpr double n_delays = 7.; // exp(-7) = 0.0009
    double           largest  = 0.;
    for (const FollowingLine &line : lines)
      if (line.moves())
        largest = std::max(largest, line.delay().largest());
    return n_delays * largest;
  }


  template <int dim>
  Heads
  PoreWater<dim>::heads(const PoreWaterRecord &outside) const
  {
    std::vector<PhreaticLine> now;
    for (std::size_t i = 0; i < lines.size(); ++i)
      now.push_back(lines[i].at(outside.arrived[i]));
    std::vector<Heads::Reference> with_heads;
    for (const Reference &r : references)
      with_heads.push_back({r.line, now[r.above], now[r.below]});
    return Heads(now.front(), with_heads);
  }


  template <int dim>
  double
  PoreWater<dim>::pressure(const Heads &heads, const Point<dim> &x) const
  {
    return std::max(unit_weight * (heads.at(x[0], x[1]) - x[1]),
                    -largest_suction);
  }


  template <int dim>
  double
  PoreWater<dim>::pressure(const Point<dim> &x) const
  {
    return pressure(heads_at_start, x);
  }


  template <int dim>
  void
  PoreWater<dim>::record(MaterialPoints<dim>   &points,
                         const PoreWaterRecord &outside) const
  {
    if (empty())
      return;
    const Heads          now    = heads(outside);
    std::vector<double> &values = points.scalar(scalar_name);
    for (std::size_t p = 0; p < points.n_points(); ++p)
      values[p] = pressure(now,
                           pressure_of == PorePressureOf::place
                             ? points.position[p]
                             : points.initial_position[p]);
    // It belongs to the soil.
    if (const int i = points.find_scalar(of_loads); i >= 0)
      for (std::size_t p = 0; p < points.n_points(); ++p)
        values[p] += points.scalars[i].values[p];
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
