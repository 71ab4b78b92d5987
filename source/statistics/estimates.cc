// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/statistics/estimates.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// @param n_both floods of dykes that have failed, not of others
    Estimate
    make_estimate(const std::uint64_t n_initial,
                  const std::uint64_t n_flooding,
                  const std::uint64_t n_both,
                  const std::uint64_t n)
    {
      return {proportion(n_initial, n),
              proportion(n_flooding, n),
              proportion(n_both, n_initial)};
    }


    bool
    fails_and_floods(const Record &record)
    {
      return record.failed() && record.flooded();
    }


    /// Moments of an event, sorted.
    template <typename Time>
    std::vector<double>
    event_times(const std::vector<Record> &records, const Time &time)
    {
      std::vector<double> times;
      for (const Record &record : records)
        if (counts(record) && time(record) >= 0.)
          times.push_back(time(record));
      std::sort(times.begin(), times.end());
      return times;
    }


    std::uint64_t
    n_until(const std::vector<double> &sorted_times, const double time)
    {
      return std::upper_bound(sorted_times.begin(), sorted_times.end(), time) -
             sorted_times.begin();
    }
  } // namespace


  ScenarioEstimate
  estimate(const std::vector<Record> &records, const bool may_flood)
  {
    ScenarioEstimate result;
    const auto       with = [&](const FailureReading reading) {
      std::uint64_t n_initial = 0, n_flooding = 0, n_both = 0, n = 0;
      for (const Record &record : records)
        if (counts(record) &&
            (reading != FailureReading::by_displacement ||
             record.watches_slopes()) &&
            (reading != FailureReading::by_width ||
             std::isfinite(record.initial_width)))
          {
            const bool fails = record.time_of(reading) >= 0.;
            ++n;
            n_initial += fails;
            n_flooding += record.flooded();
            n_both += fails && record.flooded();
          }
      return make_estimate(n_initial, n_flooding, n_both, n);
    };
    result.by_any          = with(FailureReading::any);
    result.by_geometry     = with(FailureReading::by_geometry);
    result.by_width        = with(FailureReading::by_width);
    result.by_displacement = with(FailureReading::by_displacement);

    std::uint64_t n_inner = 0, n_outer = 0, n_watched = 0;
    std::uint64_t n_initial_then_lost = 0, n_flooding_then_lost = 0,
                  n_both_then_lost = 0;
    for (const Record &record : records)
      if (counts(record))
        {
          ++result.n;
          n_watched += record.watches_slopes();
          n_inner += record.inner_slide.time >= 0.;
          n_outer += record.outer_slide.time >= 0.;
          result.n_not_final += record.outcome == Outcome::initial_failure &&
                                record.unrest && !record.unrest->is_final();
        }
      else
        {
          result.n_numerical += record.outcome == Outcome::numerical_failure;
          result.n_still_moving += record.outcome == Outcome::still_moving;
          result.n_loads_change += record.outcome == Outcome::loads_change;
          result.n_stopped_by_box += record.outcome == Outcome::stopped_by_box;
          n_initial_then_lost += record.failed();
          n_flooding_then_lost += record.flooded();
          n_both_then_lost += fails_and_floods(record);
        }
    for (const Record &record : records)
      {
        const std::uint64_t n = record.points_beyond_law.value_or(0);
        result.n_beyond_law += n > 0;
        result.most_points_beyond_law =
          std::max(result.most_points_beyond_law, n);
      }
    result.inner_slides = proportion(n_inner, n_watched);
    result.outer_slides = proportion(n_outer, n_watched);

    const std::uint64_t lost       = result.n_lost();
    const std::uint64_t all        = result.n + lost;
    const std::uint64_t n_initial  = result.by_any.initial.count;
    const std::uint64_t n_flooding = result.by_any.flooding.count;
    const std::uint64_t n_both     = result.by_any.flooding_given.count;
    const std::uint64_t n_open     = result.n_not_final + lost;
    result.if_all_failed           = make_estimate(n_initial + lost,
                                         n_flooding + n_open,
                                         n_both + n_open,
                                         all);
    result.if_none_failed = make_estimate(n_initial + n_initial_then_lost,
                                          n_flooding + n_flooding_then_lost,
                                          n_both + n_both_then_lost,
                                          all);
    if (!may_flood)
      for (Estimate *const e : {&result.by_any,
                                &result.by_geometry,
                                &result.by_width,
                                &result.by_displacement,
                                &result.if_all_failed,
                                &result.if_none_failed})
        e->flooding = e->flooding_given = proportion(0, 0);
    return result;
  }


  std::string
  undecided_text(const std::uint64_t n_lost,
                 const std::uint64_t n_not_final,
                 const std::uint64_t n_all)
  {
    std::string text;
    if (n_lost > 0)
      text =
        std::to_string(n_lost) + " of " + std::to_string(n_all) + " undecided";
    if (n_not_final > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(n_not_final) +
              (n_not_final == 1 ? " initial failure" : " initial failures") +
              " not final";
    return text;
  }


  std::vector<EstimateRow>
  estimate_against_time(const std::vector<Record> &records,
                        const unsigned int         n_rows)
  {
    std::uint64_t n   = 0;
    double        end = 0.;
    for (const Record &record : records)
      if (counts(record))
        {
          ++n;
          end = std::max({end, record.end_time, record.flooding_time});
        }
    const std::vector<double> initial =
      event_times(records, [](const Record &record) {
        return record.time_of(FailureReading::any);
      });
    const std::vector<double> flooding =
      event_times(records,
                  [](const Record &record) { return record.flooding_time; });

    const std::vector<double> both =
      event_times(records, [](const Record &record) {
        return fails_and_floods(record)
                 ? std::max(record.flooding_time,
                            record.time_of(FailureReading::any))
                 : -1.;
      });

    std::vector<double> times = {0., end};
    times.insert(times.end(), initial.begin(), initial.end());
    times.insert(times.end(), flooding.begin(), flooding.end());
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    if (times.size() > n_rows)
      {
        times.resize(n_rows);
        for (unsigned int i = 0; i < n_rows; ++i)
          times[i] = i + 1 == n_rows ? end : end * i / (n_rows - 1);
      }

    std::vector<EstimateRow> rows;
    rows.reserve(times.size());
    for (const double time : times)
      rows.push_back({time,
                      make_estimate(n_until(initial, time),
                                    n_until(flooding, time),
                                    n_until(both, time),
                                    n)});
    return rows;
  }


  std::vector<EstimateRow>
  estimate_convergence(const std::vector<Record> &records,
                       const unsigned int         n_rows)
  {
    std::vector<const Record *> ordered;
    ordered.reserve(records.size());
    for (const Record &record : records)
      if (counts(record))
        ordered.push_back(&record);
    std::sort(ordered.begin(),
              ordered.end(),
              [](const Record *const a, const Record *const b) {
                return a->realisation < b->realisation;
              });

    std::vector<EstimateRow> rows;
    const double             n         = static_cast<double>(ordered.size());
    std::uint64_t            n_initial = 0, n_flooding = 0, n_both = 0;
    // where the next row is due: n^(row / (n_rows - 1)), but each number once
    unsigned int row  = 0;
    double       next = 1.;
    for (std::size_t i = 0; i < ordered.size(); ++i)
      {
        n_initial += ordered[i]->failed();
        n_flooding += ordered[i]->flooded();
        n_both += fails_and_floods(*ordered[i]);
        const double number = i + 1.;
        if (number < next && i + 1 < ordered.size())
          continue;
        rows.push_back(
          {number, make_estimate(n_initial, n_flooding, n_both, i + 1)});
        while (next <= number && row + 1 < n_rows)
          {
            ++row;
            next = std::pow(n, row / (n_rows - 1.));
          }
      }
    return rows;
  }
} // namespace Waker
