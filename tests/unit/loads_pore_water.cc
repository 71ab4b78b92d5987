// SPDX-License-Identifier: LGPL-2.1-or-later
// Water in the ground: its pressure, its nodal forces, and effective stress in
// situ.
#include <waker/base/errors.h>
#include <waker/case/case.h>
#include <waker/case/state.h>
#include <waker/loads/pore_water.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/plausibility.h>

#include "level_ground.h"
#include "mapping_lattice.h"
#include "user_errors.h"
#include "warnings.h"
#include <map>

namespace loads_pore_water
{
  using namespace Waker;

  namespace
  {
    PoreWaterParameters
    line(const std::string &text, const double suction = 0.)
    {
      PoreWaterParameters p;
      p.phreatic_line   = text;
      p.largest_suction = suction;
      return p;
    }


    /// Level ground, 4 m of sand, in a box with smooth sides.
    std::unique_ptr<Parameters>
    ground(const std::vector<std::string> &more)
    {
      const std::string text =
        LevelGround::text_of({3.,
                              5.,
                              {{"ground", "sand", 0., 4.}},
                              R"(
subsection Materials
  set Names = sand
  subsection sand
    set Model                 = Mohr-Coulomb
    set Unit weight           = 16
    set Saturated unit weight = 20
    set Poisson's ratio       = 0.3
    set Cohesion              = 1
    set Friction angle        = 30
  end
end
)",
                              R"(
subsection Pore water
  set Phreatic line = 0, 3; 3, 3
end
)",
                              0.25});
      return read_parameters(LevelGround::written(text), more);
    }
  } // namespace


  TEST(Loads, pore_pressure_is_hydrostatic_below_the_line)
  {
    const PoreWater<2> water(line("0, 2; 4, 4; 10, 4"), 10., {true});
    EXPECT_NEAR(water.pressure({2., 1.}), 20., 1e-13);  // 3 m high there
    EXPECT_NEAR(water.pressure({-5., 1.}), 10., 1e-13); // level beyond the ends
    EXPECT_NEAR(water.pressure({50., 1.}), 30., 1e-13);
    EXPECT_EQ(water.pressure({4., 4.}), 0.);
    EXPECT_EQ(water.pressure({6., 5.}), 0.);
    const PoreWater<3> dry(line("0, 2; 4, 4", 15.), 10., {true});
    EXPECT_NEAR(dry.pressure({4., 5., 7.}), -10., 1e-13);
    EXPECT_NEAR(dry.pressure({4., 9., 7.}), -15., 1e-13);
  }


  TEST(Loads, a_phreatic_line_follows_the_water_outside)
  {
    PoreWaterParameters p;
    p.lines_by_level = "1: 0, 1; 10, 0 | 3: 0, 3; 4, 3; 10, 1 | 4: 0, 4; 10, 1";
    const PhreaticLines lines = p.lines();
    ASSERT_EQ(lines.all().size(), 3u);
    const auto height = [&](const double level, const double x) {
      return lines.at(level).height(x);
    };
    for (const double x : {0., 2., 4., 7., 10., 12.})
      {
        const double at_1 = std::max(1. - x / 10., 0.);
        const double at_3 = x < 4. ? 3. : std::max(3. - (x - 4.) / 3., 1.);
        const double at_4 = std::max(4. - 0.3 * x, 1.);
        EXPECT_NEAR(height(-5., x), at_1, 1e-14);
        EXPECT_NEAR(height(1., x), at_1, 1e-14);
        EXPECT_NEAR(height(1.5, x), 0.75 * at_1 + 0.25 * at_3, 1e-14);
        EXPECT_NEAR(height(3., x), at_3, 1e-14);
        EXPECT_NEAR(height(3.75, x), 0.25 * at_3 + 0.75 * at_4, 1e-14);
        EXPECT_NEAR(height(9., x), at_4, 1e-14);
      }
    // The points have the pressure of the level now.
    const PoreWater<2> water(p, 10., {true}, 3.);
    EXPECT_NEAR(water.pressure({4., 1.}), 20., 1e-13);
    MaterialPoints<2> points;
    points.id               = {0};
    points.position         = {Point<2>(4., 1.)};
    points.initial_position = points.position;
    water.record(points, 2.);
    EXPECT_NEAR(points.scalar("pore pressure")[0],
                10. * (0.5 * 0.6 + 0.5 * 3. - 1.),
                1e-13);
    water.record(points, 3.);
    EXPECT_NEAR(points.scalar("pore pressure")[0], 20., 1e-13);

    const std::string path = "Pore water/Lines by level";
    for (const auto &[text, problem] :
         std::vector<std::pair<std::string, std::string>>{
           {"1: 0, 1; 9, 1", "1 line"},
           {"1: 0, 1; 9, 1 | 0, 2; 9, 2", "does not begin with a level"},
           {"1: 0, 1; 9, 1 | 1: 0, 2; 9, 2", "1 m after 1 m"},
           {"1: 0, 1; 9, 1 | 1.000000001: 0, 2; 9, 2", "nearly one"},
           {"1: 0, 1; 9, 1 | nan: 0, 2; 9, 2", "does not begin"},
           {"1: 0, 1; 9, 1 | 2:", "no corners at the level 2"},
           {"1: 0, 1; 9, 1 | 2: 0, 2", "1 corner"}})
      {
        PoreWaterParameters bad;
        bad.lines_by_level = text;
        EXPECT_USER_ERROR(bad.check(), path, problem);
      }
    p.phreatic_line = "0, 1; 9, 1";
    EXPECT_USER_ERROR(p.check(), path, "so is Phreatic line");
  }


  TEST(Loads, phreatic_lines_that_are_none)
  {
    const std::string path = "Pore water/Phreatic line";
    EXPECT_USER_ERROR(line("0, 2").check(), path, "1 corner");
    EXPECT_USER_ERROR(line("0, 2; 0, 3").check(), path, "x = 0 m after");
    EXPECT_USER_ERROR(line("0, 2; 5; 6, 2").check(), path, "\"5\"");
    EXPECT_USER_ERROR(line("0, 2; 5, 2", -1.).check(),
                      "Pore water/Largest suction",
                      "-1");
    EXPECT_NO_THROW(line("0, 2; 5, 2;").check());
    EXPECT_NO_THROW(line("").check());
    EXPECT_USER_ERROR(ground({"Pore water/Phreatic line=0, 3; 2.5, 3"}),
                      "--set " + path,
                      "\"ground\" to 3 m");
  }


  TEST(Loads, pore_water_takes_part_in_laws_of_effective_stress)
  {
    // The forces are those of a stress u 1 of these points, and none in sum.
    Lattice::Random         random(503);
    const BackgroundGrid<2> grid(Lattice::grid<2>(1.5, 0.25));
    MaterialPoints<2>       points = Lattice::box(Point<2>(0.3, 0.35), 4, 0.11);
    for (unsigned int p = 0; p < points.n_points(); ++p)
      points.material[p] = p % 2;
    Weights<2> weights(grid, ShapeFunctions::gimp);
    weights.reinit(points);
    const PoreWater<2> water(line("-9, 3; 9, 5"), 10., {false, true});
    water.record(points);
    NodalVector force(grid.n_dofs());
    water.add_nodal_forces(points, weights, force);
    const auto u =
      Lattice::linear_field(grid, random.matrix<2>(-1., 1.), Tensor<1, 2>());
    const double before = u * force;
    Tensor<2, 2> A;
    double       expected = 0.;
    const auto   at       = [&](const unsigned int node, const int c) {
      return u.begin()[2 * node + c];
    };
    // The gradient of a linear field from two nodes of a cell.
    for (unsigned int c = 0; c < 2; ++c)
      for (unsigned int d = 0; d < 2; ++d)
        A[c][d] = (at(grid.stride(d), c) - at(0, c)) * grid.inverse_cell_size();
    for (unsigned int p = 1; p < points.n_points(); p += 2)
      expected +=
        points.volume[p] * water.pressure(points.position[p]) * trace(A);
    EXPECT_GT(std::abs(expected), 1.);
    EXPECT_NEAR(before, expected, 1e-10 * std::abs(expected));
    double sum[2] = {0., 0.};
    for (unsigned int i = 0; i < grid.n_dofs(); ++i)
      sum[i % 2] += force.begin()[i];
    EXPECT_NEAR(sum[0], 0., 1e-10);
    EXPECT_NEAR(sum[1], 0., 1e-10);
  }


  TEST(Loads, effective_stress_in_situ_is_that_of_buoyant_soil)
  {
    const auto    parameters = ground({});
    const Case<2> the_case(*parameters, MPI_COMM_SELF);
    const auto   &points = the_case.initial_points;
    const auto   &u      = points.scalar("pore pressure");
    // Linear elements have one stress in a cell, that of its middle.
    std::map<int, std::pair<double, unsigned int>> rows; // of cells
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const double y = points.position[p][1];
        auto &[sum, n] = rows[int(y / 0.25)];
        sum += points.stress[p][1][1];
        ++n;
        ASSERT_NEAR(points.stress[p][0][0],
                    0.3 / 0.7 * points.stress[p][1][1],
                    1e-6);
        EXPECT_NEAR(u[p], std::max(10. * (3. - y), 0.), 1e-12);
      }
    EXPECT_EQ(rows.size(), 16u);
    for (const auto &[row, stress] : rows)
      {
        // 16 kN/m^3 down to the water at 3 m, then 20 - 10.
        const double y = 0.25 * (row + 0.5);
        EXPECT_NEAR(stress.first / stress.second,
                    y > 3. ? -16. * (4. - y) : -16. - (20. - 10.) * (3. - y),
                    1e-6)
          << y;
      }
    // The weight is that of the soil with its water.
    double mass = 0.;
    for (const double m : points.mass)
      mass += m;
    EXPECT_NEAR(mass * parameters->gravity.acceleration,
                3. * (16. + 3. * 20.),
                1e-9);
    // Of total stress, the law has it all.
    const auto    clay = ground({"Materials/sand/Model=von Mises softening",
                                 "Materials/sand/Initial strength=500"});
    const Case<2> undrained(*clay, MPI_COMM_SELF);
    const auto   &all = undrained.initial_points;
    for (std::size_t p = 0; p < all.n_points(); ++p)
      if (all.position[p][1] < 1.)
        {
          ASSERT_NEAR(all.stress[p][1][1],
                      -(16. + 20. * (3. - all.position[p][1])),
                      20. * 0.0625 + 1e-6); // half a point
        }
  }

  TEST(Loads, soil_as_heavy_as_water_under_water_has_no_stress)
  {
    // Water in the ground, on its surface and the weight are in balance, with
    // the standard gradients and with B-bar: what is left is the
    // discretisation's.
    for (const char *const kind : {"standard", "B-bar"})
      {
        const auto parameters = ground(
          {"Materials/sand/Unit weight=10",
           "Materials/sand/Saturated unit weight=10",
           "Pore water/Phreatic line=0, 4.9; 3, 4.9",
           std::string("Kinematics and mapping/Volumetric strain=") + kind,
           "Tractions/Names=lake",
           "Tractions/lake/Kind=hydrostatic",
           "Tractions/lake/Level=4.9"});
        const Case<2> the_case(*parameters, MPI_COMM_SELF);
        const auto   &points  = the_case.initial_points;
        double        largest = 0., pressure = 0.;
        for (std::size_t p = 0; p < points.n_points(); ++p)
          {
            largest  = std::max(largest, points.stress[p].norm());
            pressure = std::max(pressure, points.scalar("pore pressure")[p]);
          }
        EXPECT_GT(pressure, 48.);
        EXPECT_LT(largest, 1e-6) << kind;
      }
  }


  TEST(Loads, pressure_of_the_soil_or_of_its_place)
  {
    MaterialPoints<2> points = Lattice::box(Point<2>(0.3, 0.35), 2, 0.11);
    points.initial_position  = points.position;
    for (Point<2> &x : points.position)
      x[1] += 1.;
    PoreWaterParameters p = line("-9, 3; 9, 3");
    PoreWater<2>(p, 10., {true}).record(points);
    const double place = points.scalar("pore pressure")[0];
    p.pressure_of      = PorePressureOf::soil;
    PoreWater<2>(p, 10., {true}).record(points);
    EXPECT_NEAR(place, 10. * (3. - points.position[0][1]), 1e-12);
    EXPECT_NEAR(points.scalar("pore pressure")[0], place + 10., 1e-12);
  }


  TEST(Loads, what_water_in_the_ground_cannot_do)
  {
    const std::string saturated = "Materials/sand/Saturated unit weight";
    const auto        problem   = [](const std::vector<std::string> &more) {
      try
        {
          ground(more);
        }
      catch (const UserError &error)
        {
          return error.problem;
        }
      return std::string("none");
    };
    EXPECT_EQ(problem({"Kinematics and mapping/Strain=logarithmic"}),
              saturated + ": is 20 kN/m^3, with logarithmic strain");
    EXPECT_EQ(problem({saturated + "=15"}),
              saturated + ": is 15 kN/m^3, the unit weight 16 kN/m^3");
    EXPECT_NO_THROW(
      ground({"Kinematics and mapping/Strain=logarithmic", saturated + "=0"}));
  }


  TEST(Loads, water_in_the_ground_that_is_strange)
  {
    const auto warnings = [](const std::vector<std::string> &more) {
      return Warnings::joined(strange_parameters(*ground(more)));
    };
    using Warnings::has;
    const std::string lake = "Tractions/Names=lake",
                      kind = "Tractions/lake/Kind=hydrostatic";
    EXPECT_EQ(warnings({}), "");
    EXPECT_EQ(warnings({lake, kind, "Tractions/lake/Level=3"}), "");
    EXPECT_TRUE(has(warnings({lake, kind, "Tractions/lake/Level=1"}),
                    "ends at 3 m, but Tractions/lake/Level is 1 m"));
    EXPECT_TRUE(has(warnings({lake, kind, "Tractions/lake/Level=3 + t"}),
                    "the water outside moves"));
    EXPECT_TRUE(has(warnings({"Water/Side=left",
                              "Water/Level=1",
                              "Water/Minimum support=0",
                              "Surface/Method=contour"}),
                    "ends at 3 m, but Water/Level is 1 m"));
    EXPECT_TRUE(has(warnings({"Water/Side=left",
                              "Water/Level=3",
                              "Water/Rise=0.01*t",
                              "Water/Minimum support=0",
                              "Surface/Method=contour"}),
                    "the water outside moves"));
    EXPECT_TRUE(has(warnings({"Pore water/Phreatic line="}),
                    "Saturated unit weight is not used"));
    EXPECT_TRUE(has(
      warnings(
        {"Pore water/Phreatic line=", lake, kind, "Tractions/lake/Level=3"}),
      "a liquid on soil with friction"));
    EXPECT_TRUE(has(warnings({"Materials/sand/Model=von Mises softening",
                              "Materials/sand/Saturated unit weight=0"}),
                    "laws of total stress alone"));
  }

  TEST(Loads, a_phreatic_line_above_the_ground_is_strange)
  {
    const auto warns = [](const std::string &line) {
      const auto parameters = ground(
        {"Pore water/Phreatic line=" + line, "Gravity/Initial stress=false"});
      const Case<2> the_case(*parameters, MPI_COMM_SELF);
      for (const std::string &text : strange_things(the_case))
        if (text.find("above the ground") != std::string::npos)
          return true;
      return false;
    };
    EXPECT_FALSE(warns("0, 4; 3, 4"));
    EXPECT_FALSE(warns("0, 1; 3, 3"));
    EXPECT_TRUE(warns("0, 3; 3, 5"));
  }
} // namespace loads_pore_water
