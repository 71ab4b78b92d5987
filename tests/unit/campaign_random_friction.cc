// SPDX-License-Identifier: LGPL-2.1-or-later
// Random fields of cohesion and friction angle.
#include <waker/base/errors.h>
#include <waker/campaign/realisation_runner.h>

#include "campaign_random_dyke.h"
#include "user_errors.h"
#include "warnings.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace campaign_random_friction
{
  using namespace Waker;
  using namespace RandomDyke;

  namespace
  {
    std::unique_ptr<Input>
    sand(std::vector<std::string> more)
    {
      const std::string clay = "Materials/clay/";
      for (const char *const text : {"Model=Mohr-Coulomb",
                                     "Cohesion=8",
                                     "Friction angle=30",
                                     "Dilatancy angle=10",
                                     "Softening strain=0.5",
                                     "Residual cohesion=2",
                                     "Residual friction angle=24",
                                     "Residual dilatancy angle=0"})
        more.push_back(clay + text);
      more.push_back("Water/Side=none");
      return coarse(more);
    }


    std::pair<double, double>
    range(const std::vector<double> &values)
    {
      const auto [low, high] =
        std::minmax_element(values.begin(), values.end());
      return {*low, *high};
    }
  } // namespace


  TEST(RandomProperties, a_field_of_the_friction_angle)
  {
    const Drawn drawn(*sand({field + "Property=friction angle",
                             field + "Coefficient of variation=0.1"}));
    const auto [low, high] = range(drawn.values("friction angle"));
    EXPECT_LT(low, 30. - 3.); // more than a standard deviation
    EXPECT_GT(high, 30. + 3.);
    const std::size_t n = drawn.state.points.n_points();
    for (std::size_t q = 0; q < n; ++q)
      ASSERT_NEAR(drawn.values("residual friction angle")[q],
                  0.8 * drawn.values("friction angle")[q],
                  1e-12);
    // Nothing else goes along.
    EXPECT_EQ(range(drawn.values("cohesion")), std::make_pair(8., 8.));
    EXPECT_EQ(range(drawn.values("residual cohesion")), std::make_pair(2., 2.));
    EXPECT_EQ(range(drawn.values("dilatancy angle")), std::make_pair(10., 10.));
    // No angle is too large to have a tangent.
    const Drawn wild(*sand({field + "Property=friction angle",
                            field + "Coefficient of variation=2"}));
    EXPECT_EQ(range(wild.values("friction angle")), std::make_pair(0., 89.));
  }


  TEST(RandomProperties, a_field_of_the_cohesion)
  {
    const Drawn drawn(*sand({field + "Property=cohesion"}));
    const auto [low, high] = range(drawn.values("cohesion"));
    EXPECT_LT(low, 8. - 1.6);
    EXPECT_GT(high, 8. + 1.6);
    for (std::size_t q = 0; q < drawn.state.points.n_points(); ++q)
      ASSERT_NEAR(drawn.values("residual cohesion")[q],
                  0.25 * drawn.values("cohesion")[q],
                  1e-12);
    EXPECT_EQ(range(drawn.values("friction angle")), std::make_pair(30., 30.));
  }


  TEST(RandomProperties, a_mean_that_the_law_cannot_start_with)
  {
    const std::string mean = "Random fields/strength/Mean";
    // The dilatancy angle may come up to the friction angle, no further.
    const std::string psi = field + "Property=dilatancy angle";
    EXPECT_NO_THROW(Drawn(*sand({psi, mean + "=30"})));
    EXPECT_USER_ERROR(Drawn(*sand({psi, mean + "=31"})),
                      mean,
                      "dilatancy angle 31 degrees at (");
    EXPECT_USER_ERROR(Drawn(*sand({psi, mean + "=25 + 0.5*x"})),
                      mean,
                      "dilatancy angle");
    // Nor may the friction angle come down to less than it.
    EXPECT_NO_THROW(
      Drawn(*sand({field + "Property=friction angle", mean + "=10"})));
    EXPECT_USER_ERROR(Drawn(*sand(
                        {field + "Property=friction angle", mean + "=9"})),
                      mean,
                      "dilatancy angle 10 degrees at (");
    // What is left after softening.
    EXPECT_USER_ERROR(Drawn(*sand(
                        {field + "Property=residual cohesion", mean + "=8.5"})),
                      mean,
                      "residual cohesion 8.5 kPa");
    EXPECT_USER_ERROR(Drawn(*sand({field + "Property=residual dilatancy angle",
                                   mean + "=25"})),
                      mean,
                      "residual dilatancy angle 25 degrees");
    EXPECT_USER_ERROR(Drawn(*coarse(
                        {field + "Property=residual strength", mean + "=14"})),
                      mean,
                      "14 kPa");
  }


  TEST(RandomProperties, angles_that_the_law_cuts_off_are_counted)
  {
    const Drawn                drawn(*sand({field + "Property=dilatancy angle",
                                            field + "Mean=28",
                                            field + "Coefficient of variation=0.1"}));
    const std::vector<double> &psi = drawn.values("dilatancy angle");
    const std::size_t          n =
      std::count_if(psi.begin(), psi.end(), [](const double angle) {
        return angle > 30.;
      });
    ASSERT_GT(n, 0u);
    EXPECT_EQ(drawn.properties.n_beyond_law(drawn.state), n);
    const auto lines = drawn.properties.cut_off(drawn.state);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].find("Random fields: at " + std::to_string(n) + " of " +
                            std::to_string(psi.size()) +
                            " points of the material \"clay\" the dilatancy "
                            "angle counts as"),
              0u)
      << lines[0];
    // The control: far below the friction angle none is.
    const Drawn low(*sand({field + "Property=dilatancy angle",
                           field + "Mean=10",
                           field + "Coefficient of variation=0.1"}));
    EXPECT_TRUE(low.properties.cut_off(low.state).empty());
    EXPECT_EQ(low.properties.n_beyond_law(low.state), std::uint64_t(0));
  }


  TEST(RandomProperties, a_campaign_records_what_is_beyond_a_law)
  {
    const auto           input = sand({field + "Property=dilatancy angle",
                                       field + "Mean=28",
                                       field + "Coefficient of variation=0.1",
                                       "Time stepping/End time=0.02",
                                       "Time stepping/Time step=0.01"});
    RealisationRunner<2> runner(input->simulation,
                                input->reliability.fields,
                                1,
                                MPI_COMM_SELF);
    const auto           record = runner.run(1, 0, {});
    const Drawn          drawn(*input);
    ASSERT_TRUE(record && record->points_beyond_law);
    EXPECT_GT(*record->points_beyond_law, 0u);
    EXPECT_EQ(record->points_beyond_law,
              drawn.properties.n_beyond_law(drawn.state));
  }


  TEST(RandomProperties, a_strength_of_nothing_is_counted)
  {
    // A friction angle that is drawn as 0 where there is no cohesion.
    const std::string          clay = "Materials/clay/";
    const Drawn                drawn(*coarse({clay + "Model=Mohr-Coulomb",
                                              clay + "Cohesion=0",
                                              clay + "Friction angle=10",
                                              "Water/Side=none",
                                              field + "Property=friction angle",
                                              field + "Coefficient of variation=1"}));
    const std::vector<double> &phi = drawn.values("friction angle");
    const std::size_t          n   = std::count(phi.begin(), phi.end(), 0.);
    ASSERT_GT(n, 0u);
    EXPECT_EQ(drawn.properties.n_beyond_law(drawn.state), n);
    const auto lines = drawn.properties.cut_off(drawn.state);
    ASSERT_EQ(lines.size(), 2u); // one of the limit of the field
    EXPECT_TRUE(Warnings::has(lines[1],
                              "the cohesion is none that its law would start "
                              "with: at the first of them it is 0"))
      << lines[1];
  }


  TEST(RandomProperties, a_spread_that_no_soil_has_is_told)
  {
    const auto told = [](const std::string &variation) {
      const Drawn drawn(
        *sand({field + "Property=cohesion",
               field + "Distribution=lognormal",
               field + "Coefficient of variation=" + variation}));
      return Warnings::has(Warnings::joined(drawn.properties.warnings()),
                           "a coefficient of variation of " + variation +
                             "; soils have 0.02 to 1");
    };
    EXPECT_TRUE(told("5"));
    EXPECT_FALSE(told("0.9"));
  }


  TEST(RandomProperties, a_field_of_what_the_law_has_not)
  {
    EXPECT_USER_ERROR(Drawn(*sand({})),
                      "Random fields/strength/Property",
                      "undrained shear strength");
    EXPECT_USER_ERROR(Drawn(*coarse({field + "Property=cohesion"})),
                      "Random fields/strength/Property",
                      "cohesion");
  }
} // namespace campaign_random_friction
