// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/simulation/judge_trial.h>

#include <gtest/gtest.h>

namespace simulation_judge_trial
{
  using namespace Waker;

  namespace
  {
    Trial
    judge(const FailureRecord &failure,
          const Unrest        &unrest,
          const FailureReading reading = FailureReading::by_displacement)
    {
      StrengthReductionParameters parameters;
      parameters.reading = reading;
      return judge_trial(failure, unrest, parameters, 9.);
    }
  } // namespace


  TEST(Simulation, trial_that_has_not_failed_is_stable_only_at_its_end)
  {
    EXPECT_EQ(judge({}, {}).result, TrialResult::stable);
    EXPECT_EQ(judge({}, {}).outcome, Outcome::stable);
    EXPECT_EQ(judge({}, {}).time, 9.);
    Unrest unrest;
    unrest.loads_change = true;
    EXPECT_EQ(judge({}, unrest).result, TrialResult::undecided);
    EXPECT_EQ(judge({}, unrest).outcome, Outcome::loads_change);

    // Another reading than the one that counts.
    FailureRecord failure;
    failure.initial_time = 3.;
    EXPECT_EQ(judge(failure, {}).result, TrialResult::stable);
    const Trial trial = judge(failure, {}, FailureReading::any);
    EXPECT_EQ(trial.result, TrialResult::failed);
    EXPECT_EQ(trial.time, 3.);
    EXPECT_EQ(trial.reading, FailureReading::by_geometry);
  }


  // Water that rises over a dyke, and goes on rising.
  TEST(Simulation, trial_that_is_flooded_has_failed)
  {
    FailureRecord failure;
    failure.flooding_time = 4.;
    Unrest unrest;
    for (const bool change : {false, true})
      {
        unrest.loads_change = unrest.moving = unrest.at_box = change;
        for (const FailureReading reading :
             {FailureReading::by_displacement, FailureReading::any})
          {
            const Trial trial = judge(failure, unrest, reading);
            EXPECT_EQ(trial.result, TrialResult::failed);
            EXPECT_EQ(trial.time, 4.);
            EXPECT_EQ(trial.outcome, Outcome::flooding);
            EXPECT_FALSE(trial.reading);
          }
      }
    // The reading that saw it first says when.
    failure.initial_time = 3.;
    EXPECT_EQ(judge(failure, unrest, FailureReading::any).time, 3.);
  }
} // namespace simulation_judge_trial
