// SPDX-License-Identifier: LGPL-2.1-or-later
// Vertical stress in the ground at the start, and strengths that follow from
// it.
#include <waker/base/errors.h>
#include <waker/case/case.h>
#include <waker/case/state.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/plausibility.h>

#include "user_errors.h"
#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace case_ground
{
  using namespace Waker;

  namespace
  {
    constexpr double gamma_w = 10.; // the default

    /// Level ground: 2 m of clay on 2 m of peat; the water at 3 m.
    std::unique_ptr<Parameters>
    ground(const std::vector<std::string> &more)
    {
      const std::string path = testing::TempDir() + "waker_ground_" +
                               std::to_string(getpid()) + ".prm";
      std::ofstream(path) << R"(
subsection Grid
  set Lower corner = 0, 0
  set Upper corner = 2, 5
  set Cell size    = 0.5
end
subsection Materials
  set Names = clay, peat
  subsection clay
    set Unit weight           = 14
    set Saturated unit weight = 15
  end
  subsection peat
    set Unit weight        = 11
    set Residual strength  = initial_strength/2
  end
end
subsection Soil profile
  set Layers = top, below
  subsection top
    set Material = clay
    set Polygon  = 0, 2; 2, 2; 2, 4; 0, 4
  end
  subsection below
    set Material = peat
    set Polygon  = 0, 0; 2, 0; 2, 2; 0, 2
  end
end
subsection Boundary conditions
  set Names = base, left side, right side
  subsection base
    set Region = bottom
    set Type   = fixed
  end
  subsection left side
    set Region = left
    set Type   = roller
  end
  subsection right side
    set Region = right
    set Type   = roller
  end
end
subsection Pore water
  set Phreatic line = 0, 3; 2, 3
end
)";
      return read_parameters(path, more);
    }


    /// sigma'_v (kPa) at the height y, with the water at `line`.
    double
    stress(const double y, const double line)
    {
      const auto weight = [](const double from, const double to) {
        return std::max(to - from, 0.);
      };
      const double clay_low = std::max(y, 2.);
      return 14. * weight(std::max(clay_low, line), 4.) +
             15. * weight(clay_low, std::min(line, 4.)) + 11. * weight(y, 2.) +
             gamma_w * weight(4., line) - gamma_w * weight(y, line);
    }


    const std::vector<std::string> shansep = {
      "Materials/peat/Strength from=SHANSEP",
      "Materials/peat/Strength ratio=0.27",
      "Materials/peat/Strength exponent=0.9",
      "Materials/peat/POP=15"};


    /// SHANSEP, but for what is said otherwise.
    std::vector<std::string>
    with(std::vector<std::string> more)
    {
      for (const std::string &usual : shansep)
        {
          const std::string name = usual.substr(0, usual.find('=') + 1);
          if (std::none_of(more.begin(),
                           more.end(),
                           [&](const std::string &setting) {
                             return setting.rfind(name, 0) == 0;
                           }))
            more.push_back(usual);
        }
      return more;
    }
  } // namespace


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


  TEST(Ground, soil_below_the_line_may_be_another)
  {
    // Clay that lies below the line is as wet clay is.
    const Case<2>            level(*ground(
                          {"Materials/Names=clay, peat, wet clay",
                                      "Materials/clay/Below the line=wet clay",
                                      "Materials/clay/Initial strength=30",
                                      "Materials/wet clay/Unit weight=16",
                                      "Materials/wet clay/Saturated unit weight=18",
                                      "Materials/wet clay/Strength from=table",
                                      "Materials/wet clay/Strength table=0: 5, 90: 50",
                                      "Materials/wet clay/Residual strength=2"}),
                        MPI_COMM_SELF);
    const MaterialPoints<2> &points = level.initial_points;
    const auto              &values =
      points.scalars[points.find_scalar("undrained shear strength")].values;
    unsigned int n_wet = 0;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const double y = points.initial_position[p][1];
        const double g = 9.81, volume = 0.0625;
        if (y > 3.)
          {
            EXPECT_EQ(points.material[p], 0u);
            EXPECT_EQ(values[p], 30.);
            EXPECT_NEAR(points.mass[p], 14. / g * volume, 1e-14);
          }
        else if (y > 2.)
          {
            ++n_wet;
            EXPECT_EQ(points.material[p], 2u);
            const double stress = 14. + 8. * (3. - y);
            EXPECT_NEAR(values[p], 5. + 0.5 * stress, 1e-12);
            EXPECT_NEAR(points.mass[p], 18. / g * volume, 1e-14);
          }
        else
          {
            EXPECT_EQ(points.material[p], 1u);
            EXPECT_NEAR(level.ground.at({0.75, y}, 1).vertical_stress,
                        14. + 8. + 1. * (2. - y),
                        1e-12);
          }
      }
    EXPECT_EQ(n_wet, 32u);
    // The weight is borne by the base.
    double weight = 0.;
    for (const double mass : points.mass)
      weight += 9.81 * mass;
    EXPECT_NEAR(weight, 2. * (14. + 18. + 2. * 11.), 1e-10);
  }


  TEST(Ground, what_is_below_the_line_is_another_material)
  {
    const std::string path = "--set Materials/clay/Below the line";
    for (const char *const name : {"sand", "clay", "clay, peat"})
      EXPECT_USER_ERROR(ground({std::string("Materials/clay/Below the line=") +
                                name}),
                        path,
                        name);
    EXPECT_USER_ERROR(ground({"Materials/clay/Below the line=peat",
                              "Materials/peat/Below the line=clay"}),
                      path,
                      "peat");
    EXPECT_USER_ERROR(ground({"Materials/clay/Below the line=peat",
                              "Inflow/Names=in",
                              "Inflow/in/Material=clay",
                              "Inflow/in/Face=left"}),
                      path,
                      "flows in");
  }


  // Without water in it, it cannot boil.
  TEST(Ground, drained_soil_that_stays_above_the_line_needs_no_special_water)
  {
    const auto with_water = [](const std::vector<std::string> &more) {
      std::vector<std::string> all = {"Materials/Names=clay, peat, wet clay",
                                      "Materials/clay/Model=Mohr-Coulomb",
                                      "Materials/clay/Below the line=wet clay",
                                      "Materials/wet clay/Unit weight=16",
                                      "Water/Side=left",
                                      "Water/Level=3",
                                      "Surface/Method=contour"};
      all.insert(all.end(), more.begin(), more.end());
      return ground(all);
    };
    const std::string soil = "Pore water/Pressure of=soil";
    EXPECT_NO_THROW(with_water({soil}));
    EXPECT_NO_THROW(with_water({"Water/Minimum support=0"}));
    for (const auto &more :
         {std::vector<std::string>{},
          std::vector<std::string>{soil, "Pore water/Largest suction=5"},
          std::vector<std::string>{soil, "Materials/peat/Model=Mohr-Coulomb"}})
      {
        std::vector<std::string> settings = more;
        settings.push_back("Water/Minimum support=0.01");
        EXPECT_USER_ERROR(with_water(settings),
                          "--set Water/Minimum support",
                          "drained");
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
