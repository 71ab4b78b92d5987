// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/reliability/intervals.h>
#include <waker/reliability/progress.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  void
  Counts::add(const Record &record)
  {
    ++n;
    if (record.outcome == Outcome::numerical_failure)
      ++n_failures;
    else
      {
        n_initial += record.initial_time >= 0. ? 1 : 0;
        n_flooding += record.flooding_time >= 0. ? 1 : 0;
      }
  }


  bool
  enough(const CampaignParameters &p, const Counts &counts)
  {
    const std::uint64_t n = counts.n - counts.n_failures;
    if (counts.n < p.minimum_realisations || n == 0)
      return false;
    if (p.initial_failures > 0 && counts.n_initial >= p.initial_failures)
      return true;

    const std::uint64_t k =
      p.target == "flooding" ? counts.n_flooding : counts.n_initial;
    if (p.coefficient_of_variation > 0. && k > 0)
      {
        const double probability = double(k) / n;
        if (std::sqrt((1. - probability) / k) < p.coefficient_of_variation)
          return true;
      }
    if (p.interval_width > 0.)
      {
        const Interval interval = clopper_pearson(k, n);
        if (interval.high - interval.low < p.interval_width)
          return true;
      }
    return false;
  }


  Progress::Progress(const CampaignParameters &parameters,
                     const unsigned int        n_scenarios)
    : parameters(parameters)
    , scenarios(n_scenarios)
  {
    for (Scenario &scenario : scenarios)
      {
        scenario.realisations.resize(parameters.realisations);
        scenario.end = parameters.realisations;
      }
  }


  void
  Progress::add(const Record &record)
  {
    if (record.scenario >= scenarios.size() ||
        record.realisation >= parameters.realisations)
      return; // of a longer campaign
    Scenario &scenario = scenarios[record.scenario];
    Brief    &brief    = scenario.realisations[record.realisation];
    if (brief.done)
      return;
    brief.done     = true;
    brief.failure  = record.outcome == Outcome::numerical_failure;
    brief.initial  = record.initial_time >= 0.;
    brief.flooding = record.flooding_time >= 0.;
    if (record.realisation < scenario.end)
      scenario.counts.add(record);
    advance_prefix(scenario);
  }


  void
  Progress::advance_prefix(Scenario &scenario) const
  {
    while (!scenario.stopped && scenario.prefix < scenario.end &&
           scenario.realisations[scenario.prefix].done)
      {
        const Brief &brief = scenario.realisations[scenario.prefix++];
        ++scenario.prefix_counts.n;
        if (brief.failure)
          ++scenario.prefix_counts.n_failures;
        else
          {
            scenario.prefix_counts.n_initial += brief.initial ? 1 : 0;
            scenario.prefix_counts.n_flooding += brief.flooding ? 1 : 0;
          }
        if (scenario.prefix % parameters.batch == 0 &&
            enough(parameters, scenario.prefix_counts))
          {
            scenario.stopped = scenario.prefix < scenario.end;
            scenario.end     = scenario.prefix;
            scenario.counts  = scenario.prefix_counts;
          }
      }
  }


  bool
  Progress::is_done(const unsigned int  scenario,
                    const std::uint64_t realisation) const
  {
    return scenarios[scenario].realisations[realisation].done;
  }


  std::uint64_t
  Progress::n_wanted() const
  {
    std::uint64_t sum = 0;
    for (const Scenario &scenario : scenarios)
      sum += scenario.end;
    return sum;
  }


  std::uint64_t
  Progress::n_done() const
  {
    std::uint64_t sum = 0;
    for (const Scenario &scenario : scenarios)
      sum += scenario.counts.n;
    return sum;
  }
} // namespace Waker
