// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/realisation.h>

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

namespace simulation_flow
{
  // Material that enters and leaves a running case:
  // parameters/chapter3/flow.prm, coarser, faster and shorter.

  using namespace Waker;

  namespace
  {
    const std::vector<std::string> quick = {"Grid/Cell size=0.5",
                                            "Grid/Upper corner=3, 2",
                                            "Inflow/mouth/Velocity=1",
                                            "Soil profile/strip/Velocity=1;0",
                                            "Time stepping/End time=3"};

    auto
    parameters(const std::vector<std::string> &more = {})
    {
      std::vector<std::string> settings = quick;
      settings.insert(settings.end(), more.begin(), more.end());
      return read_parameters(WAKER_SOURCE_DIRECTORY
                             "/parameters/chapter3/flow.prm",
                             settings);
    }


    double
    mass(const MaterialPoints<2> &points)
    {
      return std::accumulate(points.mass.begin(), points.mass.end(), 0.);
    }


    /// Run `n_steps`, or to the end.
    void
    advance(const Case<2>     &the_case,
            State<2>          &state,
            const unsigned int n_steps = 1000)
    {
      Realisation<2> realisation(the_case, state);
      for (unsigned int n = 0;
           realisation.look() == StopReason::none && n < n_steps;
           ++n)
        realisation.advance();
      EXPECT_GT(state.step, 0u);
      EXPECT_EQ(state.unconverged_steps, 0u);
    }


    std::string
    where(const std::vector<std::string> &settings)
    {
      try
        {
          const auto    p = parameters(settings);
          const Case<2> the_case(*p, MPI_COMM_SELF);
        }
      catch (const UserError &error)
        {
          return error.where;
        }
      return "";
    }
  } // namespace


  TEST(SimulationFlow, MassAndMomentumBalancesClose)
  {
    const auto     p = parameters();
    const Case<2>  the_case(*p, MPI_COMM_SELF);
    State<2>       state = initial_state(the_case);
    Realisation<2> realisation(the_case, state);
    const auto    &flow  = state.flow;
    const double   scale = 3. * 1. * 18. / 9.81; // Mg m/s
    while (realisation.look() == StopReason::none)
      {
        realisation.advance();
        EXPECT_NEAR(mass(state.points),
                    flow.mass_start + flow.mass_in - flow.mass_out,
                    1e-13 * scale);
        const Tensor<1, 2> remainder = momentum(state.points) -
                                       flow.momentum_start - flow.impulse -
                                       flow.momentum_in + flow.momentum_out;
        EXPECT_LT(remainder.norm(), 1e-6 * scale); // Newton's tolerance: 1e-8
      }
    // 3 m have entered; the front was 1 m away from the open face.
    EXPECT_EQ(state.unconverged_steps, 0u);
    EXPECT_NEAR(flow.mass_in, 3. * 18. / 9.81, 1e-12 * scale);
    EXPECT_NEAR(flow.mass_out, 2. * 18. / 9.81, 0.3 * 18. / 9.81);
    EXPECT_EQ(flow.points_in, 48u);
    EXPECT_EQ(state.points.n_points(),
              the_case.initial_points.n_points() + 48 - flow.points_out);
    // Ids go on.
    EXPECT_EQ(state.points.id.back() + 1, flow.next_id);
    EXPECT_LT(std::abs(state.energy.remainder()), 0.01 * state.energy.inflow);
  }


  // In the ramp acts a share of what is not in balance: here of the weight.
  TEST(SimulationFlow, TheMomentumBalanceClosesInTheRamp)
  {
    const auto p = parameters(
      {"Gravity/Initial stress=false", "Time stepping/Ramp duration=0.5"});
    p->time.end_time = 0.4;
    const Case<2>  the_case(*p, MPI_COMM_SELF);
    State<2>       state = initial_state(the_case);
    Realisation<2> realisation(the_case, state);
    const auto    &flow    = state.flow;
    const double   scale   = 3. * 1. * 18. / 9.81; // Mg m/s
    double         impulse = 0.;
    while (realisation.look() == StopReason::none)
      {
        realisation.advance();
        const Tensor<1, 2> remainder = momentum(state.points) -
                                       flow.momentum_start - flow.impulse -
                                       flow.momentum_in + flow.momentum_out;
        EXPECT_LT(remainder.norm(), 1e-6 * scale); // Newton's tolerance: 1e-8
        impulse = std::max(impulse, flow.impulse.norm());
      }
    EXPECT_EQ(state.unconverged_steps, 0u);
    EXPECT_GT(impulse, 1e-4 * scale);
  }


  TEST(SimulationFlow, ACheckpointGoesOnBitForBit)
  {
    const auto    p = parameters();
    const Case<2> the_case(*p, MPI_COMM_SELF);
    State<2>      whole = initial_state(the_case), first = whole;
    advance(the_case, whole);
    advance(the_case, first, 97);
    State<2> resumed;
    resumed.read(first.write());
    EXPECT_GT(resumed.flow.points_out, 0u);
    EXPECT_LT(resumed.flow.points_out, whole.flow.points_out);
    advance(the_case, resumed);
    EXPECT_EQ(whole.write(), resumed.write());
  }


  TEST(SimulationFlow, EverythingMayLeave)
  {
    const auto p = parameters({"Time stepping/Time step=0.05"});
    p->inflows.clear();
    const Case<2> the_case(*p, MPI_COMM_SELF);
    State<2>      state = initial_state(the_case);
    const double  start = mass(state.points);
    advance(the_case, state);
    EXPECT_NEAR(state.time, 3., 1e-9);
    EXPECT_EQ(state.points.n_points(), 0u);
    EXPECT_NEAR(state.flow.mass_out, start, 1e-13 * start);
    EXPECT_EQ(state.energy.kinetic + state.energy.elastic, 0.);
  }


  TEST(SimulationFlow, BadInput)
  {
    EXPECT_EQ(where({}), "");
    EXPECT_EQ(where({"Inflow/mouth/Material=sand"}), "Inflow/mouth/Material");
    EXPECT_EQ(where({"Inflow/mouth/Velocity=0"}),
              "--set Inflow/mouth/Velocity");
    EXPECT_EQ(where({"Inflow/mouth/To=0, 0"}), "--set Inflow/mouth/To");
    EXPECT_EQ(where({"Inflow/mouth/Face=bottom", "Inflow/mouth/To=1, 0"}),
              "Inflow/mouth/Face"); // the base holds it
    EXPECT_EQ(where({"Outflow/Faces=right,left"}), "Inflow/mouth/Face");
    EXPECT_EQ(where({"Outflow/Faces=bottom"}), "Outflow/Faces");
    EXPECT_EQ(where({"Outflow/Faces=upwards"}), "--set Outflow/Faces");
    EXPECT_EQ(where({"Time stepping/Scheme=explicit"}), "Time stepping/Scheme");
  }
} // namespace simulation_flow
