// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/statistics/slides.h>

#include <algorithm>
#include <cmath>
#include <deque>

namespace Waker
{
  namespace
  {
    /// Samples in the duration of a plateau.
    constexpr unsigned int samples_per_duration = 50;


    /// The trace, linear between its points, at n >= 2 equidistant moments
    /// from its first point to `end`.
    std::vector<TracePoint>
    sample(const std::vector<TracePoint> &trace,
           const double                   end,
           const double                   interval)
    {
      const double start = trace.front().time;
      const auto   n     = static_cast<std::size_t>(
        std::max(1., std::ceil((end - start) / interval * (1. - 1e-12))));

      std::vector<TracePoint> samples;
      samples.reserve(n + 1);
      auto after = trace.begin();
      for (std::size_t i = 0; i <= n; ++i)
        {
          const double time = start + (end - start) * i / n;
          while (after != trace.end() && after->time <= time)
            ++after;
          // here after->time > time >= (after - 1)->time
          const TracePoint &before = *std::prev(after);
          if (after == trace.end())
            samples.push_back({time, before.width, before.height});
          else
            {
              const double share =
                (time - before.time) / (after->time - before.time);
              samples.push_back(
                {time,
                 before.width + share * (after->width - before.width),
                 before.height + share * (after->height - before.height)});
            }
        }
      return samples;
    }


    /// For each i: max - min of value over the samples i .. i + window.
    template <typename Value>
    std::vector<double>
    moving_range(const std::vector<TracePoint> &samples,
                 const std::size_t              window,
                 const Value                   &value)
    {
      std::vector<double> range;
      if (samples.size() <= window)
        return range;
      range.reserve(samples.size() - window);
      // indices of candidates: values rise in `lowest`, fall in `highest`
      std::deque<std::size_t> lowest, highest;
      for (std::size_t i = 0; i < samples.size(); ++i)
        {
          const double v = value(samples[i]);
          while (!lowest.empty() && value(samples[lowest.back()]) >= v)
            lowest.pop_back();
          lowest.push_back(i);
          while (!highest.empty() && value(samples[highest.back()]) <= v)
            highest.pop_back();
          highest.push_back(i);
          if (i < window)
            continue;
          const std::size_t first = i - window;
          while (lowest.front() < first)
            lowest.pop_front();
          while (highest.front() < first)
            highest.pop_front();
          range.push_back(value(samples[highest.front()]) -
                          value(samples[lowest.front()]));
        }
      return range;
    }


    /// Whether the interval from sample i to i + 1 lies in a plateau.
    std::vector<bool>
    find_plateaus(const std::vector<TracePoint> &samples,
                  const std::size_t              window,
                  const double                   tolerance)
    {
      const std::vector<double> width =
        moving_range(samples, window, [](const auto &p) { return p.width; });
      const std::vector<double> height =
        moving_range(samples, window, [](const auto &p) { return p.height; });

      std::vector<bool> rests(samples.size() - 1, false);
      std::size_t       done = 0; // intervals before this are decided
      for (std::size_t i = 0; i < width.size(); ++i)
        // A width that is not measured (NaN) does not change.
        if (!(width[i] > tolerance) && height[i] <= tolerance)
          {
            for (std::size_t j = std::max(done, i); j < i + window; ++j)
              rests[j] = true;
            done = i + window;
          }
      return rests;
    }
  } // namespace


  void
  SlideParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Rate",
                      rate,
                      "A slide changes width or height of the dyke faster than "
                      "this (m/s), above 0; between slides they change more "
                      "slowly, on average over the duration of a plateau.",
                      dealii::Patterns::Double(0.));
    prm.add_parameter("Duration",
                      duration,
                      "How long (s), above 0, a plateau lasts at least: two "
                      "movements with a shorter rest between them are one "
                      "slide.",
                      dealii::Patterns::Double(0.));
    prm.add_parameter("Minimum change",
                      minimum_change,
                      "What width or height must have changed (m), above 0, "
                      "for a movement to count as a slide.",
                      dealii::Patterns::Double(0.));
  }


  void
  SlideParameters::check() const
  {
    require_positive("Slides/Rate", rate);
    require_positive("Slides/Duration", duration);
    require_positive("Slides/Minimum change", minimum_change);
  }


  std::vector<Slide>
  find_slides(const Record &record, const SlideParameters &parameters)
  {
    std::vector<Slide> slides;
    if (record.initial_time < 0.)
      return slides;

    const bool   floods = record.flooding_time >= 0.;
    const double end    = floods ? record.flooding_time : record.end_time;

    // Without a trace (or with one that ends before it begins) the events
    // themselves are all that is known.
    if (record.trace.empty() || !(end > record.trace.front().time))
      {
        slides.push_back({record.initial_time,
                          std::max(end, record.initial_time),
                          record.residual_width,
                          record.residual_height,
                          floods});
        return slides;
      }

    const double interval = parameters.duration / samples_per_duration;
    const std::vector<TracePoint> samples = sample(record.trace, end, interval);
    const std::vector<bool>       rests =
      find_plateaus(samples,
                    samples_per_duration,
                    parameters.rate * parameters.duration);

    TracePoint reference = samples.front(); // after the previous slide
    double     start     = -1.;             // of movements not yet counted, s
    for (std::size_t i = 0; i < rests.size(); ++i)
      {
        if (rests[i])
          continue;
        if (start < 0.)
          start = samples[i].time;
        while (i < rests.size() && !rests[i])
          ++i;
        const TracePoint &now = samples[i];
        if (std::abs(now.width - reference.width) >=
              parameters.minimum_change ||
            std::abs(now.height - reference.height) >=
              parameters.minimum_change)
          {
            slides.push_back({start, now.time, now.width, now.height, false});
            reference = now;
            start     = -1.;
          }
      }

    const TracePoint &last = samples.back();
    if (floods)
      {
        // A movement that ends at the last moment is the one that floods.
        if (slides.empty() || slides.back().end < last.time)
          {
            const double before =
              slides.empty() ? record.initial_time : slides.back().end;
            slides.push_back({start < 0. ? before : start,
                              last.time,
                              last.width,
                              last.height,
                              false});
          }
        slides.back().floods = true;
      }
    else if (slides.empty())
      slides.push_back(
        {record.initial_time, last.time, last.width, last.height, false});
    return slides;
  }
} // namespace Waker
