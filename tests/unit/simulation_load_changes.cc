// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/run_to_end.h>

#include "loaded_bar.h"
#include <gtest/gtest.h>

namespace simulation_load_changes
{
  // Loads that change later keep a run alive.

  using namespace Waker;

  namespace
  {
    /// An elastic block of 3 x 1 m on rollers against the right end of its box,
    /// with water of 0.25 m on its left that rises as `rise` says.
    struct BlockInWater
    {
      explicit BlockInWater(const std::string &rise)
        : bar(3.)
      {
        Parameters &p              = bar.parameters;
        p.layers[0].initial_stress = "";
        p.fixities[1].name         = "right"; // instead of the top
        p.fixities[1].region       = FixityRegion::right;
        p.surface.method           = SurfaceMethod::contour;
        p.water.side               = WaterSide::left;
        p.water.level              = 0.25;
        p.water.rise               = rise;
        p.time.time_step           = 0.05;
        p.time.end_time            = 8.;
      }

      StopReason
      run()
      {
        const Case<2> the_case(bar.parameters, MPI_COMM_SELF);
        state = initial_state(the_case);
        Realisation<2>   realisation(the_case, state);
        const StopReason stop = run_to_end(realisation);
        unrest                = realisation.unrest();
        return stop;
      }

      Outcome
      outcome() const
      {
        return outcome_of(state.failure, unrest);
      }

      LoadedBar bar;
      State<2>  state;
      Unrest    unrest;
    };


    double
    last_change(const Parameters &parameters)
    {
      return Case<2>(parameters, MPI_COMM_SELF).last_load_change;
    }


    std::string
    complaint(const Parameters &parameters)
    {
      try
        {
          const Case<2> the_case(parameters, MPI_COMM_SELF);
        }
      catch (const UserError &error)
        {
          return error.where + ": " + error.problem;
        }
      return "";
    }
  } // namespace


  TEST(Simulation, water_that_rises_later_floods_the_dyke)
  {
    // Without a rise it would be over after the ramp and a second of rest.
    BlockInWater still("0");
    EXPECT_EQ(still.run(), StopReason::stable_at_rest);
    EXPECT_NEAR(still.state.time, 2.05, 0.051);

    // 1 m is reached at 3.75 s.
    BlockInWater rising("0: 0, 3: 0, 4: 1");
    EXPECT_EQ(rising.run(), StopReason::flooding);
    EXPECT_NEAR(rising.state.failure.flooding_time, 3.75, 0.051);

    // The same as an expression, of which nobody knows when it ends.
    BlockInWater expression("t < 3 ? 0 : min(t - 3, 1)");
    EXPECT_EQ(expression.run(), StopReason::flooding);
    EXPECT_NEAR(expression.state.failure.flooding_time, 3.75, 0.051);
  }


  TEST(Simulation, without_water_a_level_above_the_crest_floods_nothing)
  {
    BlockInWater dry("0");
    dry.bar.parameters.water.side  = WaterSide::none;
    dry.bar.parameters.water.level = 2.;
    EXPECT_EQ(dry.run(), StopReason::stable_at_rest);
    EXPECT_FALSE(dry.state.failure.flooded());
    EXPECT_EQ(dry.outcome(), Outcome::stable);
  }


  TEST(Simulation, rest_counts_from_the_last_change_of_a_load)
  {
    BlockInWater table("0: 0, 3: 0, 4: 0.1, 9: 0.1");
    EXPECT_EQ(table.run(), StopReason::stable_at_rest);
    EXPECT_NEAR(table.state.time, 5., 0.051);

    BlockInWater expression("t < 3 ? 0 : 0.1*min(t - 3, 1)");
    EXPECT_EQ(expression.run(), StopReason::end_time);
    expression.bar.parameters.stop.loads_constant_from = "4.5";
    EXPECT_EQ(expression.run(), StopReason::stable_at_rest);
    EXPECT_NEAR(expression.state.time, 5.5, 0.051);

    // A word that is not true is refused.
    expression.bar.parameters.stop.loads_constant_from = "3.5";
    EXPECT_EQ(complaint(expression.bar.parameters)
                .find(
                  "Stop rules/Loads constant from: is 3.5 s, but Water/Rise "
                  "changes"),
              0u);
    table.bar.parameters.stop.loads_constant_from = "3.5";
    EXPECT_NE(complaint(table.bar.parameters), "");
    for (const char *const text : {"", "soon", "-1", "1e999", "4 s"})
      {
        expression.bar.parameters.stop.loads_constant_from = text;
        EXPECT_THROW(expression.bar.parameters.stop.check(), UserError) << text;
      }
  }


  TEST(Simulation, every_kind_of_load_says_when_it_changes_last)
  {
    LoadedBar   bar(1.);
    Parameters &p = bar.parameters;
    bar.load("contour");
    EXPECT_EQ(last_change(p), LastChange::never);

    // Without water nothing rises.
    p.water.rise = "0: 0, 9: 1";
    EXPECT_EQ(last_change(p), LastChange::never);
    p.water.rise = "0";

    TractionParameters &traction = p.tractions[0];
    traction.kind                = TractionKind::hydrostatic;
    traction.level               = "0: 1, 5: 2, 6: 2";
    EXPECT_EQ(last_change(p), 5.);
    traction.kind = TractionKind::vector;
    for (const char *const one_that_changes : {"t; 1", "1; t*x"})
      {
        traction.value = one_that_changes;
        EXPECT_EQ(last_change(p), LastChange::unknown) << traction.value;
      }
    p.stop.loads_constant_from = "6"; // not true at any place but x = 0
    EXPECT_NE(complaint(p).find("Tractions/contour changes"),
              std::string::npos);
    traction.value = "1; x*min(t, 5)";
    EXPECT_EQ(last_change(p), 6.);
    p.stop.loads_constant_from = "unknown";

    // What was fixed at the start changes no more, nor may it be given as if.
    traction.method       = TractionMethod::fixed_points;
    traction.surface_file = bar.folder.file("bar");
    EXPECT_NE(complaint(p).find("changes in time"), std::string::npos);
    traction.value = "1; x";
    EXPECT_EQ(last_change(p), LastChange::never);

    FixityParameters push;
    push.name         = "push";
    push.region       = FixityRegion::left;
    push.type         = FixityType::prescribed;
    push.displacement = "0; free";
    p.fixities.push_back(push);
    EXPECT_EQ(last_change(p), LastChange::never);
    p.fixities.back().displacement = "0.001*y*t; free";
    EXPECT_EQ(last_change(p), LastChange::unknown);
    p.stop.loads_constant_from = "6";
    EXPECT_NE(complaint(p).find("Boundary conditions/push changes"),
              std::string::npos);
    p.fixities.back().displacement = "0.001*y*min(t, 5); free";
    EXPECT_EQ(last_change(p), 6.);
    p.fixities.back().method = FixityMethod::penalty;
    EXPECT_EQ(last_change(p), 6.);
  }


  TEST(Simulation, walls_and_inflows_are_loads_that_change)
  {
    const auto of_file = [](const std::string              &name,
                            const std::vector<std::string> &settings) {
      return read_parameters(WAKER_SOURCE_DIRECTORY "/parameters/chapter3/" +
                               name,
                             settings);
    };
    EXPECT_EQ(last_change(*of_file("inclined_wall.prm", {})),
              LastChange::unknown);
    EXPECT_EQ(last_change(
                *of_file("inclined_wall.prm", {"Walls/face/Displacement="})),
              LastChange::never);
    EXPECT_NE(complaint(*of_file("inclined_wall.prm",
                                 {"Stop rules/Loads constant from=0"}))
                .find("Walls/face changes"),
              std::string::npos);
    EXPECT_EQ(last_change(*of_file("flow.prm", {})), LastChange::unknown);
    EXPECT_NE(complaint(
                *of_file("flow.prm", {"Stop rules/Loads constant from=0"}))
                .find("Inflow/mouth changes"),
              std::string::npos);
  }


  TEST(Simulation, only_what_rests_under_constant_loads_is_stable)
  {
    // At rest, by the rule or without it.
    BlockInWater still("0");
    still.run();
    EXPECT_EQ(still.outcome(), Outcome::stable);
    still.bar.parameters.stop.at_rest  = false;
    still.bar.parameters.time.end_time = 4.;
    EXPECT_EQ(still.run(), StopReason::end_time);
    EXPECT_EQ(still.outcome(), Outcome::stable);
    // The end comes before a second of rest.
    still.bar.parameters.time.end_time = 1.5;
    EXPECT_EQ(still.run(), StopReason::end_time);
    EXPECT_EQ(still.outcome(), Outcome::still_moving);

    // A level that has risen, rises, and will rise.
    BlockInWater table("0: 0, 3: 0, 4: 0.1");
    table.bar.parameters.time.end_time = 6.;
    table.run();
    EXPECT_EQ(table.outcome(), Outcome::stable);
    for (const double end : {2.5, 3.5, 4.5})
      {
        table.bar.parameters.time.end_time = end;
        EXPECT_EQ(table.run(), StopReason::end_time) << end;
        EXPECT_EQ(table.outcome(), Outcome::loads_change) << end;
      }

    // Of an expression only what it does in the last second is known.
    BlockInWater expression("t < 3 ? 0 : 0.1*min(t - 3, 1)");
    for (const auto &[end, outcome] :
         {std::make_pair(2.5, Outcome::stable),
          std::make_pair(4.5, Outcome::loads_change),
          std::make_pair(6., Outcome::stable)})
      {
        expression.bar.parameters.time.end_time = end;
        EXPECT_EQ(expression.run(), StopReason::end_time) << end;
        EXPECT_EQ(expression.outcome(), outcome) << end;
      }

    // The flooded has flooded.
    BlockInWater flooded("0: 0, 3: 0, 4: 1, 9: 2");
    flooded.run();
    EXPECT_EQ(flooded.outcome(), Outcome::flooding);
  }


  // Each load step is in balance: it needs no time to rest.
  TEST(Simulation, load_steps_rest_at_once)
  {
    BlockInWater block("0: 0, 2: 0.1");
    Parameters  &p   = block.bar.parameters;
    p.time.scheme    = Scheme::quasi_static;
    p.time.time_step = 0.5;
    p.time.end_time  = 2.;
    EXPECT_EQ(block.run(), StopReason::end_time);
    EXPECT_EQ(block.outcome(), Outcome::stable);
    p.water.rise = "0: 0, 2: 0.1, 3: 0.2";
    block.run();
    EXPECT_EQ(block.outcome(), Outcome::loads_change);
  }


  // Weight and loads that grow over the load duration are loads that change.
  TEST(Simulation, no_rest_at_a_share_of_the_weight)
  {
    const auto run_to = [](const double end) {
      BlockInWater block("0");
      Parameters  &p         = block.bar.parameters;
      p.time.scheme          = Scheme::quasi_static;
      p.time.time_step       = 0.5;
      p.time.load_duration   = 10.;
      p.time.end_time        = end;
      p.gravity.acceleration = 9.81;
      EXPECT_EQ(last_change(p), 10.);
      const StopReason stop = block.run();
      // A linear column: what it carries is its share of the weight.
      double stress = 0.;
      for (const auto &s : block.state.points.stress)
        stress = std::min(stress, s[1][1]);
      return std::make_tuple(stop, block.outcome(), block.state.time, stress);
    };
    const auto [whole_stop, whole, whole_time, full_stress] = run_to(20.);
    EXPECT_EQ(whole_stop, StopReason::stable_at_rest);
    EXPECT_EQ(whole, Outcome::stable);
    EXPECT_NEAR(whole_time,
                11.,
                1e-9); // a second of rest after the last change
    const auto [early_stop, early, early_time, stress] = run_to(2.);
    EXPECT_EQ(early_stop, StopReason::end_time);
    EXPECT_EQ(early, Outcome::loads_change);
    EXPECT_EQ(early_time, 2.);
    EXPECT_NEAR(stress / full_stress, 0.2, 0.01);
    EXPECT_EQ(std::get<1>(run_to(10.)), Outcome::stable);

    // A word that is not true is refused; other schemes have no such duration.
    BlockInWater block("0");
    Parameters  &p             = block.bar.parameters;
    p.time.scheme              = Scheme::quasi_static;
    p.time.load_duration       = 10.;
    p.stop.loads_constant_from = "9";
    EXPECT_NE(complaint(p).find("Time stepping/Load duration changes"),
              std::string::npos);
    p.stop.loads_constant_from = "10";
    EXPECT_EQ(complaint(p), "");
    p.stop.loads_constant_from = "unknown";
    p.time.scheme              = Scheme::newmark;
    EXPECT_EQ(last_change(p), LastChange::never);
  }


  TEST(Simulation, a_dyke_that_leans_on_the_box_is_not_stable)
  {
    BlockInWater block("0");
    block.run();
    EXPECT_FALSE(block.unrest.at_box); // it stood there from the beginning
    const Case<2> the_case(block.bar.parameters, MPI_COMM_SELF);
    State<2>      state = block.state;
    for (Point<2> &x : state.points.initial_position)
      x[0] -= 2.;
    Realisation<2> realisation(the_case, state);
    realisation.look();
    EXPECT_TRUE(realisation.unrest().at_box);
    // (What has moved by 2 m has failed as well, by displacement.)
    EXPECT_EQ(outcome_of(FailureRecord(), realisation.unrest()),
              Outcome::stopped_by_box);
  }
} // namespace simulation_load_changes
