// SPDX-License-Identifier: LGPL-2.1-or-later
// Loads that the soil has not consolidated under, and soil that does not drain,
// in the ground.
#include <waker/base/errors.h>
#include <waker/case/case.h>
#include <waker/case/state.h>
#include <waker/loads/quick_loads.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/plausibility.h>
#include <waker/simulation/realisation.h>

#include "level_ground.h"
#include "user_errors.h"
#include <cmath>
#include <gtest/gtest.h>

namespace loads_quick_loads
{
  using namespace Waker;

  namespace
  {
    constexpr double gamma_w = 10.; // the default

    /// Level ground, 1 m of sand on 3 m of clay, with the water at 3 m, and
    /// 13 kPa all over it.
    std::unique_ptr<Parameters>
    ground(const std::vector<std::string> &more)
    {
      return read_parameters(LevelGround::written(LevelGround::text_of(
                               {2.,
                                5.,
                                {{"road", "sand", 3., 4.},
                                 {"below", "clay", 0., 3.}},
                                R"(
subsection Materials
  set Names = sand, clay
  subsection sand
    set Model           = Mohr-Coulomb
    set Unit weight     = 18
    set Poisson's ratio = 0.3
  end
  subsection clay
    set Model           = Mohr-Coulomb
    set Unit weight     = 15
    set Poisson's ratio = 0.3
    set Friction angle  = 25
  end
end
)",
                                R"(
subsection Pore water
  set Phreatic line = 0, 3; 2, 3
end
subsection Tractions
  set Names = traffic
  subsection traffic
    set Kind          = pressure
    set Value         = 13
    set From          = -1, 3.5
    set To            = 3, 4.5
    set Facing        = 0, 1
    set Consolidation = below: 0.1
  end
end
)"})),
                             more);
    }
  } // namespace


  // Of a program that assessments use: 13 kPa and 10 % leave 11.7 kPa.
  TEST(QuickLoads, ten_percent_of_thirteen_leave_eleven_point_seven)
  {
    const auto    parameters = ground({});
    const Case<2> the_case(*parameters, MPI_COMM_SELF);
    const auto   &points  = the_case.initial_points;
    const auto   &u       = points.scalar("pore pressure");
    const auto   &of_load = points.scalar("pore pressure of loads");
    double        sum = 0., expected = 0.;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const double y     = points.position[p][1];
        const double water = std::max(gamma_w * (3. - y), 0.);
        const double quick = y < 3. ? 11.7 : 0.;
        EXPECT_NEAR(of_load[p], quick, 1e-13);
        EXPECT_NEAR(u[p], water + quick, 1e-12);
        // The grains have the rest of it, also those of the sand.
        const double stress =
          y > 3. ? 18. * (4. - y) + 13. : 18. + 15. * (3. - y) + 1.3 - water;
        const InGround in =
          the_case.ground.at(points.position[p], y > 3. ? 0 : 1);
        EXPECT_NEAR(in.vertical_stress, stress, 1e-12);
        EXPECT_NEAR(in.daily_vertical_stress,
                    stress - (y > 3. ? 13. : 1.3),
                    1e-12);
        sum += points.volume[p] * points.stress[p][1][1];
        expected -= points.volume[p] * stress;
      }
    // In balance: the effective stress of the laws, in the mean.
    EXPECT_NEAR(sum, expected, 1e-6 * std::abs(expected));
  }


  TEST(QuickLoads, they_spread)
  {
    const auto parameters = ground({"Tractions/traffic/From=0.5, 3.5",
                                    "Tractions/traffic/To=1.5, 4.5",
                                    "Tractions/traffic/Spread=30",
                                    "Tractions/traffic/Consolidation=0.25"});
    const BackgroundGrid<2> grid({0., 0.}, {2., 5.}, 0.5, MPI_COMM_SELF);
    const SoilDepths<2>     depths(grid, parameters->layers);
    const QuickLoads<2> load(parameters->tractions, parameters->layers, depths);
    const double        tangent = std::tan(std::acos(-1.) / 6.);
    EXPECT_NEAR(load.stress({1., 4.}), 13., 1e-13);
    EXPECT_NEAR(load.stress({0.4, 4.}), 0., 1e-13);
    for (const double depth : {0.5, 1.7, 3.})
      {
        const double wider = depth * tangent, q = 13. / (1. + 2. * wider);
        const double y = 4. - depth;
        EXPECT_NEAR(load.stress({1., y}), q, 1e-12);
        EXPECT_NEAR(load.stress({0.5 - 0.999 * wider, y}), q, 1e-12);
        EXPECT_EQ(load.stress({0.5 - 1.001 * wider, y}), 0.);
        EXPECT_EQ(load.stress({1.5 + 1.001 * wider, y}), 0.);
        EXPECT_NEAR(load.pore_pressure({1., y}, 1), 0.75 * q, 1e-12);
        EXPECT_NEAR(load.pore_pressure({1., y}, 0), 0.75 * q, 1e-12);
        EXPECT_EQ(load.pore_pressure({1., y}, 7), 0.); // flowed in
      }
  }


  // In space a wheel spreads both ways; a road along all of z has no ends.
  TEST(QuickLoads, in_space_they_spread_both_ways)
  {
    TractionParameters wheel;
    wheel.name          = "wheel";
    wheel.kind          = TractionKind::vector;
    wheel.value         = "1; -20; 0";
    wheel.from          = {0., 3., 2.};
    wheel.to            = {2., 5., 3.};
    wheel.spread        = 45.;
    wheel.consolidation = "soil: 0";
    wheel.check(3, ShapeFunctions::gimp);
    LayerParameters layer;
    layer.name    = "soil";
    layer.polygon = "-3, 0; 5, 0; 5, 4; -3, 4";
    const BackgroundGrid<3> grid({-3., 0., 0.},
                                 {5., 5., 5.},
                                 1.,
                                 MPI_COMM_SELF);
    const SoilDepths<3>     depths(grid, {layer});
    const QuickLoads<3>     load({wheel}, {layer}, depths);
    EXPECT_NEAR(load.stress({1., 2.5, 2.5}),
                20. * 2. / (2. + 3.) * 1. / (1. + 3.),
                1e-12);
    EXPECT_EQ(load.stress({1., 2.5, 4.6}), 0.);
    EXPECT_NEAR(load.pore_pressure({1., 4., 2.5}, 0), 20., 1e-12);
  }


  TEST(QuickLoads, strengths_count_what_the_grains_have)
  {
    const std::string              clay       = "Materials/clay/";
    const std::vector<std::string> shansep    = {clay + "Model=von Mises "
                                                           "softening",
                                                 clay + "Strength from=SHANSEP",
                                                 clay + "Strength ratio=0.25",
                                                 clay + "Strength exponent=0.8",
                                                 clay + "POP=20",
                                                 clay + "Residual strength=1"};
    const auto                     parameters = ground(shansep);
    const Case<2>                  the_case(*parameters, MPI_COMM_SELF);
    const auto                    &points = the_case.initial_points;
    const auto  &s_u = points.scalar("undrained shear strength");
    unsigned int n   = 0;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      if (const double y = points.position[p][1]; y < 3.)
        {
          const double daily = 18. + (15. - gamma_w) * (3. - y);
          const double now   = daily + 1.3;
          EXPECT_NEAR(s_u[p],
                      0.25 * now * std::pow((daily + 20.) / now, 0.8),
                      1e-11);
          ++n;
        }
    EXPECT_EQ(n, 96u);
  }


  TEST(QuickLoads, what_cannot_be_is_refused)
  {
    const std::string traffic = "Tractions/traffic/", set = "--set ",
                      degree = traffic + "Consolidation";
    for (const auto &[text, problem] :
         std::vector<std::pair<std::string, std::string>>{
           {"1.1", "degree 1.1"},
           {"-0.1", "degree -0.1"},
           {"nan", "no layer and degree"},
           {"below: nan", "no layer and degree"},
           {"below: 2", "degree 2"},
           {"peat: 0.1", "no layer \"peat\""},
           {"below: 0.1, below: 0.2", "twice"},
           {"below", "no layer and degree"}})
      EXPECT_USER_ERROR(ground({degree + "=" + text}), set + degree, problem);
    EXPECT_NO_THROW(ground({degree + "=road: 1, below: 0"}));
    EXPECT_USER_ERROR(ground({traffic + "Value=13*t"}),
                      set + traffic + "Value",
                      "with a Consolidation");
    EXPECT_USER_ERROR(ground({traffic + "Value=-13"}),
                      set + traffic + "Value",
                      "upwards");
    EXPECT_USER_ERROR(ground({traffic + "From=", traffic + "To="}),
                      set + traffic + "From",
                      "is empty");
    EXPECT_USER_ERROR(ground({traffic + "Kind=hydrostatic",
                              traffic + "Level=4",
                              degree + "=1"}),
                      set + degree,
                      "is hydrostatic");
    EXPECT_USER_ERROR(ground({"Pore water/Phreatic line=", degree + "=1"}),
                      set + degree,
                      "no phreatic line");
    for (const std::string angle : {"-1", "81", "nan", "1e308"})
      EXPECT_USER_ERROR(ground({traffic + "Spread=" + angle}),
                        set + traffic + "Spread",
                        "\"" + angle + "\"");
    EXPECT_USER_ERROR(ground({"Load programmes/Names=more",
                              "Load programmes/more/Drives=traction",
                              "Load programmes/more/Load=traffic"}),
                      set + "Load programmes/more/Load",
                      "has a Consolidation");
    EXPECT_USER_ERROR(Case<2>(*ground({traffic + "From=7, 3.5",
                                       traffic + "To=9, 4.5"}),
                              MPI_COMM_SELF),
                      traffic + "From",
                      "where no soil is");
    EXPECT_USER_ERROR(ground({"Materials/clay/Pore fluid stiffness=1e5",
                              "Kinematics and mapping/Strain=logarithmic"}),
                      set + "Materials/clay/Pore fluid stiffness",
                      "logarithmic");
  }


  TEST(QuickLoads, what_is_strange_is_said)
  {
    const auto said = [](const std::vector<std::string> &more,
                         const std::string              &words) {
      for (const std::string &text : strange_parameters(*ground(more)))
        if (text.find(words) != std::string::npos)
          return true;
      return false;
    };
    EXPECT_TRUE(
      said({"Tractions/traffic/Consolidation=", "Tractions/traffic/Spread=30"},
           "Spread is not used"));
    EXPECT_FALSE(said({"Tractions/traffic/Spread=30"}, "Spread"));
    const std::string water = "Materials/clay/Pore fluid stiffness=";
    EXPECT_TRUE(said({water + "1e5"}, "cells lock"));
    EXPECT_FALSE(
      said({water + "1e4", "Kinematics and mapping/Volumetric strain=B-bar"},
           "Pore fluid stiffness"));
    EXPECT_TRUE(
      said({water + "5e5", "Kinematics and mapping/Volumetric strain=B-bar"},
           "long to solve"));
  }


  // In situ the soil has drained; a load that comes later is in its water. With
  // sides that hold, by K_f over the constrained modulus of all.
  TEST(QuickLoads, undrained_soil_bears_a_load_by_its_water)
  {
    const double K_f = 1e5;
    const auto   parameters =
      ground({"Materials/clay/Pore fluid stiffness=1e5",
              "Materials/sand/Pore fluid stiffness=1e5",
              "Kinematics and mapping/Volumetric strain=B-bar",
              "Tractions/traffic/Consolidation=",
              "Tractions/traffic/Value=10*min(t, 1)",
              "Time stepping/Scheme=quasi-static",
              "Newton/Tolerance=1e-9",
              "Time stepping/Move points=false",
              "Time stepping/Time step=0.25"});
    const Case<2> the_case(*parameters, MPI_COMM_SELF);
    const auto    drained = ground({"Tractions/traffic/Consolidation=",
                                    "Kinematics and mapping/Volumetric "
                                       "strain=B-bar",
                                    "Tractions/traffic/Value=0*t"});
    const Case<2> before(*drained, MPI_COMM_SELF);
    State<2>      state = initial_state(the_case);
    for (std::size_t p = 0; p < state.points.n_points(); ++p)
      {
        EXPECT_EQ(state.points.scalar("excess pore pressure")[p], 0.);
        ASSERT_NEAR(
          (state.points.stress[p] - before.initial_points.stress[p]).norm(),
          0.,
          1e-6);
      }
    Realisation<2> realisation(the_case, state);
    for (unsigned int i = 0; i < 4; ++i)
      {
        realisation.look();
        realisation.advance();
        EXPECT_LT(std::abs(state.energy.remainder()), 1e-4);
      }
    EXPECT_EQ(state.unconverged_steps, 0u);
    // E = 1000 kPa, nu = 0.3 by default and above.
    const double M    = 1000. * 0.7 / (1.3 * 0.4);
    double       mean = 0.;
    for (const double u : state.points.scalar("excess pore pressure"))
      mean += u / state.points.n_points();
    EXPECT_NEAR(mean, 10. * K_f / (K_f + M), 1e-3);
    double stress = 0., start = 0.;
    for (std::size_t p = 0; p < state.points.n_points(); ++p)
      {
        stress += state.points.stress[p][1][1] / state.points.n_points();
        start += before.initial_points.stress[p][1][1] /
                 before.initial_points.n_points();
      }
    EXPECT_NEAR(stress, start - 10., 1e-3);
  }
} // namespace loads_quick_loads
