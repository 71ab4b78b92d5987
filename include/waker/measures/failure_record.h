// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_measures_failure_record_h
#define waker_measures_failure_record_h

#include <waker/measures/dyke_geometry.h>
#include <waker/measures/moving_body.h>

namespace Waker
{
  struct InitialFailureLimits
  {
    double width_change = 0.3;  // m
    double height_loss  = 0.1;  // m
    double distance     = 0.09; // m
    double share        = 0.02; // of the profile
  };

  /// What a failure is read off; `any`: by_geometry or by_displacement.
  enum class FailureReading
  {
    by_displacement,
    by_geometry,
    by_width,
    any
  };

  constexpr const char *
  name_of(const FailureReading reading)
  {
    switch (reading)
      {
        case FailureReading::by_displacement:
          return "displacement";
        case FailureReading::by_geometry:
          return "width or height";
        case FailureReading::by_width:
          return "width";
        case FailureReading::any:
          return "any";
      }
    return nullptr;
  }

  /// The slopes that have slid. The inner one falls away from the water.
  enum class Slopes
  {
    none,
    inner,
    outer,
    both
  };

  constexpr const char *
  name_of(const Slopes slopes)
  {
    switch (slopes)
      {
        case Slopes::none:
          return "";
        case Slopes::inner:
          return "inner";
        case Slopes::outer:
          return "outer";
        case Slopes::both:
          return "both";
      }
    return nullptr;
  }

  /// A slide of one slope, as it was when it was seen.
  struct SlopeSlide
  {
    double     time = -1.; // s; -1: has not slid, NaN: was not watched
    MovingBody body;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &time &body;
    }
  };

  /**
   * When a dyke failed. Initial failure in three readings, all recorded: the
   * thesis's, W below its initial value; by geometry, which also sees slides
   * outwards (W grows) and slides of the whole dyke (H sinks); and by
   * displacement, which sees those that leave the width at the water level and
   * the highest point where they are. Flooding implies the first two, unless it
   * is the water that has risen.
   *
   * The inner slope falls away from the water; without water it is the one
   * towards positive x. Times are -1 as long as the event has not come.
   */
  struct FailureEvents
  {
    double     initial_time        = -1.; // |W - W_i| or H, s
    double     initial_time_thesis = -1.; // W < W_i, s
    double     flooding_time       = -1.; // H < h or W = 0, s
    SlopeSlide inner_slide;               // by displacement
    SlopeSlide outer_slide;

    /// Initial failure in this reading (s), or -1.
    double
    time_of(const FailureReading reading) const;

    /// In any reading.
    bool
    failed() const
    {
      return time_of(FailureReading::any) >= 0.;
    }

    bool
    flooded() const
    {
      return flooding_time >= 0.;
    }

    /// Which slope has slid, by displacement.
    Slopes
    slope() const;
  };

  /**
   * Watches for these events, relative to the geometry detected first, never
   * to a nominal one: the detected surface lies a little off the drawn one.
   */
  struct FailureRecord : FailureEvents
  {
    bool         started        = false;
    double       initial_width  = 0.; // W_i, m; NaN: not measured
    double       initial_height = 0.; // H_i, m, on the vertical axis
    double       initial_level  = 0.; // of the water, m
    DykeGeometry geometry;            // the last one measured

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

    /**
     * The reading by displacement, of slopes that have not slid before.
     *
     * @param inner +1 or -1: along x, the direction away from the water
     */
    template <int dim>
    void
    watch_slopes(const std::common_type_t<Body<dim>> &body,
                 const BackgroundGrid<dim>           &grid,
                 const int                            inner,
                 const double                         time,
                 const InitialFailureLimits          &limits);

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &started &initial_width &initial_height &initial_level
        &initial_time &initial_time_thesis &flooding_time &inner_slide
          &outer_slide &geometry.height &geometry.width &geometry
            .height_z                                   &geometry.width_z;
    }
  };
} // namespace Waker

#endif
