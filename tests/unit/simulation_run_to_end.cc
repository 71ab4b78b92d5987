// SPDX-License-Identifier: LGPL-2.1-or-later
// The loop over a run, and the one that tries again.
#include <waker/simulation/attempts.h>
#include <waker/simulation/run_to_end.h>

#include "loaded_bar.h"
#include <gtest/gtest.h>

namespace simulation_run_to_end
{
  using namespace Waker;

  namespace
  {
    /// Counts, and interrupts after so many steps.
    class Counter : public Watcher
    {
    public:
      explicit Counter(const unsigned int most)
        : most(most)
      {}

      void
      looked(const StopReason stop, const bool is_last) override
      {
        ++n_looks;
        n_last += is_last;
        last = stop;
      }

      void
      advanced() override
      {
        ++n_steps;
        signal = n_steps == most;
      }

      const unsigned int most;
      unsigned int       n_looks = 0, n_steps = 0, n_last = 0;

      volatile std::sig_atomic_t signal = 0;
      StopReason                 last   = StopReason::flooding;
    };


    Parameters
    five_steps()
    {
      LoadedBar bar(1.3);
      bar.parameters.time.time_step = 0.01;
      bar.parameters.time.end_time  = 0.05;
      return bar.parameters;
    }
  } // namespace


  TEST(Simulation, run_to_end_looks_and_steps_in_turn)
  {
    const Case<2>  the_case(five_steps(), MPI_COMM_SELF);
    State<2>       state = initial_state(the_case);
    Realisation<2> realisation(the_case, state);
    Counter        all(100);
    EXPECT_EQ(run_to_end(realisation, all, &all.signal), StopReason::end_time);
    EXPECT_EQ(all.n_steps, 5u);
    EXPECT_EQ(all.n_looks, 6u);
    EXPECT_EQ(all.n_last, 1u);
    EXPECT_EQ(all.last, StopReason::end_time);
    EXPECT_EQ(state.step, 5u);
  }


  TEST(Simulation, run_to_end_can_be_interrupted)
  {
    const Case<2>  the_case(five_steps(), MPI_COMM_SELF);
    State<2>       state = initial_state(the_case);
    Realisation<2> realisation(the_case, state);
    Counter        two(2);
    EXPECT_EQ(run_to_end(realisation, two, &two.signal), StopReason::none);
    EXPECT_EQ(state.step, 2u);
    EXPECT_EQ(two.n_looks, 3u);
    EXPECT_EQ(two.n_last, 1u); // it knows, and can keep what there is
    EXPECT_EQ(two.last, StopReason::none);
    // And gone on with.
    EXPECT_EQ(run_to_end(realisation), StopReason::end_time);
    EXPECT_EQ(state.step, 5u);
  }


  TEST(Simulation, attempts_end_with_the_first_that_works)
  {
    const auto last = [](const unsigned int first,
                         const unsigned int n,
                         const unsigned int good,
                         unsigned int      &n_made) {
      n_made = 0;
      return attempt_until_it_works(first, n, [&](const unsigned int attempt) {
        ++n_made;
        return attempt == good;
      });
    };
    unsigned int n = 0;
    EXPECT_EQ(last(0, 3, 0, n), 0u);
    EXPECT_EQ(n, 1u);
    EXPECT_EQ(last(0, 3, 1, n), 1u);
    EXPECT_EQ(n, 2u);
    EXPECT_EQ(last(0, 3, 7, n), 2u);
    EXPECT_EQ(n, 3u);
    EXPECT_EQ(last(1, 3, 7, n), 2u);
    EXPECT_EQ(n, 2u);
    EXPECT_EQ(last(0, 1, 7, n), 0u);
    EXPECT_EQ(n, 1u);
    EXPECT_EQ(time_step_of_attempt(0.01, 0), 0.01);
    EXPECT_EQ(time_step_of_attempt(0.01, 3), 0.00125);
  }
} // namespace simulation_run_to_end
