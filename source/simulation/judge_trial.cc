// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/simulation/judge_trial.h>

namespace Waker
{
  Trial
  judge_trial(const FailureRecord               &failure,
              const Unrest                      &unrest,
              const StrengthReductionParameters &parameters,
              const double                       end_time)
  {
    Trial        trial;
    const double time = failure.time_of(parameters.reading);
    if (time < 0. && !failure.flooded())
      {
        trial.result =
          unrest.is_final() ? TrialResult::stable : TrialResult::undecided;
        trial.time    = end_time;
        trial.outcome = outcome_of(FailureRecord(), unrest);
        return trial;
      }
    trial.result  = TrialResult::failed;
    trial.time    = time < 0. ? failure.flooding_time : time;
    trial.outcome = outcome_of(failure, unrest);
    if (time < 0.)
      return trial; // no reading has seen it
    const bool moved = failure.time_of(FailureReading::by_displacement) == time;
    trial.reading    = parameters.reading != FailureReading::any
                         ? parameters.reading
                       : moved ? FailureReading::by_displacement
                               : FailureReading::by_geometry;
    trial.slope      = failure.slope();
    return trial;
  }
} // namespace Waker
