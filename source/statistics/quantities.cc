// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/numbers.h>
#include <waker/statistics/estimates.h>
#include <waker/statistics/quantities.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace Waker
{
  double
  Quantity::mean() const
  {
    return values.empty() ? nan
                          : std::accumulate(values.begin(), values.end(), 0.) /
                              values.size();
  }


  double
  Quantity::standard_deviation() const
  {
    if (values.size() < 2)
      return nan;
    const double middle = mean();
    double       sum    = 0.;
    for (const double value : values)
      sum += (value - middle) * (value - middle);
    return std::sqrt(sum / (values.size() - 1));
  }


  double
  Quantity::quantile(const double p) const
  {
    if (values.empty())
      return nan;
    const double      at    = p * (values.size() - 1);
    const std::size_t below = std::min<std::size_t>(at, values.size() - 1);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (at - below) * (values[above] - values[below]);
  }


  std::vector<Quantity>
  quantities(const std::vector<Record> &records)
  {
    using Value          = std::function<double(const Record &)>;
    const auto of_masses = [](const auto &f) {
      return [f](const Record &record) {
        return record.sliding_masses ? double(f(*record.sliding_masses)) : nan;
      };
    };
    const auto time_or_nan = [](const double time) {
      return time >= 0. ? time : nan;
    };
    const auto is_stopped = [](const Record &record) {
      return record.load_stop_time.value_or(-1.) >= 0.;
    };
    const struct
    {
      const char *name, *unit;
      Value       value;
    } all[] = {
      {"ultimate load",
       "",
       [=](const Record &r) {
         return is_stopped(r) ? r.load.value_or(nan) : nan;
       }},
      {"load not stopped",
       "",
       [=](const Record &r) {
         return is_stopped(r) ? nan : r.load.value_or(nan);
       }},
      {"sliding masses", "", of_masses([](const SlidingMasses &s) {
         return s.masses.size();
       })},
      {"relative failure volume", "", of_masses([](const SlidingMasses &s) {
         return s.relative_failure_volume();
       })},
      {"retrogression distance", "m", of_masses([](const SlidingMasses &s) {
         return s.retrogression;
       })},
      {"damaged crest width", "m", of_masses([](const SlidingMasses &s) {
         return s.damaged_crest_width;
       })},
      {"time of initial failure, by the first of its readings",
       "s",
       [=](const Record &r) {
         return time_or_nan(r.time_of(FailureReading::any));
       }},
      {"time of flooding", "s", [=](const Record &r) {
         return time_or_nan(r.flooding_time);
       }}};

    std::vector<Quantity> list;
    for (const auto &[name, unit, value] : all)
      {
        Quantity quantity{name, unit, {}};
        for (const Record &record : records)
          if (counts(record) && std::isfinite(value(record)))
            quantity.values.push_back(value(record));
        std::sort(quantity.values.begin(), quantity.values.end());
        if (!quantity.values.empty())
          list.push_back(quantity);
      }
    return list;
  }
} // namespace Waker
