// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_observers_failure_record_h
#define waker_observers_failure_record_h

#include <waker/observers/dyke_geometry.h>

namespace Waker
{
  struct InitialFailureLimits
  {
    double width_change = 0.3; // m
    double height_loss  = 0.1; // m
  };

  /**
   * When the dyke failed, relative to the geometry detected first, never to a
   * nominal one: the detected surface lies a little off the drawn one.
   *
   * Initial failure in two readings, both recorded: the thesis's, W below its
   * initial value; and the default, which also sees slides outwards (W grows)
   * and slides of the whole dyke (H sinks). Flooding implies both.
   * Times are -1 as long as the event has not come.
   */
  struct FailureRecord
  {
    bool         started             = false;
    double       initial_width       = 0.;  // W_i, m
    double       initial_height      = 0.;  // H_i, m
    double       initial_time        = -1.; // |W - W_i| or H (default), s
    double       initial_time_thesis = -1.; // W < W_i, s
    double       flooding_time       = -1.; // H < h or W = 0, s
    DykeGeometry geometry;                  // the last one measured

    bool
    failed() const
    {
      return initial_time >= 0.;
    }

    bool
    flooded() const
    {
      return flooding_time >= 0.;
    }

    /**
     * @param geometry measured at `time`
     * @param level water level (m)
     * @param has_water without water nothing floods
     */
    void
    update(const DykeGeometry         &geometry,
           const double                time,
           const double                level,
           const bool                  has_water,
           const InitialFailureLimits &limits);

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &started &initial_width &initial_height &initial_time
        &initial_time_thesis &flooding_time &geometry.height &geometry.width;
    }
  };
} // namespace Waker

#endif
