// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_judge_trial_h
#define waker_simulation_judge_trial_h

#include <waker/case/parameters.h>
#include <waker/control/outcome.h>
#include <waker/simulation/trial_table.h>

namespace Waker
{
  /**
   * What the end of a realisation says of its factor, by the reading that the
   * search stops at. What is flooded has failed, whatever the reading sees and
   * the loads do afterwards. Anything else that has not failed is stable only
   * if nothing would have gone on.
   *
   * @param end_time of the realisation (s)
   */
  Trial
  judge_trial(const FailureRecord               &failure,
              const Unrest                      &unrest,
              const StrengthReductionParameters &parameters,
              const double                       end_time);
} // namespace Waker

#endif
