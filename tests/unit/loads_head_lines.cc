// SPDX-License-Identifier: LGPL-2.1-or-later
// Heads of the water in the ground that differ with depth.
#include <waker/base/errors.h>
#include <waker/case/case.h>
#include <waker/case/state.h>
#include <waker/loads/heads.h>
#include <waker/loads/pore_water.h>

#include "polder.h"
#include "user_errors.h"
#include <cmath>

namespace loads_head_lines
{
  using namespace Polder;

  namespace
  {
    /// By hand: 3 m down to y = 2, straight to 5 m at y = 0, and 5 m below.
    double
    head(const double y)
    {
      return y >= 2. ? 3. : y >= 0. ? 5. - y : 5.;
    }
  } // namespace


  TEST(HeadLines, the_head_is_interpolated_between_reference_lines)
  {
    const PhreaticLine phreatic("0, 3; 10, 1", "");
    const PhreaticLine deep("0, 6; 10, 4", ""), deeper("0, 2; 10, 2", "");
    // The second layer ends at x = 10.
    const Heads  heads(phreatic,
                      {{PhreaticLine("0, 0; 10, -1", ""), deep, phreatic},
                        {PhreaticLine("0, -2; 10, -1", ""), deep, deeper}});
    const double x = 5.; // 2; 5; 2 m there, the lines at -0.5 and -1.5
    EXPECT_NEAR(heads.at(x, 4.), 2., 1e-14);
    EXPECT_NEAR(heads.at(x, -0.5), 2., 1e-14); // on it: from above
    EXPECT_NEAR(heads.at(x, -0.75), 2. + 0.25 * 3., 1e-14);
    EXPECT_NEAR(heads.at(x, -1.25), 2. + 0.75 * 3., 1e-14);
    EXPECT_NEAR(heads.at(x, -1.5), 5., 1e-14);
    EXPECT_NEAR(heads.at(x, -1.6), 2., 1e-14);
    EXPECT_NEAR(heads.at(10., -0.999), 1., 1e-14);
    EXPECT_NEAR(heads.at(10., -1.001), 2., 1e-14);
    EXPECT_NEAR(heads.at(50., -1.001), 2., 1e-14);
    // None: the phreatic line.
    EXPECT_NEAR(Heads(phreatic, {}).at(x, -7.), 2., 1e-14);
  }


  TEST(HeadLines, pressure_and_vertical_stress_have_them)
  {
    const auto    parameters = ground({});
    const Case<2> the_case(*parameters, MPI_COMM_SELF);
    const auto   &points = the_case.initial_points;
    const auto   &u      = points.scalar("pore pressure");
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const double y = points.position[p][1];
        ASSERT_NEAR(u[p], std::max(gamma_w * (head(y) - y), 0.), 1e-12) << y;
        const unsigned int layer  = y > 0. ? 0 : 1;
        const double       weight = y > 0. ? 15. * (4. - y) : 60. - 20. * y;
        EXPECT_NEAR(
          the_case.ground.at(points.position[p], layer).vertical_stress,
          weight - u[p],
          1e-12);
      }
    // Buoyancy in the aquifer: effective stress in its cells, in balance.
    double       least = 0.;
    unsigned int n     = 0;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      if (points.position[p][1] < -1.5)
        {
          least += points.stress[p][1][1];
          ++n;
        }
    EXPECT_EQ(n, 24u);
    EXPECT_NEAR(least / n, -(60. + 20. * 1.75 - gamma_w * 6.75), 1e-6);
  }


  TEST(HeadLines, in_space_they_extend_along_z)
  {
    PoreWaterParameters p;
    p.phreatic_line = "0, 3; 3, 3";
    HeadLineParameters deep;
    deep.name    = "deep";
    deep.line    = "0, 5; 3, 4";
    p.head_lines = {deep};
    ReferenceLineParameters line;
    line.name             = "sand";
    line.line             = "0, 0; 3, 0";
    line.bottom_head_line = "deep";
    p.reference_lines     = {line};
    p.largest_suction     = 5.;
    const PoreWater<2> plane(p, gamma_w, {true});
    const PoreWater<3> space(p, gamma_w, {true});
    for (const double y : {-3., -0.1, 0.5, 3.2, 7.})
      for (const double z : {-4., 9.})
        EXPECT_EQ(space.pressure({1., y, z}), plane.pressure({1., y}));
    EXPECT_NEAR(space.pressure({1.5, -1., 8.}), gamma_w * 5.5, 1e-13);
    EXPECT_EQ(space.pressure({1.5, 9., 8.}), -5.);
  }


  TEST(HeadLines, they_may_follow_the_water_and_have_a_daily_line)
  {
    PoreWaterParameters p;
    p.phreatic_line = "0, 3; 3, 3";
    HeadLineParameters deep;
    deep.name           = "deep";
    deep.lines_by_level = "2: 0, 2; 3, 2 | 6: 0, 5; 3, 4";
    deep.daily_line     = "0, 1; 3, 1";
    p.head_lines        = {deep};
    ReferenceLineParameters line;
    line.name             = "sand";
    line.line             = "0, 0; 3, 0";
    line.bottom_head_line = " deep ";
    p.reference_lines     = {line};
    EXPECT_NO_THROW(p.check());
    EXPECT_TRUE(p.anything_follows_water());
    const PoreWater<2> water(p, gamma_w, {true}, 4.);
    EXPECT_NEAR(water.pressure({0., -1.}), gamma_w * (3.5 + 1.), 1e-13);
    EXPECT_NEAR(water.pressure({0., 1.}), gamma_w * 2., 1e-13);
    const PoreWater<2> daily(p.of_the_daily_water(), gamma_w, {true}, 4.);
    EXPECT_NEAR(daily.pressure({0., -1.}), gamma_w * 2., 1e-13);
    MaterialPoints<2> points;
    points.id               = {0};
    points.position         = {Point<2>(3., -1.)};
    points.initial_position = points.position;
    water.record(points, 6.);
    EXPECT_NEAR(points.scalar("pore pressure")[0], gamma_w * 5., 1e-13);
  }


  TEST(HeadLines, what_cannot_be_is_refused)
  {
    const std::string deep = "Head lines/deep/", set = "--set ",
                      clay = "Reference lines/bottom of clay/";
    EXPECT_USER_ERROR(ground({clay + "Line=0, 2.5; 3, 0"}),
                      set + clay + "Line",
                      "crosses top of seepage: at x = 0 m it lies at 2.5 m, "
                      "that one at 2 m");
    EXPECT_NO_THROW(ground({clay + "Line=0, 2; 3, 0"})); // they touch
    EXPECT_USER_ERROR(ground({clay + "Line=0, 0; 2, 0"}),
                      set + clay + "Line",
                      "to 2 m");
    EXPECT_USER_ERROR(ground({clay + "Line="}), set + clay + "Line", "empty");
    EXPECT_USER_ERROR(ground({clay + "Top head line=sea"}),
                      set + clay + "Top head line",
                      "none of Head lines/Names");
    EXPECT_USER_ERROR(ground({deep + "Line=0, 5; 2, 5"}),
                      set + deep + "Line",
                      "to 2 m");
    EXPECT_USER_ERROR(ground({deep + "Line=0, 5"}),
                      set + deep + "Line",
                      "1 corner");
    EXPECT_USER_ERROR(ground({deep + "Line=0, 5; 3, nan"}),
                      set + deep + "Line",
                      "nan");
    EXPECT_USER_ERROR(ground({deep + "Line=0, 5; 3, 1e308"}),
                      set + deep + "Line",
                      "corner 2 has y = 1e+308 m");
    EXPECT_USER_ERROR(ground({deep + "Line="}), set + deep + "Line", "empty");
    EXPECT_USER_ERROR(ground({deep + "Daily line=1, 5; 3, 5"}),
                      set + deep + "Daily line",
                      "from x = 1");
    EXPECT_USER_ERROR(ground({deep +
                              "Lines by level=1: 0, 5; 3, 5 | 2: 0, 6; 3, 6"}),
                      set + deep + "Lines by level",
                      "so is Line");
    EXPECT_USER_ERROR(
      ground({deep + "Line=",
              deep + "Lines by level=1: 0, 5; 3, 5 | 2: 0, 6; 3, 6"}),
      set + deep + "Lines by level",
      "no water stands outside");
    for (const auto &[delay, problem] :
         std::vector<std::pair<std::string, std::string>>{
           {"-1", "is -1 s"},
           {"nan", "no place and delay"},
           {"0: 1, 0: 2", "after x = 0 m"}})
      EXPECT_USER_ERROR(ground({deep + "Delay=" + delay}),
                        set + deep + "Delay",
                        problem);
    EXPECT_NO_THROW(ground({deep + "Delay=1"}));
    EXPECT_USER_ERROR(ground(
                        {"Pore water/Phreatic line=", "Head lines/Names=deep"}),
                      set + "Head lines/Names",
                      "there is no phreatic line");
  }


  TEST(HeadLines, what_is_strange_is_said_with_numbers)
  {
    EXPECT_EQ(all_warnings({}), "");
    // At the bottom of the clay: 60 kPa of soil, 70 kPa of water; at the points
    // an eighth of a metre below it 62.5 and 71.25.
    const std::string lifted =
      all_warnings({"Head lines/deep/Line=0, 7; 3, 7"});
    EXPECT_TRUE(has(lifted, "more than the soil above weighs")) << lifted;
    EXPECT_TRUE(has(lifted, "the soil is lifted up")) << lifted;
    EXPECT_TRUE(has(lifted, "effective vertical stress -8.75 ")) << lifted;
    EXPECT_TRUE(has(lifted, "where Head lines/deep makes a pressure of 71.25"))
      << lifted;
    const std::vector<std::string> two = {
      "Head lines/Names=deep, other",
      "Head lines/other/Line=0, 4; 3, 7",
      "Reference lines/bottom of clay/Bottom head line=other"};
    EXPECT_TRUE(has(all_warnings(two),
                    "Head lines/deep and other cross at x = 1 m, at 5 m"));
    EXPECT_TRUE(
      has(all_warnings({"Head lines/deep/Delay=3"}),
          "Head lines/deep/Delay is not used with no Lines by level"));
    EXPECT_TRUE(has(all_warnings({"Reference lines/Names=top of seepage"}),
                    "Head lines/deep is not used"));
    EXPECT_TRUE(
      has(all_warnings({"Reference lines/top of seepage/Top head line=deep"}),
          "top of seepage/Top head line is not used"));
    const std::string no_law =
      all_warnings({"Materials/sand/Model=linear elastic"});
    EXPECT_TRUE(has(no_law,
                    "Materials/sand/Model is linear elastic, but 96 of "
                    "its points lie below the phreatic line"))
      << no_law;
  }


  TEST(HeadLines, what_a_stress_below_0_comes_from_is_named)
  {
    const auto refuses = [](std::vector<std::string> settings,
                            const std::string       &path,
                            const std::string       &text) {
      settings.push_back("Head lines/deep/Line=0, 7; 3, 7");
      const auto parameters = ground(settings);
      EXPECT_USER_ERROR(Case<2>(*parameters, MPI_COMM_SELF), path, text);
    };
    const std::string clay = "Materials/clay/";
    refuses({clay + "Model=von Mises softening",
             clay + "Residual strength=0",
             clay + "Strength from=table",
             clay + "Strength table=0: 5, 100: 30"},
            clay + "Strength table",
            "(uplift: the water there, ");
    refuses({clay + "Model=von Mises softening",
             clay + "Residual strength=0",
             clay + "Strength from=table",
             clay + "Strength table=0: 5, 100: 30"},
            clay + "Strength table",
            " kPa by Pore water/Phreatic line and Head lines/deep");
    refuses({"Initial stress/From=K0"},
            "Initial stress/From",
            "carries more than the soil above weighs)");
  }
} // namespace loads_head_lines
