// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/campaign/progress.h>
#include <waker/statistics/intervals.h>

#include <algorithm>

namespace Waker
{
  Event::Event(const Record &record)
    : numerical_failure(record.outcome == Outcome::numerical_failure)
    , undecided(!numerical_failure && !is_decided(record.outcome))
    , initial_failure(is_decided(record.outcome) && record.failed())
    , flooding(is_decided(record.outcome) && record.flooded())
  {}


  void
  Counts::add(const Event &event)
  {
    ++n;
    n_failures += event.numerical_failure ? 1 : 0;
    n_undecided += event.undecided ? 1 : 0;
    n_initial += event.initial_failure ? 1 : 0;
    n_flooding += event.flooding ? 1 : 0;
  }


  bool
  enough(const CampaignParameters &p, const Counts &counts)
  {
    const std::uint64_t n = counts.n_decided();
    if (counts.n < p.minimum_realisations || n == 0)
      return false;
    if (p.initial_failures > 0 && counts.n_initial >= p.initial_failures)
      return true;

    const std::uint64_t k = p.target == CampaignTarget::flooding
                              ? counts.n_flooding
                              : counts.n_initial;
    // Where all realisations agree the variation is not known, it is not 0.
    if (p.coefficient_of_variation > 0. && k < n &&
        coefficient_of_variation(k, n) < p.coefficient_of_variation)
      return true;
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
    Scenario             &scenario = scenarios[record.scenario];
    std::optional<Event> &event    = scenario.realisations[record.realisation];
    if (event)
      return;
    event = Event(record);
    if (record.realisation < scenario.end)
      scenario.counts.add(*event);
    advance_prefix(scenario);
  }


  void
  Progress::advance_prefix(Scenario &scenario) const
  {
    while (!scenario.stopped && scenario.prefix < scenario.end &&
           scenario.realisations[scenario.prefix])
      {
        scenario.prefix_counts.add(*scenario.realisations[scenario.prefix++]);
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
    return scenarios[scenario].realisations[realisation].has_value();
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
