// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/text.h>
#include <waker/campaign/campaign_parameters.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    /// deal.II 9.4 has no parameter of 64 bits.
    void
    add_count(ParameterHandler  &prm,
              const std::string &name,
              std::uint64_t     &value,
              const std::string &documentation,
              const int          smallest)
    {
      prm.declare_entry(name,
                        std::to_string(value),
                        Patterns::Integer(smallest),
                        documentation);
      prm.add_action(name, [&value](const std::string &text) {
        value = std::stoull(text);
      });
    }
  } // namespace


  void
  CampaignParameters::add_parameters(ParameterHandler &prm)
  {
    add_count(prm,
              "Seed",
              seed,
              "Number of the series of random numbers: realisation i of a "
              "campaign depends on the seed and i only. The scenarios of a "
              "sweep have the same random numbers.",
              0);
    add_count(prm,
              "Realisations",
              realisations,
              "Number N of realisations, at most, of each scenario; may be "
              "made larger when a campaign is resumed.",
              1);
    add_count(
      prm,
      "Batch",
      batch,
      "The rules for stopping before N are looked at after each so many "
      "realisations, counted from the first.",
      1);
    prm.add_parameter(
      "Attempts",
      attempts,
      "A realisation that fails numerically is begun again with "
      "half the time step, up to so many times in all; then it "
      "is recorded as a numerical failure.",
      Patterns::Integer(1, 10));
    prm.add_parameter(
      "Checkpoint interval",
      checkpoint_interval,
      "A realisation that takes longer is kept in the folder \"running\" after "
      "each so many seconds of computing, so that one that is killed goes on "
      "from there with --resume (s of wall time). 0: it begins anew.",
      Patterns::Double(0.));
    prm.add_parameter(
      "Ranks per realisation",
      ranks_per_realisation,
      "Number r of ranks that compute each realisation together: N ranks, of "
      "which it must be a divisor, compute N/r realisations at a time. More "
      "than 1 pays only where one rank takes too long for a realisation, or "
      "there are fewer realisations than ranks. Any number gives the same "
      "results, but for round-off.",
      Patterns::Integer(1));
    add_choice(prm,
               "Target",
               target,
               "The probability that the next two rules look at.");
    prm.add_parameter("Coefficient of variation",
                      coefficient_of_variation,
                      "Stop when that of the estimated probability is smaller "
                      "(-). 0: no such rule.",
                      Patterns::Double(0.));
    prm.add_parameter("Interval width",
                      interval_width,
                      "Stop when the 95 % interval of the probability is "
                      "narrower (-). 0: no such rule.",
                      Patterns::Double(0., 1.));
    add_count(
      prm,
      "Initial failures",
      initial_failures,
      "Stop when so many realisations have failed initially. 0: no such "
      "rule.",
      0);
    add_count(prm,
              "Minimum realisations",
              minimum_realisations,
              "No rule stops a scenario before so many realisations.",
              0);
  }


  void
  CampaignParameters::check() const
  {
    if (minimum_realisations > realisations)
      throw UserError("Campaign/Minimum realisations",
                      "is " + std::to_string(minimum_realisations),
                      "at most Campaign/Realisations, " +
                        std::to_string(realisations));
  }


  void
  SweepParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Parameter",
      parameter,
      "Path of the parameter that differs between the scenarios "
      "of the campaign, for example \"Water/Level\" or \"Random "
      "fields/strength/Scales of fluctuation\". Empty: there is "
      "one scenario.",
      Patterns::Anything());
    prm.add_parameter(
      "Values",
      values,
      "Its values, one per scenario, separated by semicolons (so "
      "none of them can have one).",
      Patterns::Anything());
  }


  std::vector<std::string>
  SweepParameters::list() const
  {
    if (parameter.empty())
      return {""};
    std::vector<std::string> result;
    for (const std::string &item : split(values, ';'))
      if (!item.empty())
        result.push_back(item);
    return result;
  }


  void
  SweepParameters::check() const
  {
    const std::vector<std::string> items = list();
    if (parameter.empty() && !values.empty())
      throw UserError("Sweep/Parameter",
                      "is empty, but there are values",
                      "the path of a parameter, \"Section/Name\"");
    if (items.empty())
      throw UserError("Sweep/Values",
                      "is empty",
                      "values of " + parameter + ", separated by semicolons");
    for (const std::string &item : split(values, ';'))
      if (item.empty() && !parameter.empty())
        throw UserError("Sweep/Values",
                        in_quotes(values) + " has an empty value",
                        "values of " + parameter +
                          ", semicolons between them only");
    for (const std::string &item : items)
      if (std::count(items.begin(), items.end(), item) > 1)
        throw UserError("Sweep/Values",
                        "contains " + item + " twice",
                        "each value once");
  }


  void
  SnapshotParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "First",
      first,
      "After the campaign, run the first so many realisations of "
      "each scenario again with full output, to the folder "
      "\"snapshots\".",
      Patterns::Integer(0));
    prm.add_parameter(
      "Of each outcome",
      of_each_outcome,
      "Likewise so many realisations of each outcome, those with "
      "the lowest numbers.",
      Patterns::Integer(0));
    prm.add_parameter("Realisations",
                      realisations,
                      "Likewise the realisations of these numbers.",
                      Patterns::List(Patterns::Integer(0)));
  }
} // namespace Waker
