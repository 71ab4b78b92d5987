// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/realisation.h>

#include "user_errors.h"
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace simulation_initial_share
{
  // In-situ stress in two parts, on an elastic column in 3D: 2 m high, rollers
  // around it, a firm base.

  using namespace Waker;

  namespace
  {
    constexpr double height = 2., weight = 20.; // m, kN/m^3


    std::unique_ptr<Parameters>
    parameters(const std::map<std::string, std::string> &more = {})
    {
      std::map<std::string, std::string> settings = {
        {"Grid/Cell size", "0.25"},
        {"Grid/Upper corner", "0.5, 2.5, 0.5"},
        {"Soil profile/slope/Polygon", "0,0; 0.5,0; 0.5,2; 0,2"},
        {"Materials/clay/Initial strength", "1000"},
        {"Materials/clay/Residual strength", "1000"},
        {"Materials/clay/Softening modulus", "0"},
        {"Materials/clay/Poisson's ratio", "0.3"},
        {"Boundary conditions/Names", "base, rear, near end, far end, face"},
        {"Boundary conditions/near end/To", ""},
        {"Boundary conditions/near end/Type", "roller"},
        {"Boundary conditions/far end/To", ""},
        {"Boundary conditions/far end/Type", "roller"},
        {"Boundary conditions/face/Region", "right"},
        {"Boundary conditions/face/Type", "roller"},
        {"Outflow/Faces", ""},
        {"Outflow/Names", ""},
        {"Newton/Tolerance", "1e-9"},
        {"Newton/Linear tolerance", "1e-6"},
        {"Stop rules/At rest", "false"}};
      for (const auto &[name, value] : more)
        settings[name] = value;
      std::vector<std::string> list;
      for (const auto &[name, value] : settings)
        list.push_back(name + "=" + value);
      return read_parameters(WAKER_SOURCE_DIRECTORY
                             "/parameters/chapter6/slope.prm",
                             list);
    }


    const double modulus = 1000. * 0.7 / (1.3 * 0.4); // confined, kPa


    /// Largest difference of the vertical stress from that of the full weight
    /// at the centre of the cell, over that at the base: each cell's stress
    /// carries what lies above its centre.
    double
    stress_error(const MaterialPoints<3> &points)
    {
      constexpr double h     = 0.25;
      double           worst = 0.;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          const double centre =
            h * (std::floor(points.position[p][1] / h) + 0.5);
          worst = std::max(worst,
                           std::abs(points.stress[p][1][1] +
                                    weight * (height - centre)));
        }
      return worst / (weight * height);
    }
  } // namespace


  TEST(SimulationInitialShare, TheStepSetsUpItsShareOfTheStress)
  {
    const auto    full = parameters({{"Gravity/Initial share", "1"}});
    const Case<3> whole(*full, MPI_COMM_SELF);
    EXPECT_LT(stress_error(whole.initial_points), 1e-6); // tolerance: 1e-8
    for (const std::string share : {"0.99", "0.25"})
      {
        const auto    p = parameters({{"Gravity/Initial share", share}});
        const Case<3> part(*p, MPI_COMM_SELF);
        const double  s = std::stod(share);
        for (std::size_t q = 0; q < part.initial_points.n_points(); ++q)
          {
            const auto &sigma = part.initial_points.stress[q];
            EXPECT_NEAR((sigma - s * whole.initial_points.stress[q]).norm(),
                        0.,
                        1e-6 * weight * height);
          }
        // The rest is not in balance: the free nodes start to fall, each point
        // of a share of its own at most.
        double force = 0., mass = 0.;
        for (std::size_t q = 0; q < part.initial_points.n_points(); ++q)
          {
            const double a = part.initial_points.acceleration[q][1];
            EXPECT_LE(a, 1e-6);
            EXPECT_GE(a, -(1. - s) * 9.81 - 1e-6);
            force += part.initial_points.mass[q] * a;
            mass += part.initial_points.mass[q];
          }
        // All but the nodes of the base, with half a cell of the column.
        EXPECT_NEAR(force / (mass * 9.81 * (1. - s)),
                    -(1. - 0.125 / height),
                    0.01);
      }
  }


  // The rest in one static step: the stress is that of the full weight.
  TEST(SimulationInitialShare, TheRestMakesItWhole)
  {
    const auto    full = parameters({{"Gravity/Initial share", "1"}});
    const Case<3> whole(*full, MPI_COMM_SELF);
    const auto    p =
      parameters({{"Gravity/Initial share", "0.6"},
                  {"Time stepping/Scheme", "quasi-static"},
                  {"Time stepping/Move points", "false"},
                  {"Time stepping/Ghost stiffness", "0"},
                  {"Kinematics and mapping/Objective rate", "false"},
                  {"Time stepping/End time", "0.01"}});
    const Case<3>  part(*p, MPI_COMM_SELF);
    State<3>       state = initial_state(part);
    Realisation<3> realisation(part, state);
    while (realisation.look() == StopReason::none)
      realisation.advance();
    EXPECT_EQ(state.step, 1u);
    for (std::size_t q = 0; q < state.points.n_points(); ++q)
      EXPECT_LT(
        (state.points.stress[q] - whole.initial_points.stress[q]).norm(),
        1e-6 * weight * height);
  }


  // With inertia the column bounces about that stress, by the share that was
  // left away: the fundamental period is 4 H / c.
  TEST(SimulationInitialShare, TheColumnBouncesAboutTheFullWeight)
  {
    const double s      = 0.9;
    const double period = 4. * height / std::sqrt(modulus / (weight / 9.81));
    const auto   p =
      parameters({{"Gravity/Initial share", "0.9"},
                  {"Time stepping/Time step", std::to_string(period / 64.)},
                  {"Time stepping/End time", std::to_string(4. * period)}});
    const Case<3>  the_case(*p, MPI_COMM_SELF);
    State<3>       state = initial_state(the_case);
    Realisation<3> realisation(the_case, state);
    double         sum = 0., least = 0., most = -1e9;
    unsigned int   n = 0;
    while (realisation.look() == StopReason::none)
      {
        realisation.advance();
        double stress = 0., volume = 0.;
        for (std::size_t q = 0; q < state.points.n_points(); ++q)
          {
            stress += state.points.volume[q] * state.points.stress[q][1][1];
            volume += state.points.volume[q];
          }
        stress /= -volume * weight * height / 2.; // 1: the full weight
        sum += stress;
        ++n;
        least = n == 1 ? stress : std::min(least, stress);
        most  = std::max(most, stress);
      }
    EXPECT_EQ(state.unconverged_steps, 0u);
    EXPECT_NEAR(n, 256, 2);
    // The higher modes, which the steps and cells displace: 0.01.
    EXPECT_NEAR(sum / n, 1., 0.01);
    EXPECT_NEAR(least, s, 0.03);
    EXPECT_NEAR(most, 2. - s, 0.03);
  }


  TEST(SimulationInitialShare, BadShares)
  {
    for (const std::string share : {"0", "1.01", "-0.5"})
      EXPECT_THROW(parameters({{"Gravity/Initial share", share}}), UserError);
    GravityParameters gravity;
    EXPECT_NO_THROW(gravity.check());
    gravity.initial_share = 0.;
    EXPECT_USER_ERROR(gravity.check(), "Gravity/Initial share", "is 0");
  }
} // namespace simulation_initial_share
