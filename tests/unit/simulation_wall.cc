// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/case/scene.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/realisation.h>

#include "user_errors.h"
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace simulation_wall
{
  // Walls off the grid in whole steps: parameters/chapter3/inclined_wall.prm
  // with blocks and walls along the grid, between its lines.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.5;

    /// A block of 1.75 x 1.25 m with a wall on its left, below and on its
    /// right: all between lines of the grid, on lines of the sub-cells.
    auto
    parameters(const std::vector<std::pair<std::string, std::string>> &more)
    {
      std::map<std::string, std::string> settings = {
        {"Grid/Cell size", "0.5"},
        {"Soil profile/block/Polygon", "-0.75,0.25; 1,0.25; 1,1.5; -0.75,1.5"},
        {"Walls/corner/Line", "-0.75,1.5; -0.75,0.25; 1,0.25"},
        {"Walls/face/Line", "1,0.25; 1,1.5"},
        {"Walls/face/Displacement", "-0.001*t; 0"}};
      for (const auto &[name, value] : more)
        settings[name] = value;
      std::vector<std::string> overrides;
      for (const auto &[name, value] : settings)
        overrides.push_back(name + "=" + value);
      return read_parameters(WAKER_SOURCE_DIRECTORY
                             "/parameters/chapter3/inclined_wall.prm",
                             overrides);
    }


    template <int dim>
    void
    advance(const Case<dim>   &the_case,
            State<dim>        &state,
            StepReport<dim>   *last    = nullptr,
            const unsigned int n_steps = 10000)
    {
      Realisation<dim> realisation(the_case, state);
      for (unsigned int n = 0;
           realisation.look() == StopReason::none && n < n_steps;
           ++n)
        realisation.advance();
      EXPECT_GT(state.step, 0u);
      EXPECT_EQ(state.unconverged_steps, 0u);
      if (last != nullptr)
        *last = realisation.view().report;
    }


    /// The spots on vertical parts of the walls.
    double
    pressure(const State<2> &state, const Case<2> &the_case)
    {
      Scene<2> scene(the_case);
      double   largest = 0.;
      for (std::size_t q = 0; q < scene.walls.n_spots(); ++q)
        if (std::abs(scene.walls.all_spots()[q].normal[0]) > 0.5)
          largest = std::max(largest, state.wall_tractions[q].norm());
      return largest;
    }
  } // namespace


  // Uniform strain: the springs of both walls and the block in series.
  TEST(SimulationWall, PatchTest)
  {
    for (const double factor : {5., 100.})
      {
        const std::string f = std::to_string(factor);
        const auto        p =
          parameters({{"Walls/corner/Penalty factor", f},
                      {"Walls/face/Penalty factor", f},
                      {"Time stepping/Time step", "1"},
                      {"Kinematics and mapping/Objective rate", "false"}});
        const Case<2> the_case(*p, MPI_COMM_SELF);
        State<2>      state = initial_state(the_case);
        StepReport<2> report;
        advance(the_case, state, &report);

        const double E = 1000. / (1. - 0.09); // plane strain, free on top
        const double M = 1000. * 0.7 / (1.3 * 0.4);
        const double expected =
          0.001 / (1.75 / E + 2. * h / (factor * M)); // kPa
        for (const auto &stress : state.points.stress)
          {
            EXPECT_NEAR(stress[0][0], -expected, 2e-7 * expected);
            EXPECT_NEAR(stress[1][1], 0., 2e-7 * expected);
            EXPECT_NEAR(stress[0][1], 0., 2e-7 * expected);
          }
        EXPECT_NEAR(pressure(state, the_case), expected, 2e-7 * expected);
        EXPECT_LT(report.reaction.norm(), 1e-8); // no other force
        // Half of the force times the way of the soil there.
        EXPECT_NEAR(state.energy.support_work,
                    0.5 * expected * expected * 1.75 / E * 1.25,
                    1e-5 * state.energy.support_work);
      }
  }


  TEST(SimulationWall, PatchTestInThreeDimensions)
  {
    const auto p = parameters(
      {{"Dimension", "3"},
       {"Grid/Lower corner", "-1,-1,0"},
       {"Grid/Upper corner", "3,3,1"},
       {"Soil profile/block/Extent", "0.25,0.75"},
       {"Walls/corner/Line",
        "-0.75,0.25,0.25; -0.75,1.5,0.25; -0.75,1.5,0.75; -0.75,0.25,0.75"},
       {"Walls/face/Line", "1,0.25,0.25; 1,0.25,0.75; 1,1.5,0.75; 1,1.5,0.25"},
       {"Walls/face/Type", "rough"},
       {"Walls/face/Displacement", "-0.001*t; 0; 0"},
       {"Materials/soil/Poisson's ratio", "0"},
       {"Time stepping/Time step", "1"},
       {"Kinematics and mapping/Objective rate", "false"}});
    const Case<3> the_case(*p, MPI_COMM_SELF);
    State<3>      state = initial_state(the_case);
    // The normals point into the soil.
    Scene<3> scene(the_case);
    EXPECT_GT(scene.walls.all_spots().front().normal[0], 0.);
    EXPECT_LT(scene.walls.all_spots().back().normal[0], 0.);
    advance(the_case, state);
    const double expected = 0.001 / (1.75 / 1000. + 2. * h / (100. * 1000.));
    for (const auto &stress : state.points.stress)
      {
        EXPECT_NEAR(stress[0][0], -expected, 1e-5 * expected);
        EXPECT_NEAR(stress[1][1], 0., 1e-5 * expected);
        EXPECT_NEAR(stress[0][2], 0., 1e-5 * expected);
      }
  }


  // A block that stands on a wall from the gravity step on stays where it is,
  // for however many steps: the springs remember what they carry.
  TEST(SimulationWall, ALoadedWallDoesNotCreep)
  {
    const auto     p = parameters({{"Walls/face/Displacement", ""},
                                   {"Walls/corner/Type", "rough"},
                                   {"Gravity/Acceleration", "10"},
                                   {"Gravity/Initial stress", "true"},
                                   {"Time stepping/Scheme", "Newmark"},
                                   {"Time stepping/Time step", "0.01"},
                                   {"Time stepping/Ramp duration", "0.1"},
                                   {"Time stepping/End time", "2"},
                                   {"Newton/Tolerance", "1e-9"},
                                   {"Newton/Linear tolerance", "1e-8"}});
    const Case<2>  the_case(*p, MPI_COMM_SELF);
    const Scene<2> scene(the_case);
    State<2>       state  = initial_state(the_case);
    const double   weight = 1.75 * 1.25 * 10.; // kN
    double         mass   = 0.;
    for (const double m : state.points.mass)
      mass += m;
    EXPECT_NEAR(scene.walls.force(0, state.wall_tractions)[1],
                10. * mass,
                1e-5 * weight);
    StepReport<2> report;
    advance(the_case, state, &report);
    EXPECT_NEAR(report.reaction[1], 10. * mass, 1e-5 * weight);
    for (std::size_t q = 0; q < state.points.n_points(); ++q)
      EXPECT_LT(
        (state.points.position[q] - state.points.initial_position[q]).norm(),
        1e-7);
  }


  // A block thrown against a wall bounces: momentum and energy are accounted
  // for, and a checkpoint on the way goes on bit for bit.
  TEST(SimulationWall, ABlockBounces)
  {
    const auto     p = parameters({{"Walls/face/Displacement", ""},
                                   {"Soil profile/block/Velocity", "-1; 0.2"},
                                   {"Time stepping/Scheme", "Newmark"},
                                   {"Time stepping/Time step", "0.002"},
                                   {"Time stepping/Ramp duration", "0"},
                                   {"Time stepping/End time", "0.1"},
                                   {"Newton/Tolerance", "1e-9"},
                                   {"Newton/Linear tolerance", "1e-8"}});
    const Case<2>  the_case(*p, MPI_COMM_SELF);
    State<2>       state = initial_state(the_case);
    Realisation<2> realisation(the_case, state);
    Tensor<1, 2>   impulse, force;
    const auto     start = momentum(state.points);
    std::string    bytes;
    while (realisation.look() == StopReason::none)
      {
        if (state.step == 23)
          bytes = state.write();
        realisation.advance();
        const StepReport<2> report = realisation.view().report;
        impulse += 0.5 * state.last_dt * (force + report.reaction);
        force = report.reaction;
        EXPECT_LT((momentum(state.points) - start - impulse).norm(),
                  1e-7 * start.norm());
      }
    EXPECT_GE(state.step, 50u);
    EXPECT_EQ(state.unconverged_steps, 0u);
    EXPECT_GT(impulse[0], 0.3 * std::abs(start[0]));
    EXPECT_LT(std::abs(state.energy.remainder()),
              0.01 * state.energy.kinetic_start);

    State<2> resumed;
    resumed.read(bytes);
    advance(the_case, resumed);
    EXPECT_EQ(resumed.write(), state.write());
  }


  TEST(SimulationWall, TheExplicitSchemeHasNone)
  {
    expect_user_error(
      []() {
        parameters({{"Time stepping/Scheme", "explicit"}});
      },
      "--set Time stepping/Scheme",
      "there are walls off the grid");
  }
} // namespace simulation_wall
