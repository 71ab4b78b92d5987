// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/case/load_programmes.h>
#include <waker/mechanics/time_scheme.h>

#include <cmath>
#include <set>
#include <utility>

namespace Waker
{
  namespace
  {
    /// That there is a load of that name, and that it is asked for.
    template <typename Load>
    void
    check_load(const LoadProgrammeParameters &programme,
               const std::vector<Load>       &loads)
    {
      std::string names;
      for (const Load &load : loads)
        {
          if (load.name == programme.load)
            return;
          names += (names.empty() ? "" : ", ") + load.name;
        }
      const std::string section = facts_of(programme.drives).section;
      throw UserError(programme.path() + "Load",
                      "is \"" + programme.load + "\", which is none of " +
                        section + "/Names",
                      names.empty() ? "a name in " + section + "/Names"
                                    : "one of " + names);
    }
  } // namespace


  void
  check_load_programmes(const Parameters &parameters)
  {
    const bool points_move = scheme_traits(parameters.time).moves_points;
    std::set<std::pair<LoadTarget, std::string>> driven;
    for (const LoadProgrammeParameters &p : parameters.load_programmes)
      {
        p.check(parameters.dimension, points_move);
        switch (p.drives)
          {
            case LoadTarget::weight:
              if (p.weight.mass == LoadMass::with_mass &&
                  !(parameters.gravity.acceleration > 0.))
                throw UserError(p.path() + "Mass",
                                std::string("is ") + name_of(p.weight.mass) +
                                  ", but mass has no weight: "
                                  "Gravity/Acceleration is 0",
                                name_of(LoadMass::weight_alone));
              continue; // there may be many
            case LoadTarget::traction:
              check_load(p, parameters.tractions);
              break;
            case LoadTarget::point_load:
              check_load(p, parameters.point_loads);
              break;
            case LoadTarget::water:
              if (!parameters.water.stands())
                throw UserError(p.path() + "Drives",
                                std::string("is ") + name_of(p.drives) +
                                  ", but there is none: Water/Side is " +
                                  name_of(parameters.water.side),
                                "another load, or water at a side");
              break;
          }
        const std::string load =
          *facts_of(p.drives).section == '\0' ? "" : p.load;
        if (!driven.emplace(p.drives, load).second)
          throw UserError(p.path() + "Drives",
                          std::string("is ") + name_of(p.drives) +
                            (load.empty() ? "" : " " + load) +
                            ", which another programme drives already",
                          "one programme for each load");
      }
  }


  namespace
  {
    /// Less of a factor (m, -) is nothing.
    constexpr double least_change = 1e-6;


    /// What never acts, or never holds.
    std::vector<std::string>
    without_effect(const LoadProgrammeParameters &p, const TimeParameters &time)
    {
      std::vector<std::string> warnings;
      const std::string        end =
        in_digits(time.end_time) + " s, Time stepping/End time";
      const std::string unit = *facts_of(p.drives).unit == '-'
                                 ? ""
                                 : " " + std::string(facts_of(p.drives).unit);
      switch (p.kind)
        {
          case LoadProgrammeKind::growth:
            {
              const double change =
                std::abs(p.rate) * (time.end_time - p.start_time);
              if (p.start_time >= time.end_time)
                warnings.push_back(p.path() + "Start time is " +
                                   in_digits(p.start_time) + " s, not before " +
                                   end + ": it never acts");
              else if (change < least_change)
                warnings.push_back(p.path() + "Rate is " + in_digits(p.rate) +
                                   unit + "/s: it changes by " +
                                   in_digits(change) + unit + " by " + end);
              if (p.held_by != Watched::nothing && p.held_by == p.stopped_by &&
                  p.hold_above >= p.stop_above)
                warnings.push_back(
                  p.path() + "Hold above is " + in_digits(p.hold_above) + " " +
                  facts_of(p.held_by).unit + ", not below Stop above, " +
                  in_digits(p.stop_above) + " " + facts_of(p.held_by).unit +
                  " of the same quantity: it stops before it would wait");
              break;
            }
          case LoadProgrammeKind::table_of_time:
            {
              const TimeFunction function = p.read_table();
              if (!function.varies(0., time.end_time) &&
                  std::abs(function.value(0.)) < least_change)
                warnings.push_back(
                  p.path() + "Table is " + in_digits(function.value(0.)) +
                  unit + " from the start to " + end + ": it never acts");
              break;
            }
          case LoadProgrammeKind::table_of_quantity:
            break;
        }
      return warnings;
    }
  } // namespace


  std::vector<std::string>
  unused_in_load_programmes(const Parameters &parameters)
  {
    std::vector<std::string>      warnings;
    const LoadProgrammeParameters usual;
    for (const LoadProgrammeParameters &p : parameters.load_programmes)
      {
        const auto warn = [&](const bool         is_set,
                              const char *const  entry,
                              const std::string &choice) {
          if (is_set)
            warnings.push_back(p.path() + entry + " is not used with " +
                               choice);
        };
        const std::string kind  = std::string("Kind = ") + name_of(p.kind);
        const bool        grows = p.kind == LoadProgrammeKind::growth;
        warn(!grows && p.rate != usual.rate, "Rate", kind);
        warn(!grows && p.start_time != usual.start_time, "Start time", kind);
        warn(!grows && p.up_to != usual.up_to, "Up to", kind);
        warn(!grows && p.held_by != usual.held_by, "Held by", kind);
        warn(grows && p.table != usual.table, "Table", kind);
        warn(p.kind != LoadProgrammeKind::table_of_quantity &&
               p.quantity != usual.quantity,
             "Quantity",
             kind);
        warn((!grows || p.held_by == Watched::nothing) &&
               p.hold_above != usual.hold_above,
             "Hold above",
             grows ? "Held by = nothing" : kind);
        for (const std::string &text : without_effect(p, parameters.time))
          warnings.push_back(text);
        warn(p.stopped_by == Watched::nothing &&
               p.stop_above != usual.stop_above,
             "Stop above",
             "Stopped by = nothing");

        const std::string drives = std::string("Drives = ") + name_of(p.drives);
        const bool        weighs = p.drives == LoadTarget::weight;
        warn(*facts_of(p.drives).section == '\0' && !p.load.empty(),
             "Load",
             drives);
        warn(!weighs && !p.weight.from.empty(), "From", drives);
        warn(!weighs && !p.weight.to.empty(), "To", drives);
        warn(!weighs && p.weight.unit_weight != usual.weight.unit_weight,
             "Unit weight",
             drives);
        warn(!weighs && p.weight.points != usual.weight.points,
             "Points",
             drives);
        warn(!weighs && p.weight.mass != usual.weight.mass, "Mass", drives);
      }
    return warnings;
  }
} // namespace Waker
