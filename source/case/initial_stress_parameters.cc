// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/expression_pattern.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/case/parameters.h>

namespace Waker
{
  namespace
  {
    const char *const no_water   = "none";
    const char *const level_path = "Initial stress/Daily level";
    const char *const stage_path = "Initial stress/Daily stage";


    std::string
    quoted_from(const InitialStressParameters &in)
    {
      return std::string("Initial stress/From = ") + name_of(in.from) +
             ", Laws = " + name_of(in.laws) +
             ", Daily stage = " + (in.daily_stage ? "true" : "false");
    }
  } // namespace


  void
  InitialStressParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "From",
               from,
               "The stress before it is brought into balance. gravity: none, "
               "so that weight and water make all of it. K0: vertically the "
               "effective weight of the column of soil and water over a "
               "place, horizontally Materials/<name>/K0 times as much.");
    add_choice(prm,
               "Laws",
               laws,
               "How it is brought into balance, with the points in place. "
               "elastic: in one linear step; the stress may lie beyond the "
               "strength, and the run begins with its return. plastic: in load "
               "steps with the laws of the soil; strengths and plastic strains "
               "stay those of the start.");
    prm.add_parameter("Steps",
                      steps,
                      "Laws = plastic: load steps (-) of what is out of "
                      "balance, at least 1; those that do not converge are "
                      "halved.",
                      Patterns::Integer(1, 100000));
    prm.add_parameter("Daily stage",
                      daily_stage,
                      "Begin with the water of usual days: the stress under "
                      "Daily level and Pore water/Daily phreatic line, in "
                      "balance, is what the stress under the water at t = 0 "
                      "starts from. Drained soil keeps its effective stress, "
                      "soil with a law of total stress its total stress. "
                      "Tractions, point loads and load programmes come with "
                      "the second stage.",
                      Patterns::Bool());
    prm.add_parameter("Daily level",
                      daily_level,
                      "Level (m) of the water outside in the daily stage, on "
                      "the side of Water/Side, or none: no water stands there. "
                      "To be given if there is a daily stage and water "
                      "outside.",
                      Patterns::Anything());
  }


  std::optional<double>
  InitialStressParameters::level() const
  {
    return plain_number(daily_level);
  }


  void
  InitialStressParameters::check() const
  {
    if (steps == 0)
      throw UserError("Initial stress/Steps", "is 0", "at least 1");
    const std::string text = tidy(daily_level);
    if (!text.empty() && text != no_water && !plain_number(text))
      throw UserError(level_path,
                      "is " + in_quotes(text),
                      std::string("a finite number (m)") +
                        decimals_with_a_point + ", or " + no_water);
  }


  UserError
  in_daily_stage(const UserError &error)
  {
    // What stands in the file serves both stages, unless the water of the daily
    // stage has parameters of its own.
    if (error.where == "Water/Level")
      return UserError(level_path,
                       "is refused: in the daily stage Water/Level " +
                         error.problem,
                       error.allowed);
    if (error.where.rfind("Materials/", 0) == 0 ||
        error.where.rfind("Soil profile/", 0) == 0)
      return UserError(error.where,
                       error.problem + ", in the daily stage",
                       error.allowed);
    return UserError(stage_path,
                     "is refused: in the daily stage " + error.where + " " +
                       error.problem,
                     error.allowed);
  }


  Parameters
  daily_stage(const Parameters &p)
  {
    Parameters daily                     = p;
    daily.initial_stress.daily_stage     = false;
    daily.initial_stress.daily_level     = "";
    daily.pore_water                     = p.pore_water.of_the_daily_water();
    daily.pore_water.daily_phreatic_line = "";
    daily.water.rise                     = "0";
    if (const auto level = p.initial_stress.level())
      {
        daily.water.level      = *level;
        daily.water.level_text = in_digits(*level);
      }
    else
      daily.water.side = WaterSide::none;
    daily.tractions.clear();
    daily.point_loads.clear();
    daily.load_programmes.clear();
    daily.sliding.watch            = false;
    daily.stop.loads_constant_from = "unknown";
    return daily;
  }


  void
  check_initial_stress(const Parameters &p)
  {
    const InitialStressParameters &in = p.initial_stress;
    in.check();
    if (in.is_gravity_step())
      return;
    if (!p.gravity.initial_stress)
      throw UserError("Gravity/Initial stress",
                      "is false, but there is " + quoted_from(in),
                      "true, or the usual of section Initial stress");
    if (p.gravity.initial_share != 1.)
      throw UserError("Gravity/Initial share",
                      "is " + in_digits(p.gravity.initial_share) +
                        ", but there is " + quoted_from(in),
                      "1");
    if (p.mapping.strain == StrainMeasure::logarithmic)
      throw UserError("Kinematics and mapping/Strain",
                      "is logarithmic, which knows of no stress but that of "
                      "its strain, and there is " +
                        quoted_from(in),
                      "step, or the usual of section Initial stress");
    for (const MaterialParameters &material : p.materials)
      if (material.pore_fluid_stiffness > 0. &&
          (in.daily_stage || in.laws == BalanceLaws::plastic))
        throw UserError("Materials/" + material.name + "/Pore fluid stiffness",
                        "is " + in_digits(material.pore_fluid_stiffness) +
                          " kPa, whose excess pressure no stage carries, but "
                          "there is " +
                          quoted_from(in),
                        "0, or Initial stress/Laws = elastic without a daily "
                        "stage");
    if (in.from == StressFrom::k0 && !(p.gravity.acceleration > 0.))
      throw UserError("Initial stress/From",
                      "is K0, and Gravity/Acceleration is 0: nothing has a "
                      "weight",
                      "gravity, or an acceleration above 0");
    if ((in.from == StressFrom::k0 || in.daily_stage) && !p.inflows.empty())
      throw UserError(in.daily_stage ? stage_path : "Initial stress/From",
                      "is " + std::string(in.daily_stage ? "true" : "K0") +
                        ", but soil flows in (Inflow/" +
                        p.inflows.front().name +
                        "), of which no stress in the ground is known",
                      in.daily_stage ? "false" : "gravity");
    if (in.laws == BalanceLaws::plastic && !p.walls.empty())
      throw UserError("Initial stress/Laws",
                      "is plastic, but there is a wall off the grid (Walls/" +
                        p.walls.front().name +
                        "), whose tractions are not carried from load step to "
                        "load step",
                      "elastic, or boundary conditions instead of walls");
    if (!in.daily_stage)
      return;
    if (!p.walls.empty())
      throw UserError(stage_path,
                      "is true, but there is a wall off the grid (Walls/" +
                        p.walls.front().name +
                        "), whose tractions are not carried",
                      "false, or boundary conditions instead of walls");
    for (const TractionParameters &traction : p.tractions)
      if (traction.kind == TractionKind::hydrostatic)
        throw UserError(stage_path,
                        "is true, but there is a liquid (Tractions/" +
                          traction.name + "), of which no daily level is known",
                        "false, or the section Water instead of the traction");
    if (!p.pore_water.is_there() && !p.water.stands())
      throw UserError(stage_path,
                      "is true, but there is no water, outside or in the "
                      "ground",
                      "false, or Water/Side and Pore water/Phreatic line");
    const bool says_level = !tidy(in.daily_level).empty();
    if (p.water.stands() && !says_level)
      throw UserError(level_path,
                      "is empty, but there is a daily stage, and water stands "
                      "outside",
                      "its level (m) on usual days, or none");
    if (!p.water.stands() && in.level())
      throw UserError(level_path,
                      "is " + in_digits(*in.level()) +
                        " m, but Water/Side is none",
                      "none, or Water/Side = left or right");
    if (p.pore_water.of_the_daily_water().follows_water() && !in.level())
      throw UserError(level_path,
                      "is none, but the phreatic line of the daily stage "
                      "follows the water outside (Pore water/Lines by level)",
                      "a level (m), or Pore water/Daily phreatic line");
    try
      {
        daily_stage(p).check();
      }
    catch (const UserError &error)
      {
        throw in_daily_stage(error);
      }
  }
} // namespace Waker
