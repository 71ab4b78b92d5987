// SPDX-License-Identifier: LGPL-2.1-or-later
// Vertical stress in the ground at the start, and strengths that follow from
// it.
#include <waker/base/errors.h>
#include <waker/case/case.h>
#include <waker/case/state.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/plausibility.h>

#include "clay_on_peat.h"
#include "level_ground.h"
#include "user_errors.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace case_ground
{
  using namespace Waker;
  using namespace ClayOnPeat;

  TEST(Ground,
       vertical_stress_is_the_weight_of_soil_and_water_less_the_pressure)
  {
    for (const double line : {-1., 1., 2.5, 4., 4.75})
      for (const double daily : {0.5, 2.25, 3.5})
        {
          const std::string at   = std::to_string(line);
          const std::string then = std::to_string(daily);
          const Case<2>     level(*ground({"Pore water/Phreatic line=0," + at +
                                             "; 2, " + at,
                                           "Pore water/Daily phreatic line=0," +
                                             then + "; 2, " + then}),
                              MPI_COMM_SELF);
          for (const double y : {0.25, 1.75, 2.25, 3.75})
            {
              const InGround in = level.ground.at({0.75, y}, y < 2. ? 1 : 0);
              EXPECT_NEAR(in.vertical_stress, stress(y, line), 1e-12);
              EXPECT_NEAR(in.daily_vertical_stress, stress(y, daily), 1e-12);
              EXPECT_NEAR(in.depth, 4. - y, 1e-14);
            }
        }
  }


  // Clay on peat of 1.5 m with a gap of half a metre between them, full of
  // water; the line above it.
  TEST(Ground, water_in_gaps_has_its_weight)
  {
    const Case<2> level(*ground({"Soil profile/below/Polygon=0,0; 2,0; 2,1.5; "
                                 "0,1.5",
                                 "Gravity/Initial stress=false"}),
                        MPI_COMM_SELF);
    EXPECT_NEAR(level.ground.at({0.75, 1.25}, 1).vertical_stress,
                14. + 15. + 0.5 * gamma_w + 0.25 * 11. - 1.75 * gamma_w,
                1e-12);
    // In the clay it is not over the place.
    EXPECT_NEAR(level.ground.at({0.75, 2.25}, 0).vertical_stress,
                14. + 0.75 * (15. - gamma_w),
                1e-12);
  }


  TEST(Ground, without_gravity_nothing_weighs_anything)
  {
    const Case<2> level(*ground({"Pore water/Phreatic line=0,-1; 2,-1",
                                 "Gravity/Acceleration=0"}),
                        MPI_COMM_SELF);
    EXPECT_EQ(level.ground.at({0.75, 0.25}, 1).vertical_stress, 0.);
    EXPECT_TRUE(std::isnan(level.ground.at({0.75, 0.25}, 2).vertical_stress));
  }


  // Ladd & Foott (1974); of a program that assessments use: s_u = 24.978
  // kPa and OCR = 1.2112 from 95.551 and 115.731 kPa.
  TEST(Ground, shansep_has_its_numbers)
  {
    UndrainedStrengthParameters soil;
    soil.from     = StrengthFrom::shansep;
    soil.ratio    = 0.22;
    soil.exponent = 0.9;
    soil.pop      = 20.18;
    const InGround           place{0., 0., 95.551, 95.551};
    const PlaceExpression<2> strength(soil.expression("", ""), "strength");
    const PlaceExpression<2> ratio(soil.overconsolidation(), "OCR");
    EXPECT_NEAR(strength.value({0., 0.}, place), 24.978, 5e-4);
    EXPECT_NEAR(ratio.value({0., 0.}, place), 1.2112, 5e-5);
    // The daily stress decides on the yield stress.
    soil.pop = 0.;
    const PlaceExpression<2> by_water(soil.expression("", ""), "strength");
    EXPECT_NEAR(by_water.value({0., 0.}, {0., 0., 95.551, 115.731}),
                24.978,
                5e-4);
  }


  TEST(Ground, points_have_the_strength_of_the_stress_in_the_ground)
  {
    const Case<2> level(*ground(with({"Pore water/Phreatic line=0,4; 2,4",
                                      "Pore water/Daily phreatic line="
                                      "0,2.5; 2,2.5"})),
                        MPI_COMM_SELF);
    const MaterialPoints<2> &points = level.initial_points;
    const auto values = [&](const std::string &name) -> const auto &
    {
      return points.scalars[points.find_scalar(name)].values;
    };
    unsigned int n = 0;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const double y = points.initial_position[p][1];
        if (y > 2.)
          {
            EXPECT_EQ(values("undrained shear strength")[p], 13.);
            continue;
          }
        ++n;
        const double now = stress(y, 4.), yield = stress(y, 2.5) + 15.;
        const double s_u = 0.27 * now * std::pow(yield / now, 0.9);
        EXPECT_NEAR(values("undrained shear strength")[p], s_u, 1e-12);
        EXPECT_NEAR(values("residual strength")[p], s_u / 2., 1e-12);
        EXPECT_NEAR(values("overconsolidation ratio")[p], yield / now, 1e-12);
      }
    EXPECT_EQ(n, 64u);
  }


  TEST(Ground, a_table_has_straight_lines)
  {
    UndrainedStrengthParameters soil;
    soil.from  = StrengthFrom::table;
    soil.table = "10: 4, 20: 5, 60: 17";
    const PlaceExpression<2> strength(soil.expression("", ""), "strength");
    for (const auto &[stress, expected] :
         std::vector<std::pair<double, double>>{
           {0., 4.}, {10., 4.}, {15., 4.5}, {20., 5.}, {40., 11.}, {90., 17.}})
      EXPECT_NEAR(strength.value({0., 0.}, {0., 0., stress, 0.}),
                  expected,
                  1e-13);
    const Case<2> level(*ground({"Materials/clay/Strength from=table",
                                 "Materials/clay/Strength table=0: 4, 60: 34",
                                 "Materials/clay/Residual strength=1"}),
                        MPI_COMM_SELF);
    const MaterialPoints<2> &points = level.initial_points;
    const auto              &values =
      points.scalars[points.find_scalar("undrained shear strength")].values;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const double y = points.initial_position[p][1];
        if (y > 2.)
          {
            EXPECT_NEAR(values[p], 4. + 0.5 * stress(y, 3.), 1e-12);
          }
      }
  }


  TEST(Ground, what_cannot_be_is_refused)
  {
    const std::string peat = "Materials/peat/", set = "--set ";
    EXPECT_USER_ERROR(ground(with({peat + "POP=-1"})),
                      set + peat + "POP",
                      "-1");
    EXPECT_USER_ERROR(ground(with({peat + "Strength ratio=0"})),
                      set + peat + "Strength ratio",
                      "0");
    for (const auto &[table, problem] :
         std::vector<std::pair<std::string, std::string>>{
           {"5: 3", "1 pair"},
           {"5: 3, 5: 4", "5 kPa after 5 kPa"},
           {"5: 3, 6", "\"6\", not two numbers"},
           {"-5: 3, 6: 4", "\"-5: 3\""},
           {"0: 3, inf: 4", "\"inf: 4\""}})
      EXPECT_USER_ERROR(ground({peat + "Strength from=table",
                                peat + "Strength table=" + table}),
                        set + peat + "Strength table",
                        problem);
    // A yield stress below the stress of now: the water stood higher than
    // today.
    EXPECT_USER_ERROR(Case<2>(*ground(with(
                                {peat + "POP=0",
                                 "Pore water/Phreatic line=0,1; 2,1",
                                 "Pore water/Daily phreatic line=0,4; 2,4"})),
                              MPI_COMM_SELF),
                      peat + "POP",
                      "is 0.");
    // Soil lighter than water floats up.
    EXPECT_USER_ERROR(Case<2>(*ground(with({"Materials/peat/Unit weight=5",
                                            "Materials/clay/Unit weight=5",
                                            "Materials/clay/Saturated unit "
                                            "weight=5",
                                            "Pore water/Phreatic line="
                                            "0,4; 2,4"})),
                              MPI_COMM_SELF),
                      peat + "Strength from",
                      "where vertical_stress is -");
    // In a table and in an expression, too.
    EXPECT_USER_ERROR(Case<2>(*ground({"Materials/clay/Unit weight=5",
                                       "Materials/clay/Saturated unit weight=5",
                                       "Pore water/Phreatic line=0,4; 2,4",
                                       "Materials/clay/Initial strength=13 + "
                                       "vertical_stress/10"}),
                              MPI_COMM_SELF),
                      "Materials/clay/Initial strength",
                      "where vertical_stress is ");
    EXPECT_USER_ERROR(Case<2>(*ground(with({"Gravity/Acceleration=0"})),
                              MPI_COMM_SELF),
                      peat + "Strength from",
                      "Gravity/Acceleration is 0");
    std::string many;
    for (unsigned int i = 0; i < 26; ++i)
      many += (i > 0 ? ", " : "") + std::to_string(i) +
              ".123456: " + std::to_string(i) + ".987654";
    EXPECT_USER_ERROR(ground({peat + "Strength table=" + many}),
                      set + peat + "Strength table",
                      "26 pairs");
    EXPECT_NO_THROW(
      ground({peat + "Strength table=" + many.substr(0, many.rfind(','))}));
    EXPECT_USER_ERROR(ground({"Pore water/Daily phreatic line=0,3; 1,3"}),
                      set + "Pore water/Daily phreatic line",
                      "to 1 m");
    EXPECT_USER_ERROR(ground({"Pore water/Phreatic line=",
                              "Pore water/Daily phreatic line=0,3; 2,3"}),
                      set + "Pore water/Daily phreatic line",
                      "Phreatic line is empty");
    EXPECT_USER_ERROR(Case<2>(*ground(with({"Pore water/Phreatic line=",
                                            "Water/Side=left",
                                            "Water/Level=3"})),
                              MPI_COMM_SELF),
                      peat + "Strength from",
                      "nothing says where it is in the ground");
  }


  TEST(Ground, what_is_strange_is_said)
  {
    const auto said = [](const std::vector<std::string> &more,
                         const std::string              &words) {
      for (const std::string &text : strange_parameters(*ground(more)))
        if (text.find(words) != std::string::npos)
          return true;
      return false;
    };
    EXPECT_TRUE(said({"Materials/peat/POP=5"}, "POP is not used"));
    EXPECT_TRUE(said(with({"Materials/peat/Initial strength=9"}),
                     "Initial strength is not used"));
    EXPECT_TRUE(said({"Materials/clay/Model=Mohr-Coulomb",
                      "Materials/clay/Strength from=SHANSEP"},
                     "clay/Strength from is not used"));
    EXPECT_TRUE(said({"Materials/peat/Strength table=0: 1, 2: 3"},
                     "Strength table is not used"));
    EXPECT_FALSE(said(shansep, "not used"));
    EXPECT_TRUE(said(with({"Materials/peat/Strength ratio=2"}), "is 2"));
    EXPECT_TRUE(said(with({"Materials/peat/POP=500"}), "is 500"));
    // The line serves the strength.
    const std::vector<std::string> dry = {
      "Materials/clay/Saturated unit weight=0"};
    EXPECT_TRUE(said(dry, "Phreatic line is not used"));
    EXPECT_FALSE(said(with(dry), "Phreatic line is not used"));
  }
} // namespace case_ground
