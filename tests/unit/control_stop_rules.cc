// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/last_change.h>
#include <waker/control/stop_rules.h>

#include <gtest/gtest.h>
#include <set>
#include <string>

namespace control_stop_rules
{
  using namespace Waker;

  namespace
  {
    FailureRecord
    failed_at(const double time)
    {
      FailureRecord record;
      record.started      = true;
      record.initial_time = time;
      return record;
    }


    FailureRecord
    flooded_at(const double time)
    {
      FailureRecord record = failed_at(time);
      record.flooding_time = time;
      return record;
    }


    /// Decisions with the default limits: 1e-6 and 0.05 m/s for 1 s, after 1 s.
    struct Rules
    {
      StopReason operator()(const double         time,
                            const double         plastic_strain,
                            const double         rate,
                            const FailureRecord &failure = {})
      {
        return decide(parameters,
                      failure,
                      time,
                      40.,
                      1.,
                      last_load_change,
                      plastic_strain,
                      rate,
                      rest);
      }

      double last_load_change = LastChange::never;

      StopParameters parameters;
      RestRecord     rest;
    };

    constexpr double still = 0.5e-6, slow = 0.04, plastic = 2e-6, fast = 0.06;
  } // namespace


  TEST(Control, a_dyke_at_rest_for_the_whole_window_ends_the_run)
  {
    Rules rules;
    for (int n = 101; n < 201; ++n)
      ASSERT_EQ(rules(0.01 * n, still, slow), StopReason::none) << n;
    EXPECT_NEAR(rules.rest.since, 1.01, 1e-14);
    EXPECT_EQ(rules(2.02, still, slow), StopReason::stable_at_rest);

    // The same, having failed before.
    Rules after_failure;
    EXPECT_EQ(after_failure(5., still, slow, failed_at(3.)), StopReason::none);
    EXPECT_EQ(after_failure(6.1, still, slow, failed_at(3.)),
              StopReason::failed_at_rest);

    // Flooded without a slide: the outcome is a failure, and so is the reason.
    Rules flooded;
    flooded.parameters.on_flooding = false;
    FailureRecord only_flooded;
    only_flooded.flooding_time = 3.;
    EXPECT_EQ(flooded(5., still, slow, only_flooded), StopReason::none);
    EXPECT_EQ(flooded(6.1, still, slow, only_flooded),
              StopReason::failed_at_rest);
  }


  TEST(Control, any_movement_starts_the_window_again)
  {
    for (const bool by_strain : {true, false})
      {
        Rules rules;
        EXPECT_EQ(rules(2., still, slow), StopReason::none);
        EXPECT_EQ(rules(2.9, still, slow), StopReason::none);
        EXPECT_EQ(rules(2.95,
                        by_strain ? plastic : still,
                        by_strain ? slow : fast),
                  StopReason::none);
        EXPECT_EQ(rules.rest.since, -1.);
        EXPECT_EQ(rules(3.1, still, slow), StopReason::none); // 1.1 s after 2 s
        EXPECT_EQ(rules(4.05, still, slow), StopReason::none);
        EXPECT_EQ(rules(4.2, still, slow), StopReason::stable_at_rest);
      }
    // A limit that is met exactly is not below it.
    Rules rules;
    rules(2., 1e-6, slow);
    EXPECT_EQ(rules.rest.since, -1.);
    rules(2., still, 0.05);
    EXPECT_EQ(rules.rest.since, -1.);
  }


  TEST(Control, the_ramp_is_no_rest)
  {
    // While the unbalanced force grows, nothing moves yet: that is no rest.
    Rules rules;
    for (double t = 0.; t <= 1.; t += 0.1)
      EXPECT_EQ(rules(t, 0., 0.), StopReason::none);
    EXPECT_EQ(rules.rest.since, -1.);
    EXPECT_EQ(rules(1.05, 0., 0.), StopReason::none);
    EXPECT_EQ(rules(2., 0., 0.), StopReason::none);
    EXPECT_EQ(rules(2.06, 0., 0.), StopReason::stable_at_rest);
  }


  TEST(Control, flooding_and_initial_failure_end_a_run_if_they_may)
  {
    Rules rules;
    EXPECT_EQ(rules(5., plastic, fast, failed_at(4.)), StopReason::none);
    EXPECT_EQ(rules(5., plastic, fast, flooded_at(5.)), StopReason::flooding);
    rules.parameters.on_initial_failure = true;
    EXPECT_EQ(rules(5., plastic, fast, failed_at(4.)),
              StopReason::initial_failure);
    EXPECT_EQ(rules(5., plastic, fast, flooded_at(5.)), StopReason::flooding);
    EXPECT_EQ(rules(5., plastic, fast), StopReason::none);
    rules.parameters.on_flooding = rules.parameters.on_initial_failure = false;
    EXPECT_EQ(rules(5., plastic, fast, flooded_at(5.)), StopReason::none);
  }


  TEST(Control, rest_may_be_switched_off)
  {
    Rules rules;
    rules.parameters.at_rest = false;
    EXPECT_EQ(rules(2., still, slow), StopReason::none);
    EXPECT_EQ(rules(9., still, slow), StopReason::none);
    EXPECT_EQ(rules(40., still, slow), StopReason::end_time);
  }


  TEST(Control, the_end_time_is_met_in_spite_of_round_off)
  {
    Rules  rules;
    double time = 0.;
    for (unsigned int n = 0; n < 4000; ++n)
      {
        ASSERT_EQ(rules(time, plastic, fast), StopReason::none);
        time += 0.01;
      }
    EXPECT_NE(time, 40.); // the sum is not exact
    EXPECT_EQ(rules(time, plastic, fast), StopReason::end_time);
    EXPECT_EQ(rules(40. - 1e-13, plastic, fast), StopReason::end_time);
    EXPECT_EQ(rules(39.99, plastic, fast), StopReason::none);
    EXPECT_EQ(rules(40.01, plastic, fast), StopReason::end_time);
  }


  TEST(Control, no_rest_before_the_loads_are_constant)
  {
    Rules rules;
    rules.last_load_change = 5.;
    EXPECT_EQ(rules(2., still, slow), StopReason::none);
    EXPECT_EQ(rules(5., still, slow), StopReason::none);
    EXPECT_EQ(rules(5.95, still, slow), StopReason::none);
    EXPECT_EQ(rules.rest.since, 2.);
    EXPECT_EQ(rules(6., still, slow), StopReason::stable_at_rest);
    EXPECT_EQ(rules(6., still, slow, failed_at(3.)),
              StopReason::failed_at_rest);
    // What moves after that rests later.
    EXPECT_EQ(rules(7., still, fast), StopReason::none);
    EXPECT_EQ(rules(8., still, slow), StopReason::none);
    EXPECT_EQ(rules(9., still, slow), StopReason::stable_at_rest);

    rules.last_load_change = LastChange::unknown;
    EXPECT_EQ(rules(39., still, slow), StopReason::none);
    EXPECT_EQ(rules(40., still, slow), StopReason::end_time);
  }


  TEST(Control, a_window_survives_a_checkpoint)
  {
    // The record is all that a rule remembers: a copy goes on as the original.
    Rules rules;
    rules(2., still, slow);
    Rules resumed;
    resumed.rest = rules.rest;
    EXPECT_EQ(resumed(3.1, still, slow), StopReason::stable_at_rest);
  }


  TEST(Control, every_reason_has_words)
  {
    std::set<std::string> words;
    for (const StopReason reason : {StopReason::none,
                                    StopReason::flooding,
                                    StopReason::initial_failure,
                                    StopReason::stable_at_rest,
                                    StopReason::failed_at_rest,
                                    StopReason::end_time})
      {
        EXPECT_FALSE(to_string(reason).empty());
        EXPECT_TRUE(words.insert(to_string(reason)).second)
          << to_string(reason);
      }
  }
} // namespace control_stop_rules
