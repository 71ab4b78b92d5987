// SPDX-License-Identifier: LGPL-2.1-or-later
#include "unused_parameters.h"

#include <waker/base/text.h>
#include <waker/mechanics/time_scheme.h>

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
    for (const MaterialParameters &m : p.materials)
      warn_of_unused_regularisation(m, warnings);
    for (const MaterialParameters &m : p.materials)
      {
        const std::string  path = "Materials/" + m.name + "/";
        const StrengthFrom from = m.von_mises.strength.from;
        const std::string  choice =
          std::string("Strength from = ") + name_of(from);
        if (m.model != MaterialModel::von_mises_softening)
          {
            warn_unused(from != StrengthFrom::place,
                        path + "Strength from",
                        std::string("Model = ") + name_of(m.model),
                        warnings);
            continue;
          }
        for (const std::string &name : m.von_mises.strength.unused())
          warn_unused(true, path + name, choice, warnings);
        warn_unused(from != StrengthFrom::place &&
                      m.von_mises.initial_strength !=
                        VonMisesSofteningParameters().initial_strength,
                    path + "Initial strength",
                    choice,
                    warnings);
      }
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
  }
} // namespace Waker
