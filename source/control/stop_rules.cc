// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/control/stop_rules.h>

#include <algorithm>

namespace Waker
{
  std::string
  to_string(const StopReason reason)
  {
    switch (reason)
      {
        case StopReason::none:
          return "running";
        case StopReason::flooding:
          return "flooded";
        case StopReason::initial_failure:
          return "initial failure";
        case StopReason::stable_at_rest:
          return "never failed and at rest";
        case StopReason::failed_at_rest:
          return "failed and at rest";
        case StopReason::end_time:
          return "end time";
      }
    return "";
  }


  bool
  is_at_rest(const StopParameters &parameters,
             const RestRecord     &rest,
             const double          time)
  {
    // Round-off in the sum of the steps must not make it move.
    return rest.since >= 0. &&
           time - rest.since >= parameters.rest_duration * (1. - 1e-9);
  }


  StopReason
  decide(const StopParameters &parameters,
         const FailureRecord  &failure,
         const double          time,
         const double          end_time,
         const double          settling_time,
         const double          loads_settle_at,
         const double          mean_plastic_strain,
         const double          displacement_rate,
         RestRecord           &rest)
  {
    const bool rests = time > settling_time &&
                       mean_plastic_strain < parameters.rest_plastic_strain &&
                       displacement_rate < parameters.rest_velocity;
    if (!rests)
      rest.since = -1.;
    else if (rest.since < 0.)
      rest.since = time;

    if (parameters.on_flooding && failure.flooded())
      return StopReason::flooding;
    if (parameters.on_initial_failure &&
        failure.time_of(parameters.reading) >= 0.)
      return StopReason::initial_failure;
    if (parameters.at_rest && rests &&
        time - std::max(rest.since, loads_settle_at) >=
          parameters.rest_duration)
      return failure.failed() || failure.flooded() ? StopReason::failed_at_rest
                                                   : StopReason::stable_at_rest;
    // Round-off in the sum of the steps must not add a step.
    if (time >= end_time * (1. - 1e-12))
      return StopReason::end_time;
    return StopReason::none;
  }
} // namespace Waker
