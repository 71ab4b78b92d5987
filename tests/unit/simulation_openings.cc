// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/realisation.h>

#include "user_errors.h"
#include <gtest/gtest.h>
#include <map>
#include <numeric>

namespace simulation_openings
{
  // A face that is held in one part and open in another: the ends of the slope
  // of chapter 6.

  using namespace Waker;

  namespace
  {
    std::unique_ptr<Parameters>
    parameters(const std::map<std::string, std::string> &more = {})
    {
      // Two blocks without weight fly to the end at z = 0: one in front of the
      // part that is held, one in front of the open part, x > 3.5.
      std::map<std::string, std::string> settings = {
        {"Grid/Cell size", "0.25"},
        {"Grid/Lower corner", "2, 0, 0"},
        {"Grid/Upper corner", "5, 1, 2"},
        {"Soil profile/Layers", "slope, other"},
        {"Soil profile/slope/Polygon", "2.5,0; 3,0; 3,0.5; 2.5,0.5"},
        {"Soil profile/slope/Extent", "0.25, 1.25"},
        {"Soil profile/slope/Velocity", "0; 0; -2"},
        {"Soil profile/other/Material", "clay"},
        {"Soil profile/other/Polygon", "4,0; 4.5,0; 4.5,0.5; 4,0.5"},
        {"Soil profile/other/Extent", "0.25, 1.25"},
        {"Soil profile/other/Velocity", "0; 0; -2"},
        {"Materials/clay/Initial strength", "1000"},
        {"Materials/clay/Residual strength", "1000"},
        {"Materials/clay/Softening modulus", "0"},
        {"Boundary conditions/Names", "near end, far end"},
        {"Gravity/Acceleration", "0"},
        {"Gravity/Initial stress", "false"},
        {"Gravity/Initial share", "1"},
        {"Time stepping/End time", "1.2"},
        {"Newton/Tolerance", "1e-8"},
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


    void
    make_case(const std::map<std::string, std::string> &more)
    {
      const auto    p = parameters(more);
      const Case<3> the_case(*p, MPI_COMM_SELF);
    }


    double
    mass(const MaterialPoints<3> &points)
    {
      return std::accumulate(points.mass.begin(), points.mass.end(), 0.);
    }
  } // namespace


  TEST(SimulationOpenings, MassAndMomentumCloseAtAFaceThatIsOpenInAPart)
  {
    const auto            p = parameters();
    const Case<3>         the_case(*p, MPI_COMM_SELF);
    State<3>              state = initial_state(the_case);
    Realisation<3>        realisation(the_case, state);
    const FlowAccount<3> &flow = state.flow;
    EXPECT_NEAR(flow.mass_start, 0.5 * 20. / 9.81, 1e-12);
    const double scale = 2. * flow.mass_start; // kN s
    double       worst = 0., most = 0.;
    while (realisation.look() == StopReason::none)
      {
        realisation.advance();
        EXPECT_NEAR(mass(state.points),
                    flow.mass_start - flow.mass_out,
                    1e-13 * scale);
        const Tensor<1, 3> remainder = momentum(state.points) -
                                       flow.momentum_start - flow.impulse +
                                       flow.momentum_out;
        worst = std::max(worst, remainder.norm());
        most  = std::max(most, flow.impulse[2]);
      }
    EXPECT_EQ(state.unconverged_steps, 0u);
    EXPECT_LT(worst, 1e-6 * scale); // Newton's tolerance: 1e-8
    // One block has left with all of its momentum; the support has stopped the
    // other one, and thrown it back.
    EXPECT_EQ(flow.points_out, 128u);
    EXPECT_NEAR(flow.momentum_out[2], -0.5 * scale, 1e-9 * scale);
    EXPECT_GT(most, 0.6 * scale);
    EXPECT_LT(most, 1.01 * scale);
    EXPECT_EQ(state.points.n_points(), 128u);
    for (std::size_t q = 0; q < state.points.n_points(); ++q)
      {
        EXPECT_LT(state.points.initial_position[q][0], 3.);
        EXPECT_GE(state.points.position[q][2], 0.);
      }
  }


  TEST(SimulationOpenings, APartBothHeldAndOpenIsRefused)
  {
    EXPECT_NO_THROW(make_case({}));
    const std::string where = "Outflow/near toe/Face";
    EXPECT_USER_ERROR(make_case({{"Outflow/near toe/From", "3.25, 0, 0"}}),
                      where,
                      "back is closed there, or in a part, by Boundary "
                      "conditions/near end");
    EXPECT_USER_ERROR(make_case({{"Outflow/near toe/From", ""}}),
                      where,
                      "near end");
    // Springs hold as well.
    EXPECT_USER_ERROR(make_case(
                        {{"Outflow/near toe/From", "3.25, 0, 0"},
                         {"Boundary conditions/near end/Method", "penalty"}}),
                      where,
                      "near end");
    // The whole face, of which a part is held.
    EXPECT_USER_ERROR(make_case({{"Outflow/Faces", "right, back"}}),
                      "Outflow/Faces",
                      "near end");
    // A condition that lets the soil through the face.
    EXPECT_NO_THROW(
      make_case({{"Outflow/near toe/From", "3.25, 0, 0"},
                 {"Boundary conditions/near end/Type", "prescribed"},
                 {"Boundary conditions/near end/Displacement", "0; 0; free"}}));
    // A box of held nodes that fills a part of the opening; one inside the
    // body.
    EXPECT_USER_ERROR(make_case(
                        {{"Boundary conditions/near end/Region", "box"},
                         {"Boundary conditions/near end/From", "4, 0, 0"},
                         {"Boundary conditions/near end/To", "4.75, 1, 0.5"}}),
                      where,
                      "near end");
    EXPECT_NO_THROW(
      make_case({{"Boundary conditions/near end/Region", "box"},
                 {"Boundary conditions/near end/From", "4, 0, 0.5"},
                 {"Boundary conditions/near end/To", "4.75, 1, 1"}}));
    EXPECT_USER_ERROR(make_case({{"Outflow/near toe/From", "3.6, 0, 0"}}),
                      "Outflow/near toe/From",
                      "3.6 m in direction x");
    // One part lets soil in, another out; not the same.
    const std::map<std::string, std::string> inflow = {
      {"Inflow/Names", "mouth"},
      {"Inflow/mouth/Face", "back"},
      {"Inflow/mouth/Material", "clay"},
      {"Inflow/mouth/Velocity", "0.1"},
      {"Inflow/mouth/From", "4.5, 0, 0"},
      {"Boundary conditions/Names", ""}};
    EXPECT_USER_ERROR(make_case(inflow), "Inflow/mouth/Face", "soil leaves");
    auto beside                   = inflow;
    beside["Outflow/near toe/To"] = "4.5, 1, 0";
    EXPECT_NO_THROW(make_case(beside));
  }
} // namespace simulation_openings
