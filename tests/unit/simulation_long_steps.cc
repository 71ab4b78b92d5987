// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/loads/water_level.h>
#include <waker/mechanics/energy.h>
#include <waker/simulation/plausibility.h>
#include <waker/simulation/run_to_end.h>

#include "campaign_random_dyke.h"
#include "long_steps.h"
#include "user_errors.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace simulation_long_steps
{
  // Long quasi-static steps while a dyke rests, short ones while it moves: when
  // which, and that what comes out does not hang on their length.

  using namespace Waker;
  using namespace RandomDyke;
  using namespace LongStepsOfADyke;

  namespace
  {
    /// A scheme of long steps of 64 s, of which those longer than `longest`,
    /// and short ones that all converge.
    struct Surroundings
    {
      Surroundings()
      {
        time.scheme             = Scheme::static_at_rest;
        time.time_step          = 0.5;
        time.longest_step       = 64.;
        time.end_time           = 1e6;
        time.maximum_halvings   = 3;
        control                 = std::make_unique<StepControl<2>>(time, state);
        state.long_steps.active = true;
      }

      double
      step(const double longest)
      {
        StepReport<2> report;
        const double  dt = control->solve(
          [&]() {
            return control->is_long() ? time.longest_step : time.time_step;
          },
          [&](const double tried) {
            ++attempts;
            report.converged = !control->is_long() || tried <= longest;
            report.residuals = {0.5};
            report.mean_plastic_strain = 0.1;
            report.displacement_rate   = 0.2;
            return report;
          });
        control->accept(dt, report);
        return dt;
      }

      TimeParameters                  time;
      State<2>                        state;
      std::unique_ptr<StepControl<2>> control;
      unsigned int                    attempts = 0;
    };


    struct Result
    {
      State<2>   state;
      StopReason reason;
      double     final_level;
    };


    Result
    run(const std::vector<std::string> &given,
        const std::vector<std::string> &more = {})
    {
      const auto     input = coarse(with(given, more));
      const Case<2>  the_case(input->simulation, MPI_COMM_SELF);
      Result         result{initial_state(the_case), StopReason::none, 0.};
      Realisation<2> realisation(the_case, result.state);
      result.reason = run_to_end(realisation);
      result.final_level =
        WaterLevel(the_case.parameters.water).at(result.state.time);
      EXPECT_TRUE(realisation.unrest().is_final() ||
                  result.reason == StopReason::flooding);
      return result;
    }


    /// rms difference of the stresses of a and b by the rms stress of b, away
    /// from the surface: at nodes that are hardly touched they have no one
    /// answer.
    double
    stress_difference(const State<2> &a, const State<2> &b)
    {
      double      square = 0., whole = 0.;
      std::size_t n = 0;
      for (std::size_t p = 0; p < b.points.n_points(); ++p)
        {
          const Point<2> &x = b.points.initial_position[p];
          if (x[1] > std::min({x[0] / 2.4, (30. - x[0]) / 2.4, 5.}) - 1.)
            continue;
          ++n;
          square +=
            std::pow((a.points.stress[p] - b.points.stress[p]).norm(), 2);
          whole += std::pow(b.points.stress[p].norm(), 2);
        }
      EXPECT_GT(n, 500u);
      return std::sqrt(square / whole);
    }
  } // namespace


  TEST(LongSteps, give_way_to_short_ones_and_come_back)
  {
    Surroundings     setup;
    const LongSteps &record = setup.state.long_steps;
    EXPECT_EQ(setup.step(100.), 64.);
    EXPECT_EQ(setup.step(20.), 16.);
    EXPECT_EQ(setup.attempts, 4u);
    // A step in balance is one at rest.
    EXPECT_EQ(setup.state.mean_plastic_strain, 0.);
    EXPECT_EQ(setup.state.displacement_rate, 0.);
    EXPECT_EQ(record.motions, 0u);

    // 16 s and 8 s do not converge: it moves.
    setup.state.rest.since = 1.;
    EXPECT_EQ(setup.step(1.), 0.5);
    EXPECT_EQ(setup.attempts, 7u);
    EXPECT_EQ(setup.state.rest.since, -1.);
    EXPECT_EQ(setup.state.displacement_rate, 0.2);
    EXPECT_FALSE(record.active);
    EXPECT_EQ(record.motions, 1u);
    EXPECT_EQ(record.n, 2u);
    EXPECT_EQ(record.time, 80.);
    EXPECT_EQ(setup.state.time, 80.5);

    // Not before twice the rest of a second, the shortest first.
    setup.control->try_long_steps(1.);
    EXPECT_FALSE(record.active);
    for (unsigned int k = 0; k < 3; ++k)
      setup.step(1.);
    setup.control->try_long_steps(1.);
    EXPECT_TRUE(record.active);
    EXPECT_EQ(setup.control->next(64.), 8.);

    // They fail again, at once: the wait doubles, and nothing new moves.
    setup.attempts = 0;
    EXPECT_EQ(setup.step(1.), 0.5);
    EXPECT_EQ(setup.attempts, 2u);
    EXPECT_EQ(record.motions, 1u);
    for (unsigned int k = 0; k < 7; ++k)
      {
        setup.control->try_long_steps(1.);
        EXPECT_EQ(record.active, false) << k;
        setup.step(1.);
      }
    setup.control->try_long_steps(1.);
    EXPECT_TRUE(record.active);
    EXPECT_EQ(record.failures, 2u);
    for (unsigned int k = 0; k < 4; ++k)
      EXPECT_EQ(setup.step(100.), 8.);
    EXPECT_EQ(record.failures, 0u);
    EXPECT_EQ(setup.step(100.), 16.);
  }


  TEST(LongSteps, are_not_tried_with_other_schemes)
  {
    Surroundings setup;
    setup.time.scheme             = Scheme::newmark;
    setup.state.long_steps.active = false;
    StepControl<2> control(setup.time, setup.state);
    setup.state.time = 1e4;
    control.try_long_steps(1.);
    EXPECT_FALSE(control.is_long());
    EXPECT_TRUE(scheme_traits(setup.time).has_inertia);
    EXPECT_FALSE(scheme_traits(setup.time).has_long_steps);
    setup.time.scheme = Scheme::static_at_rest;
    EXPECT_TRUE(scheme_traits(setup.time).has_inertia);
    EXPECT_TRUE(scheme_traits(setup.time).is_implicit);
    EXPECT_TRUE(scheme_traits(setup.time).moves_points);
    EXPECT_TRUE(scheme_traits(setup.time).has_long_steps);
  }


  TEST(LongSteps, follow_the_water)
  {
    WaterParameters water;
    water.side  = WaterSide::left;
    water.level = 1.;
    water.rise  = "0: 0, 100: 1, 150: 1, 160: 0.5";
    const WaterLevel table(water);
    EXPECT_NEAR(table.longest_step(0., 300., 0.05, 0.01), 5., 1e-9);
    EXPECT_NEAR(table.longest_step(0., 2., 0.05, 0.01), 2., 1e-12);
    EXPECT_NEAR(table.longest_step(98., 300., 0.05, 0.01), 2., 1e-9);
    EXPECT_NEAR(table.longest_step(100., 300., 0.05, 0.01), 50., 1e-9);
    EXPECT_NEAR(table.longest_step(100. - 1e-10, 300., 0.05, 0.01), 50., 1e-8);
    EXPECT_NEAR(table.longest_step(150., 300., 0.05, 0.01), 1., 1e-9);
    EXPECT_EQ(table.longest_step(160., 300., 0.05, 0.01), 300.);
    // It jumps: one short step, whatever the limit.
    water.rise = "0: 0, 1: 0, 1.001: 1";
    EXPECT_EQ(WaterLevel(water).longest_step(1., 300., 0.05, 0.01), 0.01);
    EXPECT_NEAR(WaterLevel(water).longest_step(0., 300., 0.05, 0.01), 1., 1e-9);
    // One that swings is asked at many moments, not at the end alone.
    water.rise = "0.2*sin(2*pi*t/100)";
    const WaterLevel swinging(water);
    const double     step = swinging.longest_step(0., 100., 0.05, 0.01);
    EXPECT_LE(swinging.at(step) - 1., 0.05 * (1. + 1e-6));
    EXPECT_GT(step, 2.);
    EXPECT_LT(step, 4.1); // asin(1/4) / (2 pi) * 100 = 4.02
    water.side = WaterSide::none;
    EXPECT_EQ(WaterLevel(water).longest_step(0., 300., 0.05, 0.01), 300.);

    const TimeFunction rise("0: 0, 5: 2, 7: 2, 9: 1", "Water/Rise");
    EXPECT_EQ(rise.next_corner(-1.), 0.);
    EXPECT_EQ(rise.next_corner(0.), 5.);
    EXPECT_EQ(rise.next_corner(9.), std::numeric_limits<double>::infinity());
    EXPECT_EQ(rise.time_of_largest(), 5.);
    EXPECT_EQ(TimeFunction("sin(t)", "Water/Rise").time_of_largest(), 0.);
    EXPECT_EQ(TimeFunction("sin(t)", "Water/Rise").next_corner(0.),
              std::numeric_limits<double>::infinity());
  }


  // Strong clay: a storm that comes and goes leaves nothing, and a level has
  // one answer, whatever way led to it.
  TEST(LongSteps, of_elastic_soil_know_no_path)
  {
    // Stiff: what is left is of the second order in the displacements, as the
    // points have moved on the grid. A hundred times the stiffness, and it is a
    // hundred times less.
    const std::vector<std::string> stiff = {
      "Materials/clay/Young's modulus=100000"};
    const Result stood = run(settings(100., "2", 3600.), stiff);
    EXPECT_EQ(stood.reason, StopReason::stable_at_rest);
    EXPECT_EQ(stood.state.long_steps.motions, 0u);
    EXPECT_EQ(stood.state.unconverged_steps, 0u);
    const Result rose = run(settings(100., "0: 0, 3600: 2", 4000.),
                            with(stiff, {"Stop rules/At rest=false"}));
    EXPECT_EQ(rose.final_level, 4.);
    const Result low = run(settings(100., "0", 3600.), stiff);
    const Result storm =
      run(settings(100., "0: 0, 3600: 2, 7200: 0", 8000.), stiff);
    // Not before the storm is over.
    EXPECT_EQ(storm.reason, StopReason::stable_at_rest);
    EXPECT_GT(storm.state.time, 7200.);
    EXPECT_LT(storm.state.time, 7600.);
    const double change = stress_difference(low.state, stood.state);
    EXPECT_GT(change, 0.1);
    EXPECT_LT(stress_difference(rose.state, stood.state), 1e-3);
    EXPECT_LT(stress_difference(storm.state, low.state), 1e-3);
  }


  TEST(LongSteps, may_be_halved)
  {
    const auto   storm = settings(100., "0: 0, 3600: 2, 7200: 0.5", 8000.);
    const Result once  = run(storm);
    const Result twice = run(storm,
                             {"Time stepping/Longest step=150",
                              "Time stepping/Largest rise=0.025"});
    EXPECT_GT(twice.state.step, 3 * once.state.step / 2);
    EXPECT_LT(stress_difference(once.state, twice.state), 5e-4);
  }


  TEST(LongSteps, go_on_from_a_checkpoint_with_the_same_bits)
  {
    // It moves at first, rests, and moves again.
    const auto    given = settings(8., "0: 0, 600: 3.4", 700.);
    const auto    input = coarse(given);
    const Case<2> the_case(input->simulation, MPI_COMM_SELF);
    const auto    bytes_after = [&](const std::set<unsigned int> &stops) {
      State<2> state       = initial_state(the_case);
      auto     realisation = std::make_unique<Realisation<2>>(the_case, state);
      unsigned int changes = 0;
      for (unsigned int k = 0; k < 800; ++k)
        {
          if (realisation->look() != StopReason::none)
            break;
          const bool was_long = state.long_steps.last;
          realisation->advance();
          changes += state.long_steps.last != was_long;
          if (stops.count(k + 1) == 0)
            continue;
          State<2> copy;
          copy.read(state.write());
          realisation.reset();
          state       = copy;
          realisation = std::make_unique<Realisation<2>>(the_case, state);
        }
      EXPECT_GE(changes, 2u);
      EXPECT_GT(state.long_steps.motions, 0u);
      return state.write();
    };
    EXPECT_TRUE(bytes_after({1, 150, 320, 500}) == bytes_after({}));
  }


  TEST(LongSteps, close_the_account_of_energy)
  {
    const Result         result = run(settings(8., "0: 0, 600: 2", 700.));
    const EnergyAccount &e      = result.state.energy;
    EXPECT_GT(result.state.long_steps.motions, 0u);
    EXPECT_TRUE(result.state.long_steps.last);
    EXPECT_EQ(e.kinetic, 0.);
    EXPECT_EQ(kinetic_energy(result.state.points), 0.);
    EXPECT_GT(e.gravity_work, 10.);
    EXPECT_LT(std::abs(e.remainder()), 0.01 * e.gravity_work);
  }


  TEST(LongSteps, begin_with_short_ones_if_the_soil_moves)
  {
    for (const char *const velocity : {"0; 0", "0; -0.1"})
      {
        const auto input =
          coarse(with(settings(100., "0", 10.),
                      {std::string("Soil profile/dyke/Velocity=") + velocity}));
        const Case<2> the_case(input->simulation, MPI_COMM_SELF);
        EXPECT_EQ(initial_state(the_case).long_steps.active,
                  std::string(velocity) == "0; 0");
      }
  }
} // namespace simulation_long_steps
