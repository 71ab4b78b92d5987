// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/case/scene.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/plausibility.h>
#include <waker/simulation/realisation.h>

#include "user_errors.h"
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace simulation_contact
{
  // Blocks on walls that only push, with friction:
  // parameters/verification/block_on_slope.prm, on its slope and on the flat.

  using namespace Waker;

  namespace
  {
    constexpr double g = 9.81;

    using Settings = std::map<std::string, std::string>;


    auto
    parameters(const Settings &settings)
    {
      std::vector<std::string> overrides;
      for (const auto &[name, value] : settings)
        overrides.push_back(name + "=" + value);
      return read_parameters(WAKER_SOURCE_DIRECTORY
                             "/parameters/verification/block_on_slope.prm",
                             overrides);
    }


    /// The block on level ground, of which it is `gap` above; the ground on a
    /// line of the grid, or between two.
    Settings
    on_the_flat(const double ground, const double gap, Settings more)
    {
      const auto y = [&](const double above) {
        return std::to_string(ground + gap + above);
      };
      Settings settings = {
        {"Grid/Cell size", "0.5"},
        {"Grid/Lower corner", "0, 0"},
        {"Grid/Upper corner", "6, 3"},
        {"Soil profile/block/Polygon",
         "1, " + y(0.) + "; 3, " + y(0.) + "; 3, " + y(1.) + "; 1, " + y(1.)},
        {"Walls/slope/Line",
         "0, " + std::to_string(ground) + "; 6, " + std::to_string(ground)},
        {"Time stepping/Time step", "0.01"}};
      for (const auto &[name, value] : more)
        settings[name] = value;
      return settings;
    }


    template <int dim>
    Tensor<1, dim>
    mean_displacement(const State<dim> &state)
    {
      Tensor<1, dim> sum;
      double         mass = 0.;
      for (std::size_t p = 0; p < state.points.n_points(); ++p)
        {
          sum += state.points.mass[p] *
                 (state.points.position[p] - state.points.initial_position[p]);
          mass += state.points.mass[p];
        }
      return sum / mass;
    }


    /// Run to the end. Momentum and energy are accounted for in each step, no
    /// spot pulls, and none has more shear than friction allows.
    template <int dim>
    void
    advance(const Case<dim> &the_case, State<dim> &state, const double mu)
    {
      Realisation<dim>     realisation(the_case, state);
      Tensor<1, dim>       impulse, force;
      const Tensor<1, dim> start = momentum(state.points);
      double               mass  = 0.;
      for (const double m : state.points.mass)
        mass += m;
      const double scale = mass * g * the_case.parameters.time.end_time;
      force = realisation.view().scene.walls.force(0, state.wall_tractions);
      while (realisation.look() == StopReason::none)
        {
          realisation.advance();
          const StepReport<dim> &report = realisation.view().report;
          impulse += 0.5 * state.last_dt * (force + report.reaction);
          impulse[1] -= state.last_dt * mass * g;
          force = report.reaction;
          EXPECT_LT((momentum(state.points) - start - impulse).norm(),
                    1e-5 * scale);
          const auto &spots = realisation.view().scene.walls.all_spots();
          for (std::size_t q = 0; q < spots.size(); ++q)
            {
              const Tensor<1, dim> &t = state.wall_tractions[q];
              const double          p = t * spots[q].normal;
              ASSERT_GE(p, -1e-12);
              ASSERT_LE((t - p * spots[q].normal).norm(),
                        mu * p * (1. + 1e-9) + 1e-12);
            }
        }
      EXPECT_GT(state.step, 10u);
      EXPECT_EQ(state.unconverged_steps, 0u);
    }
  } // namespace


  // tan(beta) = 0.5
  TEST(SimulationContact, ABlockSlidesAsCoulombSays)
  {
    const auto    p = parameters({{"Time stepping/End time", "1"}});
    const Case<2> the_case(*p, MPI_COMM_SELF);
    State<2>      state = initial_state(the_case);
    advance(the_case, state, 0.3);
    const Tensor<1, 2> down({2. / std::sqrt(5.), -1. / std::sqrt(5.)});
    const double       a   = g * (1. - 0.3 * 2.) / std::sqrt(5.);
    const double       way = mean_displacement(state) * down;
    EXPECT_NEAR(way / (0.5 * a), 1., 0.02);
    // What friction took, and what is not explained.
    const double weight = 20. * 2.;
    EXPECT_NEAR(state.energy.friction,
                0.3 * weight * 2. / std::sqrt(5.) * way,
                0.05 * state.energy.friction); // 0.03: the start is a shock
    EXPECT_LT(std::abs(state.energy.remainder()),
              0.01 * state.energy.gravity_work);
  }


  TEST(SimulationContact, ABlockHolds)
  {
    const auto    p = parameters({{"Walls/slope/Friction coefficient", "0.6"},
                                  {"Gravity/Initial stress", "true"},
                                  {"Time stepping/Time step", "0.02"}});
    const Case<2> the_case(*p, MPI_COMM_SELF);
    State<2>      state = initial_state(the_case);
    advance(the_case, state, 0.6);
    EXPECT_LT(mean_displacement(state).norm(), 1e-5);
    EXPECT_LT(state.energy.friction, 1e-6);
  }


  // The static step knows that friction does not hold it.
  TEST(SimulationContact, WithoutFrictionThereIsNoStressInSitu)
  {
    const auto p = parameters({{"Gravity/Initial stress", "true"}});
    EXPECT_THROW(Case<2>(*p, MPI_COMM_SELF), NumericalFailure);
  }


  // It is thrown along the ground, stops after v^2 / (2 mu g), and stays.
  TEST(SimulationContact, ASlidingBlockComesToRest)
  {
    const auto p =
      parameters(on_the_flat(0.75,
                             0.,
                             {{"Soil profile/block/Velocity", "2; 0"},
                              {"Time stepping/Time step", "0.0025"},
                              {"Time stepping/End time", "1.2"}}));
    const Case<2> the_case(*p, MPI_COMM_SELF);
    State<2>      state = initial_state(the_case);
    advance(the_case, state, 0.3);
    EXPECT_NEAR(mean_displacement(state)[0] / (2. * 2. / (2. * 0.3 * g)),
                1.,
                0.003);
    EXPECT_LT(momentum(state.points).norm(), 2e-4 * 2. * 4.);
    EXPECT_NEAR(state.energy.friction / state.energy.kinetic_start, 1., 0.01);
  }


  // It falls by 0.2 m, leaves the ground again, and is pulled by nothing; a
  // checkpoint in flight and one in contact go on bit for bit.
  TEST(SimulationContact, ABlockBouncesAndIsNotPulled)
  {
    const auto p =
      parameters(on_the_flat(0.75,
                             0.25,
                             {{"Soil profile/block/Velocity", "0.5; -1"},
                              {"Time stepping/Time step", "0.0025"},
                              {"Time stepping/End time", "0.4"}}));
    const Case<2>  the_case(*p, MPI_COMM_SELF);
    State<2>       state = initial_state(the_case);
    Realisation<2> realisation(the_case, state);
    std::string    bytes[2];
    double         lowest = 1., highest_after = 0.;
    unsigned int   n_touching = 0, n_flying = 0;
    while (realisation.look() == StopReason::none)
      {
        const double force =
          realisation.view().scene.walls.force(0, state.wall_tractions)[1];
        if (force > 0. && n_touching++ == 1)
          bytes[0] = state.write();
        if (force == 0. && n_touching > 0 && n_flying++ == 1)
          bytes[1] = state.write();
        lowest        = std::min(lowest, mean_displacement(state)[1]);
        highest_after = n_touching > 0
                          ? std::max(highest_after, momentum(state.points)[1])
                          : 0.;
        realisation.advance();
      }
    EXPECT_EQ(state.unconverged_steps, 0u);
    EXPECT_GT(n_touching, 2u);
    EXPECT_GT(n_flying, 3u);
    // A gap below 0.15 of a domain is none: 0.0375 m.
    EXPECT_NEAR(lowest, -0.25 + 0.0375, 0.02);
    EXPECT_GT(highest_after, 0.);
    EXPECT_LT(std::abs(state.energy.remainder()),
              0.02 * state.energy.kinetic_start);
    for (const std::string &start : bytes)
      {
        ASSERT_FALSE(start.empty());
        State<2> resumed;
        resumed.read(start);
        Realisation<2> other(the_case, resumed);
        while (other.look() == StopReason::none)
          other.advance();
        EXPECT_EQ(resumed.write(), state.write());
      }
  }


  TEST(SimulationContact, ThreeDimensions)
  {
    const Settings block = {
      {"Dimension", "3"},
      {"Grid/Cell size", "0.5"},
      {"Grid/Lower corner", "0, -0.25, 0"}, // the ground between two lines
      {"Grid/Upper corner", "4, 1.75, 3"},
      {"Soil profile/block/Polygon", "1, 0; 2, 0; 2, 1; 1, 1"},
      {"Soil profile/block/Extent", "1, 2"},
      {"Soil profile/block/Velocity", "1.6; 0; 1.2"},
      {"Walls/slope/Line", "0, 0, 0; 0, 0, 3; 4, 0, 3; 4, 0, 0"},
      {"Time stepping/Time step", "0.01"},
      {"Time stepping/End time", "0.3"}};
    const auto    p = parameters(block);
    const Case<3> the_case(*p, MPI_COMM_SELF);
    State<3>      state = initial_state(the_case);
    advance(the_case, state, 0.3);
    const double       t = 0.3, way = 2. * t - 0.5 * 0.3 * g * t * t;
    const Tensor<1, 3> u = mean_displacement(state);
    EXPECT_NEAR(u[0] / (0.8 * way), 1., 0.02);
    EXPECT_NEAR(u[2] / (0.6 * way), 1., 0.02);

    // In situ it is in balance, and stays.
    Settings at_rest                       = block;
    at_rest["Soil profile/block/Velocity"] = "";
    at_rest["Gravity/Initial stress"]      = "true";
    at_rest["Time stepping/End time"]      = "0.6";
    const auto    q                        = parameters(at_rest);
    const Case<3> still(*q, MPI_COMM_SELF);
    State<3>      rest = initial_state(still);
    advance(still, rest, 0.3);
    // Corners let go and are taken again: 1.5e-5 m, where its own weight
    // compresses it by 5e-4 m, and that dies away.
    EXPECT_LT(mean_displacement(rest).norm(), 6e-5);
    EXPECT_LT(momentum(rest.points).norm(), 1e-4 * 20. / g);
  }


  // The ground, half a cell inside the box, closes it: the surface ends there,
  // and water presses from the left, not from below.
  TEST(SimulationContact, WaterDoesNotComeBetween)
  {
    for (const std::string method : {"proximity field", "contour"})
      {
        const auto     p = parameters(on_the_flat(0.75,
                                              0.,
                                              {{"Grid/Lower corner", "0, 0.5"},
                                                   {"Grid/Upper corner", "6, 3.5"},
                                                   {"Surface/Method", method},
                                                   {"Water/Side", "left"},
                                                   {"Water/Level", "1.5"}}));
        const Case<2>  the_case(*p, MPI_COMM_SELF);
        State<2>       state = initial_state(the_case);
        Realisation<2> realisation(the_case, state);
        EXPECT_EQ(realisation.look(), StopReason::none);
        const Scene<2> &scene  = realisation.view().scene;
        double          bottom = 0.;
        for (const Facet<2> &facet : scene.surfaces.section())
          {
            const double y[] = {facet.vertices[0][1], facet.vertices[1][1]};
            EXPECT_GT(std::min(y[0], y[1]), 0.75 - 1e-9) << method;
            if (std::max(y[0], y[1]) < 0.75 + 1e-9)
              {
                EXPECT_EQ(facet.on_face, 2) << method;
                bottom += facet.vertices[1][0] - facet.vertices[0][0];
              }
          }
        EXPECT_NEAR(bottom, 2., 0.1) << method;
        const auto &force = scene.water_resultant.force;
        // From below it would be 14.7; the found line scatters by 0.02 m.
        EXPECT_NEAR(force[1], 0., 1.) << method;
        EXPECT_NEAR(force[0] / (0.5 * 9.81 * 0.75 * 0.75), 1., 0.02) << method;
      }
  }


  TEST(SimulationContact, StrangeWallsAreWarnedOf)
  {
    const auto warned = [](const Settings &more, const std::string &text) {
      const auto    p = parameters(on_the_flat(0.75, 0., more));
      const Case<2> the_case(*p, MPI_COMM_SELF);
      for (const std::string &warning : strange_things(the_case))
        if (warning.find(text) != std::string::npos)
          return true;
      return false;
    };
    const std::string wall = "Walls/slope/";
    for (const auto &[more, text] :
         std::vector<std::pair<Settings, std::string>>{
           {{{wall + "Line", "0, 0.1; 6, 0.1"}}, "no soil touches it"},
           {{{"Grid/Lower corner", "0, 0.25"},
             {"Grid/Upper corner", "6, 3.25"}},
            "lies along a line of the grid"},
           {{{wall + "Type", "smooth"}},
            "Friction coefficient is not used with Type = smooth"},
           {{{wall + "Friction coefficient", "0"}}, "the soil slides freely"},
           {{{wall + "Friction coefficient", "1.5"}}, "is 1.5; soils have"},
           {{{"Materials/block/Model", "Mohr-Coulomb"},
             {"Materials/block/Friction angle", "15"},
             {"Materials/block/Cohesion", "10"}},
            "more than the tangent of the soil's own angle"},
           {{{"Materials/block/Model", "von Mises softening"},
             {"Materials/block/Initial strength", "10"},
             {"Materials/block/Residual strength", "10"},
             {"Materials/block/Softening modulus", "0"},
             {wall + "Adhesion", "11"}},
            "more than the soil's own, 10 kPa"},
           {{{"Grid/Lower corner", "0, 0.75"},
             {"Grid/Upper corner", "6, 3.25"},
             {"Boundary conditions/Names", "base"},
             {"Boundary conditions/base/Region", "bottom"}},
            "a boundary condition holds"}})
      {
        EXPECT_TRUE(warned(more, text)) << text;
        EXPECT_FALSE(warned({}, text)) << text;
      }
  }
} // namespace simulation_contact
