// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/last_change.h>
#include <waker/materials/linear_elastic.h>
#include <waker/simulation/step_control.h>

#include "user_errors.h"
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace simulation_step_control
{
  // The length of steps: halved until they converge, doubled again after four
  // that do.

  using namespace Waker;

  namespace
  {
    struct Surroundings
    {
      Surroundings()
      {
        time.end_time         = 10.;
        time.maximum_halvings = 3;
      }

      /// A step that converges with at most `longest`.
      double
      step(const double longest)
      {
        StepReport<2> report;
        const double  dt = control.solve([]() { return 1.; },
                                        [&](const double dt) {
                                          tried.push_back(dt);
                                          report.converged = dt <= longest;
                                          report.newton_iterations = 2;
                                          report.linear_iterations = 5;
                                          report.residuals         = {0.5};
                                          return report;
                                        });
        control.accept(dt, report);
        return dt;
      }

      TimeParameters      time;
      State<2>            state;
      StepControl<2>      control{time, state};
      std::vector<double> tried;
    };
  } // namespace


  TEST(StepControl, halves_and_doubles)
  {
    Surroundings setup;
    EXPECT_EQ(setup.step(1.), 1.);
    EXPECT_EQ(setup.step(0.3), 0.25);
    EXPECT_EQ(setup.tried, (std::vector<double>{1., 1., 0.5, 0.25}));
    EXPECT_EQ(setup.state.unconverged_steps, 2u);
    // Four good ones in all double it.
    for (unsigned int k = 0; k < 3; ++k)
      EXPECT_EQ(setup.step(1.), 0.25);
    for (unsigned int k = 0; k < 4; ++k)
      EXPECT_EQ(setup.step(1.), 0.5);
    EXPECT_EQ(setup.step(1.), 1.);
    EXPECT_EQ(setup.state.step, 10u);
    EXPECT_EQ(setup.state.time, 1. + 4 * 0.25 + 4 * 0.5 + 1.);
    EXPECT_EQ(setup.state.last_dt, 1.);
    EXPECT_EQ(setup.state.newton_iterations, 24u);
    EXPECT_EQ(setup.state.linear_iterations, 60u);
  }


  TEST(StepControl, good_steps_count_from_the_last_halving)
  {
    Surroundings setup;
    EXPECT_EQ(setup.step(0.5), 0.5);
    EXPECT_EQ(setup.step(0.5), 0.5);
    // The two of 0.5 s are no steps of 0.25 s.
    EXPECT_EQ(setup.step(0.25), 0.25);
    for (unsigned int k = 0; k < 3; ++k)
      EXPECT_EQ(setup.step(1.), 0.25);
    EXPECT_EQ(setup.step(1.), 0.5);
  }


  TEST(StepControl, the_last_step_ends_at_the_end)
  {
    Surroundings setup;
    setup.state.time = 9.7;
    EXPECT_NEAR(setup.step(1.), 0.3, 1e-14);
  }


  TEST(StepControl, gives_up)
  {
    Surroundings setup;
    setup.state.time = 2.;
    try
      {
        setup.step(0.1);
        FAIL() << "no step converges, and nothing is said";
      }
    catch (const NumericalFailure &failure)
      {
        EXPECT_EQ(std::string(failure.what()),
                  "the step from t = 2 s does not converge, not even with dt = "
                  "0.125 s (residual 0.5)");
      }
    EXPECT_EQ(setup.tried.size(), 4u);
    EXPECT_EQ(setup.state.unconverged_steps, 4u);
    EXPECT_EQ(setup.state.time, 2.);
  }


  TEST(StepControl, schemes_answer_questions)
  {
    TimeParameters time;
    for (const bool moves : {true, false})
      {
        time.move_points = moves;
        time.scheme      = Scheme::newmark;
        EXPECT_TRUE(scheme_traits(time).has_inertia);
        EXPECT_TRUE(scheme_traits(time).is_implicit);
        EXPECT_TRUE(scheme_traits(time).moves_points);
        time.scheme = Scheme::explicit_steps;
        EXPECT_TRUE(scheme_traits(time).has_inertia);
        EXPECT_FALSE(scheme_traits(time).is_implicit);
        EXPECT_TRUE(scheme_traits(time).moves_points);
        time.scheme = Scheme::quasi_static;
        EXPECT_FALSE(scheme_traits(time).has_inertia);
        EXPECT_TRUE(scheme_traits(time).is_implicit);
        EXPECT_EQ(scheme_traits(time).moves_points, moves);
      }
  }


  TEST(StepControl, schemes_say_their_first_step)
  {
    // K + 4G/3 = E for nu = 0: waves of sqrt(90 / 2.5) = 6 m/s.
    Materials materials;
    materials.push_back(std::make_unique<LinearElastic>(2.5, 90., 0.));
    TimeParameters time;
    time.time_step      = 0.5;
    time.courant_number = 0.3;
    time.scheme         = Scheme::newmark;
    EXPECT_EQ(first_time_step(time, materials, 0.2), 0.5);
    EXPECT_NEAR(chosen_courant_number(time, materials, 0.2).value_or(0.),
                15.,
                1e-13);
    time.scheme = Scheme::explicit_steps;
    EXPECT_NEAR(first_time_step(time, materials, 0.2), 0.01, 1e-16);
    EXPECT_FALSE(chosen_courant_number(time, materials, 0.2));
    time.scheme = Scheme::quasi_static;
    EXPECT_EQ(first_time_step(time, materials, 0.2), 0.5);
    EXPECT_FALSE(chosen_courant_number(time, materials, 0.2));

    time.load_duration = 4.;
    EXPECT_EQ(full_loads_from(time), 4.);
    EXPECT_NO_THROW(require_implicit(time, "there is a test"));
    time.scheme = Scheme::newmark;
    EXPECT_EQ(full_loads_from(time), LastChange::never);
    time.scheme = Scheme::explicit_steps;
    EXPECT_USER_ERROR(require_implicit(time, "there is a test"),
                      "Time stepping/Scheme",
                      "explicit, but there is a test");
    try
      {
        require_implicit(time, "");
      }
    catch (const UserError &error)
      {
        EXPECT_EQ(error.allowed,
                  "Newmark, quasi-static or quasi-static at rest");
      }
  }
} // namespace simulation_step_control
