// SPDX-License-Identifier: LGPL-2.1-or-later
#include "unused_parameters.h"

#include <waker/base/text.h>
#include <waker/mechanics/time_scheme.h>

#include "unused_of_laws.h"
#include <algorithm>

namespace Waker
{
  namespace
  {
    /// Set, but of no effect with what has been chosen.
    void
    warn_unused(const bool                is_set,
                const std::string        &path,
                const std::string        &choice,
                std::vector<std::string> &warnings)
    {
      if (is_set)
        warnings.push_back(path + " is not used with " + choice);
    }


    void
    warn_of_unused_regularisation(const MaterialParameters &m,
                                  std::vector<std::string> &warnings)
    {
      const NonlocalParameters usual;
      const std::string        path = "Materials/" + m.name + "/";
      const std::string        choice =
        std::string("Regularisation = ") + name_of(m.regularisation);
      const bool is_nonlocal = m.regularisation == Regularisation::nonlocal;
      warn_unused(is_nonlocal && !m.softens(),
                  path + choice,
                  "soil that does not soften",
                  warnings);
      warn_unused(is_nonlocal && m.softening_length != 0.,
                  path + "Softening length",
                  choice,
                  warnings);
      warn_unused(!is_nonlocal && m.softening_length != 0. && !m.softens(),
                  path + "Softening length",
                  "soil that does not soften",
                  warnings);
      warn_unused(!is_nonlocal && m.nonlocal.length != usual.length,
                  path + "Averaging length",
                  choice,
                  warnings);
      warn_unused(!is_nonlocal && m.nonlocal.over_weight != usual.over_weight,
                  path + "Over-weight",
                  choice,
                  warnings);
      warn_unused(!is_nonlocal && m.nonlocal.weight != usual.weight,
                  path + "Neighbour weight",
                  choice,
                  warnings);
    }


    /// Of the water in the ground.
    void
    warn_of_unused_lines(const Parameters         &p,
                         std::vector<std::string> &warnings)
    {
      const PoreWaterParameters &water  = p.pore_water;
      const std::string          usual  = PoreWaterParameters().delay;
      const std::string          at_all = "no Lines by level";
      warn_unused(!water.follows_water() && tidy(water.delay) != usual,
                  "Pore water/Delay",
                  at_all,
                  warnings);
      for (const HeadLineParameters &line : water.head_lines)
        {
          warn_unused(!line.follows_water() && tidy(line.delay) != usual,
                      "Head lines/" + line.name + "/Delay",
                      at_all,
                      warnings);
          const auto is_meant = [&](const ReferenceLineParameters &r) {
            return tidy(r.top_head_line) == line.name ||
                   tidy(r.bottom_head_line) == line.name;
          };
          warn_unused(std::none_of(water.reference_lines.begin(),
                                   water.reference_lines.end(),
                                   is_meant),
                      "Head lines/" + line.name,
                      "the reference lines that there are",
                      warnings);
        }
      if (!water.reference_lines.empty())
        {
          const ReferenceLineParameters &first =
            water.reference_lines[from_top_to_bottom(water.reference_lines)[0]];
          warn_unused(!tidy(first.top_head_line).empty(),
                      "Reference lines/" + first.name + "/Top head line",
                      "the first reference line: above it the pressure is "
                      "hydrostatic from the phreatic line",
                      warnings);
        }
      for (const TractionParameters &t : p.tractions)
        warn_unused(t.spread != TractionParameters().spread &&
                      tidy(t.consolidation).empty(),
                    "Tractions/" + t.name + "/Spread",
                    "no Consolidation",
                    warnings);
    }
  } // namespace


  void
  warn_of_unused(const Parameters &p, std::vector<std::string> &warnings)
  {
    for (const TractionParameters &t : p.tractions)
      {
        const TractionParameters usual;
        const std::string        path = "Tractions/" + t.name + "/";
        const std::string choice = std::string("Kind = ") + name_of(t.kind);
        const bool        liquid = t.kind == TractionKind::hydrostatic;
        warn_unused(!liquid && t.level != usual.level,
                    path + "Level",
                    choice,
                    warnings);
        warn_unused(!liquid && t.unit_weight != usual.unit_weight,
                    path + "Unit weight",
                    choice,
                    warnings);
        warn_unused(liquid && t.value != usual.value,
                    path + "Value",
                    choice,
                    warnings);
      }
    const WaterParameters dry;
    if (!p.water.stands() && !p.pore_water.is_there())
      warn_unused(p.water.unit_weight != dry.unit_weight,
                  "Water/Unit weight",
                  "Side = none",
                  warnings);
    warn_unused(!p.water.stands() && tidy(p.water.rise) != dry.rise,
                "Water/Rise",
                "Side = none",
                warnings);
    for (const FixityParameters &condition : p.fixities)
      warn_unused(condition.method == FixityMethod::elimination &&
                    condition.penalty_factor !=
                      FixityParameters().penalty_factor,
                  "Boundary conditions/" + condition.name + "/Penalty factor",
                  std::string("Method = ") + name_of(condition.method),
                  warnings);
    warn_of_unused_lines(p, warnings);
    for (const MaterialParameters &m : p.materials)
      warn_of_unused_regularisation(m, warnings);
    for (const MaterialParameters &m : p.materials)
      warn_of_unused_of_law(m, warnings);
    for (const MaterialParameters &m : p.materials)
      warn_unused(!p.pore_water.is_there() && !tidy(m.below_line).empty(),
                  "Materials/" + m.name + "/Below the line",
                  "no Pore water/Phreatic line",
                  warnings);
    for (const MaterialParameters &m : p.materials)
      warn_unused(!p.pore_water.is_there() && m.saturated_unit_weight != 0.,
                  "Materials/" + m.name + "/Saturated unit weight",
                  "no Pore water/Phreatic line",
                  warnings);
    warn_unused(p.pore_water.is_there() &&
                  p.initial_stress.from != StressFrom::k0 &&
                  std::none_of(p.materials.begin(),
                               p.materials.end(),
                               [](const MaterialParameters &m) {
                                 return m.is_drained() ||
                                        m.strength_follows_stress() ||
                                        !tidy(m.below_line).empty() ||
                                        m.saturated_unit_weight != 0.;
                               }),
                "Pore water/Phreatic line",
                "laws of total stress alone",
                warnings);
    const InitialStressParameters at_rest;
    for (const MaterialParameters &m : p.materials)
      warn_unused(p.initial_stress.from != StressFrom::k0 &&
                    m.k0 != MaterialParameters().k0,
                  "Materials/" + m.name + "/K0",
                  "Initial stress/From = gravity",
                  warnings);
    warn_unused(p.initial_stress.laws != BalanceLaws::plastic &&
                  p.initial_stress.steps != at_rest.steps,
                "Initial stress/Steps",
                "Laws = elastic",
                warnings);
    warn_unused(!p.initial_stress.daily_stage &&
                  !tidy(p.initial_stress.daily_level).empty(),
                "Initial stress/Daily level",
                "Daily stage = false",
                warnings);
    warn_unused(!p.gravity.initial_stress && p.gravity.initial_share != 1.,
                "Gravity/Initial share",
                "Initial stress = false",
                warnings);
    const TimeParameters usual;
    warn_unused(scheme_traits(p.time).is_implicit &&
                  p.time.courant_number != usual.courant_number,
                "Time stepping/Courant number",
                std::string("Scheme = ") + name_of(p.time.scheme),
                warnings);
    const bool has_long_steps = scheme_traits(p.time).has_long_steps;
    const auto warn_of_time = [&](const bool is_set, const std::string &name) {
      warn_unused(is_set,
                  "Time stepping/" + name,
                  std::string("Scheme = ") + name_of(p.time.scheme),
                  warnings);
    };
    warn_of_time(!has_long_steps && p.time.longest_step != usual.longest_step,
                 "Longest step");
    warn_of_time(!has_long_steps && p.time.largest_rise != usual.largest_rise,
                 "Largest rise");
    warn_of_time(!has_long_steps &&
                   p.time.largest_displacement != usual.largest_displacement,
                 "Largest displacement");
    warn_of_time(has_long_steps && p.time.load_duration != usual.load_duration,
                 "Load duration");
    warn_of_time(has_long_steps && p.time.move_points != usual.move_points,
                 "Move points");
  }
} // namespace Waker
