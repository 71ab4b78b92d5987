// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/measures/failure_record.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// The earlier of two times; -1 (or NaN) is none.
    double
    first_of(const double a, const double b)
    {
      if (a >= 0. && b >= 0.)
        return std::min(a, b);
      return a >= 0. ? a : b >= 0. ? b : -1.;
    }
  } // namespace


  double
  FailureEvents::time_of(const FailureReading reading) const
  {
    const double by_displacement = first_of(inner_slide.time, outer_slide.time);
    switch (reading)
      {
        case FailureReading::any:
          return first_of(initial_time, by_displacement);
        case FailureReading::by_displacement:
          return by_displacement;
        case FailureReading::by_geometry:
          return initial_time;
        case FailureReading::by_width:
          return initial_time_thesis;
      }
    Assert(false, dealii::ExcInternalError());
    return -1.;
  }


  Slopes
  FailureEvents::slope() const
  {
    if (inner_slide.time >= 0.)
      return outer_slide.time >= 0. ? Slopes::both : Slopes::inner;
    return outer_slide.time >= 0. ? Slopes::outer : Slopes::none;
  }


  void
  FailureRecord::update(const DykeGeometry         &measured,
                        const double                time,
                        const double                level,
                        const bool                  has_water,
                        const InitialFailureLimits &limits)
  {
    geometry = measured;
    if (!started)
      {
        started        = true;
        initial_width  = geometry.width;
        initial_height = geometry.height;
        initial_level  = level;
        return;
      }

    // W = 0 says that the soil does not rise above the level of W; water that
    // has sunk below that level stands lower still.
    const bool floods =
      has_water && (geometry.height < level ||
                    (geometry.width == 0. && !(level < geometry.level)));
    if (floods && flooding_time < 0.)
      flooding_time = time;

    // Water that rises over a dyke which stands is no failure of the dyke.
    const bool   sinks  = floods && !(level > initial_level);
    const double change = geometry.width - initial_width;
    if (initial_time_thesis < 0. && (change < -limits.width_change || sinks))
      initial_time_thesis = time;
    if (initial_time < 0. &&
        (std::abs(change) > limits.width_change ||
         geometry.height < initial_height - limits.height_loss || sinks))
      initial_time = time;
  }


  template <int dim>
  void
  FailureRecord::watch_slopes(const std::common_type_t<Body<dim>> &body,
                              const BackgroundGrid<dim>           &grid,
                              const int                            inner,
                              const double                         time,
                              const InitialFailureLimits          &limits)
  {
    for (SlopeSlide *const slide : {&inner_slide, &outer_slide})
      if (slide->time < 0.)
        {
          const int        direction = slide == &inner_slide ? inner : -inner;
          const MovingBody slid      = largest_moving_body(
            body, grid, direction, limits.distance, limits.share);
          if (slid.distance > limits.distance && slid.share > limits.share)
            *slide = {time, slid};
        }
  }


  template void
  FailureRecord::watch_slopes(const Body<2> &,
                              const BackgroundGrid<2> &,
                              const int,
                              const double,
                              const InitialFailureLimits &);
  template void
  FailureRecord::watch_slopes(const Body<3> &,
                              const BackgroundGrid<3> &,
                              const int,
                              const double,
                              const InitialFailureLimits &);
} // namespace Waker
