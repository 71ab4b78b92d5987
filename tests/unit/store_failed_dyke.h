// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_store_failed_dyke_h
#define waker_tests_store_failed_dyke_h

#include <waker/store/record.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Waker
{
  /// A dyke of W = 11 m and H = 5 m with water at 4.75 m, of which only the
  /// given geometry is known. Corners of a polygon, as the recorder writes it:
  /// steps of 0.02 m with the last moment before each.
  inline Record
  failed_dyke(const std::vector<TracePoint> &corners)
  {
    Record record;
    record.initial_width  = corners.front().width;
    record.initial_height = corners.front().height;
    record.end_time       = corners.back().time;
    record.outcome        = Outcome::initial_failure;

    const double dt   = 0.01;
    TracePoint   kept = corners.front(), previous = kept;
    record.trace.push_back(kept);
    std::size_t i = 0;
    for (double t = dt; t < record.end_time + dt / 2; t += dt)
      {
        while (i + 2 < corners.size() && corners[i + 1].time < t)
          ++i;
        const double share = std::min(
          1., (t - corners[i].time) / (corners[i + 1].time - corners[i].time));
        const TracePoint now = {
          t,
          corners[i].width + share * (corners[i + 1].width - corners[i].width),
          corners[i].height +
            share * (corners[i + 1].height - corners[i].height)};
        if (record.initial_time < 0. &&
            (std::abs(now.width - record.initial_width) > 0.3 ||
             now.height < record.initial_height - 0.1))
          record.initial_time = t;
        if (record.flooding_time < 0. && now.height < 4.75)
          {
            record.flooding_time = t;
            record.outcome       = Outcome::flooding;
          }
        if (std::abs(now.width - kept.width) > 0.02 ||
            std::abs(now.height - kept.height) > 0.02)
          {
            if (previous.time > record.trace.back().time)
              record.trace.push_back(previous);
            record.trace.push_back(now);
            kept = now;
          }
        previous = now;
      }
    if (previous.time > record.trace.back().time)
      record.trace.push_back(previous);
    record.residual_width  = previous.width;
    record.residual_height = previous.height;
    return record;
  }
} // namespace Waker

#endif
