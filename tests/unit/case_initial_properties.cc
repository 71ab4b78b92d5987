// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/campaign/realisation_setup.h>
#include <waker/materials/von_mises_softening.h>
#include <waker/mechanics/stress_update.h>
#include <waker/simulation/strengths.h>

#include "campaign_random_dyke.h"
#include "user_errors.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace case_initial_properties
{
  // Strengths that vary in space without being random.

  namespace
  {
    using namespace Waker;
    using namespace RandomDyke;

    const std::string initial  = "Materials/clay/Initial strength=";
    const std::string residual = "Materials/clay/Residual strength=";

    /// Height (m) of the dyke of chapter 5 at x.
    double
    top(const double x)
    {
      return std::min({x, 5., (30. - x) / 3.});
    }


    struct Dyke
    {
      explicit Dyke(std::vector<std::string> overrides)
      {
        input    = coarse(std::move(overrides));
        the_case = std::make_unique<Case<2>>(input->simulation, MPI_COMM_SELF);
        state    = initial_state(*the_case);
      }

      std::vector<double> &
      values(const std::string &name)
      {
        return state.points.scalar(name);
      }

      std::unique_ptr<Input>   input;
      std::unique_ptr<Case<2>> the_case;
      State<2>                 state;
    };


    std::string
    refusal(const std::vector<std::string> &overrides)
    {
      try
        {
          const Dyke dyke(overrides);
        }
      catch (const UserError &error)
        {
          return error.where + ": " + error.problem + "; " + error.allowed;
        }
      return "nothing";
    }


    TEST(InitialProperties, strength_grows_with_the_depth_below_the_surface)
    {
      // s_u = s_u,top + k depth, and a sensitivity.
      Dyke dyke({initial + "6 + 1.5*depth", residual + "initial_strength/2.6"});
      const MaterialPoints<2> &points = dyke.state.points;
      double                   least = 1e9, largest = 0.;
      for (std::size_t q = 0; q < points.n_points(); ++q)
        {
          const Point<2> &x = points.initial_position[q];
          const double    c = dyke.values("undrained shear strength")[q];
          ASSERT_NEAR(c, 6. + 1.5 * (top(x[0]) - x[1]), 1e-12) << x;
          ASSERT_NEAR(dyke.values("residual strength")[q], c / 2.6, 1e-12);
          least   = std::min(least, c);
          largest = std::max(largest, c);
        }
      EXPECT_LT(least, 6.3);
      EXPECT_GT(largest, 13.);
    }


    TEST(InitialProperties, depths_count_from_the_layer_or_from_the_surface)
    {
      // The dyke cut at y = 2.5 m (its middle); the clay below is another one.
      const std::vector<std::string> layers = {
        "Soil profile/Layers=dyke, lower",
        "Soil profile/dyke/Polygon=2.5,2.5; 22.5,2.5; 15,5; 5,5",
        "Soil profile/lower/Material=old",
        "Soil profile/lower/Polygon=0,0; 30,0; 22.5,2.5; 2.5,2.5",
        "Materials/Names=clay, old",
        "Materials/old/Initial strength=8 + x/100 + depth_in_layer + 0.1*depth",
        "Random fields/strength/Material=clay",
        initial + "7 + 2*depth_in_layer"};
      Dyke                     dyke(layers);
      const MaterialPoints<2> &points = dyke.state.points;
      for (std::size_t q = 0; q < points.n_points(); ++q)
        {
          const Point<2> &x        = points.initial_position[q];
          const double    expected = points.material[q] == 0
                                       ? 7. + 2. * (top(x[0]) - x[1])
                                       : 8. + x[0] / 100. +
                                        (std::min(2.5, top(x[0])) - x[1]) +
                                        0.1 * (top(x[0]) - x[1]);
          ASSERT_NEAR(dyke.values("undrained shear strength")[q],
                      expected,
                      1e-12)
            << x;
        }
    }


    TEST(InitialProperties,
         a_mean_may_have_depths_and_is_the_materials_otherwise)
    {
      // The trend in the material, in the field's mean, and in both commands.
      const std::string trend = "6 + 1.5*depth";
      Dyke own({initial + trend, residual + "initial_strength/2.6"});
      Dyke mean({field + "Mean=" + trend});
      means_setup<2> (*mean.input)(*mean.the_case, mean.state);
      Dyke own_mean({initial + trend, residual + "initial_strength/2.6"});
      means_setup<2> (*own_mean.input)(*own_mean.the_case, own_mean.state);
      for (const char *const name :
           {"undrained shear strength", "residual strength"})
        {
          const auto &a = own.values(name), &b = mean.values(name),
                     &c = own_mean.values(name);
          for (std::size_t q = 0; q < a.size(); ++q)
            {
              // Without trend: c_r of the material, 5 kPa to 13 kPa.
              ASSERT_NEAR(a[q], b[q], 1e-12);
              ASSERT_NEAR(a[q], c[q], 1e-12);
            }
        }
      // A realisation: the same scores, whatever the way in which it is said.
      const Drawn plain(*coarse({}));
      const Drawn by_mean(*coarse({field + "Mean=" + trend}));
      const Drawn by_material(
        *coarse({initial + trend, residual + "initial_strength/2.6"}));
      const Drawn by_both(
        *coarse({field + "Mean=" + trend,
                 field + "Standard deviation=0.5 + 0.1*depth"}));
      for (std::size_t q = 0; q < plain.strength().size(); ++q)
        {
          const Point<2> &x     = plain.state.points.initial_position[q];
          const double    depth = top(x[0]) - x[1];
          const double    z     = (plain.strength()[q] - 13.) / 2.6;
          const double    m     = 6. + 1.5 * depth;
          ASSERT_NEAR(by_mean.strength()[q], m * (1. + 0.2 * z), 1e-9);
          ASSERT_NEAR(by_material.strength()[q], m * (1. + 0.2 * z), 1e-9);
          ASSERT_NEAR(by_both.strength()[q], m + (0.5 + 0.1 * depth) * z, 1e-9);
          ASSERT_NEAR(by_material.values("residual strength")[q],
                      by_material.strength()[q] / 2.6,
                      1e-12);
        }
    }


    TEST(InitialProperties, what_is_no_strength_is_refused_with_place_and_value)
    {
      const auto expect = [](const std::vector<std::string> &overrides,
                             const std::vector<std::string> &parts) {
        const std::string text = refusal(overrides);
        for (const std::string &part : parts)
          EXPECT_NE(text.find(part), std::string::npos)
            << part << " in " << text;
      };
      expect({initial + "10 - 4*depth", residual + "0"},
             {"Materials/clay/Initial strength: \"10 - 4*depth\" is ",
              " at the point (",
              "above 0"});
      expect({initial + "10 + sqrt(depth - 1)"}, {"is ", "nan", "finite"});
      expect({initial + "1/(y - y)"}, {"is ", "inf", "finite"});
      // The residual strength of 5 kPa is more than what is left up there.
      expect({initial + "4 + 2*depth"},
             {"Materials/clay/Residual strength: is 5 at the point (",
              "from 0 to the initial strength at every point, here 4."});
      expect({residual + "10 + depth"},
             {"Materials/clay/Residual strength: \"10 + depth\" is ",
              "here 13 kPa"});
      for (const char *const unreadable : {"5 + z", "depht", "13*t"})
        expect({initial + unreadable},
               {"Materials/clay/Initial strength: ", "depth_in_layer"});
      // Also of a material that does not look at it.
      expect({"Materials/clay/Model=linear elastic", initial + "nonsense"},
             {"Materials/clay/Initial strength", "nonsense"});
      EXPECT_USER_ERROR(Drawn(*coarse({field + "Mean=13 + depth_of_layer"})),
                        field + "Mean",
                        "\"depth_of_layer\" is unknown");
      EXPECT_USER_ERROR(Drawn(*coarse({field + "Mean=depth - 1"})),
                        field + "Mean",
                        "is -0.");
      EXPECT_USER_ERROR(Drawn(
                          *coarse({field + "Standard deviation=depth - 1"})),
                        field + "Standard deviation",
                        "is -0.");
      EXPECT_USER_ERROR(Drawn(*coarse({field + "Standard deviation=-1"})),
                        field + "Standard deviation",
                        "is -1");
    }


    TEST(Strengths, of_each_of_two_clays_are_divided_once)
    {
      Materials clays;
      for (const double c : {13., 20.})
        clays.push_back(
          std::make_unique<VonMisesSoftening>(1.5, 1000., 0.45, c, 5., -50.));
      MaterialPoints<2> points;
      points.resize(2);
      points.material = {0, 1};
      declare_material_variables(clays, points);
      divide_strengths(clays, 1.6, points);
      EXPECT_EQ(points.scalar("undrained shear strength"),
                (std::vector<double>{13. / 1.6, 20. / 1.6}));
      EXPECT_EQ(points.scalar("residual strength"),
                (std::vector<double>{5. / 1.6, 5. / 1.6}));
    }


    TEST(Strengths, all_strengths_of_all_materials_are_divided_and_nothing_else)
    {
      Dyke                    dyke({"Soil profile/Layers=dyke, lower",
                                    "Soil profile/dyke/Polygon=2.5,2.5; 22.5,2.5; 15,5; 5,5",
                                    "Soil profile/lower/Material=rock",
                                    "Soil profile/lower/Polygon=0,0; 30,0; 22.5,2.5; 2.5,2.5",
                                    "Materials/Names=clay, rock",
                                    "Materials/rock/Model=linear elastic",
                                    "Random fields/strength/Material=clay",
                                    initial + "6 + depth",
                                    residual + "initial_strength/2"});
      const MaterialPoints<2> before = dyke.state.points;
      divide_strengths(dyke.the_case->materials, 1.6, dyke.state.points);
      std::size_t n_reduced = 0;
      for (std::size_t q = 0; q < before.n_points(); ++q)
        for (std::size_t s = 0; s < before.scalars.size(); ++s)
          {
            const bool is_strength =
              before.material[q] == 0 &&
              before.scalars[s].name.find("strength") != std::string::npos;
            const double was = before.scalars[s].values[q];
            ASSERT_EQ(dyke.state.points.scalars[s].values[q],
                      is_strength ? was / 1.6 : was)
              << before.scalars[s].name;
            n_reduced += is_strength && was > 0.;
          }
      EXPECT_GT(n_reduced, 1000u);

      const auto lines =
        described_strengths(dyke.the_case->materials,
                            dyke.the_case->parameters.materials);
      ASSERT_EQ(lines.size(), 2u);
      EXPECT_NE(lines[0].find("undrained shear strength, residual strength"),
                std::string::npos);
      EXPECT_NE(lines[1].find("rock: nothing"), std::string::npos);
      std::vector<WallParameters> walls(3);
      walls[0].name     = "slope";
      walls[0].type     = WallType::frictional;
      walls[0].adhesion = 2.;
      walls[1].type     = WallType::frictional; // smooth
      walls[2].adhesion = 2.;                   // not used
      ASSERT_EQ(kept_walls(walls).size(), 1u);
      EXPECT_NE(kept_walls(walls)[0].find("Walls/slope: nothing"),
                std::string::npos);
      Materials rock;
      rock.push_back(std::make_unique<LinearElastic>(2., 1e4, 0.3));
      EXPECT_USER_ERROR(
        described_strengths(rock, {dyke.the_case->parameters.materials[1]}),
        "Materials/Names",
        "no material has a strength to reduce");
    }
  } // namespace
} // namespace case_initial_properties
