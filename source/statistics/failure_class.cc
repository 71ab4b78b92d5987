// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/statistics/failure_class.h>

#include <cmath>
#include <iterator>

namespace Waker
{
  namespace
  {
    bool
    overflows(const Record &record)
    {
      const double failure = record.time_of(FailureReading::any);
      return record.flooded() &&
             !(failure >= 0. && failure <= record.flooding_time);
    }


    /// Without any body that has moved.
    bool
    only_settles(const Record &record)
    {
      return record.watches_slopes() && record.slope() == Slopes::none &&
             record.first_inward.area == 0. &&
             record.first_outward.area == 0. && record.inward.area == 0. &&
             record.outward.area == 0.;
    }


    bool
    goes_outwards(const Record &record)
    {
      if (record.watches_slopes() && record.slope() != Slopes::both)
        return record.slope() == Slopes::outer;
      if (record.first_outward.area != record.first_inward.area)
        return record.first_outward.area > record.first_inward.area;
      if (record.outward.area != record.inward.area)
        return record.outward.area > record.inward.area;
      if (record.watches_slopes())
        return record.outer_slide.time < record.inner_slide.time;
      return record.residual_width > record.initial_width;
    }


    /// Geometry at the beginning of the last slide.
    TracePoint
    before_last(const Record &record, const std::vector<Slide> &slides)
    {
      if (slides.size() < 2)
        return {0., record.initial_width, record.initial_height};
      const Slide &slide = *std::prev(slides.end(), 2);
      return {slide.end, slide.width, slide.height};
    }


    bool
    keeps_width(const Record &record, const std::vector<Slide> &slides)
    {
      const TracePoint before = before_last(record, slides);
      double           width  = record.residual_width;
      if (slides.back().floods)
        {
          // W is 0 at flooding, so look at it half way down
          const double half = 0.5 * (before.height + slides.back().height);
          for (const TracePoint &point : record.trace)
            if (point.time >= before.time && point.height > half)
              width = point.width;
        }
      return width >= FailureClassLimits::kept_width * before.width;
    }


    bool
    is_translated(const Record             &record,
                  const std::vector<Slide> &slides,
                  const double              base_level)
    {
      const MovedSoil &soil = record.inward;
      return soil.area > 0. &&
             soil.area >= FailureClassLimits::moved_area *
                            record.initial_width *
                            (record.initial_height - base_level) &&
             std::abs(soil.dy) <=
               FailureClassLimits::fall * std::abs(soil.dx) &&
             keeps_width(record, slides);
    }
  } // namespace


  std::string
  to_string(const FailureClass failure_class)
  {
    switch (failure_class)
      {
        case FailureClass::none:
          return "none";
        case FailureClass::initial_only:
          return "initial only";
        case FailureClass::retrogressive:
          return "retrogressive";
        case FailureClass::horizontal:
          return "horizontal";
        case FailureClass::outer:
          return "outer";
        case FailureClass::settled:
          return "settled";
        case FailureClass::overflow:
          return "overflow";
      }
    return "";
  }


  FailureClass
  classify(const Record             &record,
           const std::vector<Slide> &slides,
           const double              base_level)
  {
    if (overflows(record))
      return FailureClass::overflow;
    if (!record.failed())
      return FailureClass::none;
    // The geometry has not changed.
    if (slides.empty())
      return record.slope() == Slopes::outer ? FailureClass::outer
                                             : FailureClass::initial_only;
    if (goes_outwards(record))
      return FailureClass::outer;
    if (only_settles(record))
      return FailureClass::settled;
    if (is_translated(record, slides, base_level))
      return FailureClass::horizontal;
    return slides.size() > 1 ? FailureClass::retrogressive
                             : FailureClass::initial_only;
  }
} // namespace Waker
