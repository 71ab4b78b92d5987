// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/random_numbers.h>
#include <waker/campaign/realisation_runner.h>

#include "campaign_random_dyke.h"
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace campaign_random_properties
{
  namespace
  {
    using namespace Waker;
    using namespace RandomDyke;


    TEST(RandomProperties, residual_strength_goes_along_with_the_strength)
    {
      const Drawn drawn(*coarse({}));
      double      least = 1e9, largest = 0.;
      for (std::size_t q = 0; q < drawn.strength().size(); ++q)
        {
          const double c = drawn.strength()[q];
          ASSERT_NEAR(drawn.values("residual strength")[q],
                      c * 5. / 13.,
                      1e-12);
          least   = std::min(least, c);
          largest = std::max(largest, c);
        }
      EXPECT_LT(least, 13. - 2.6); // more than the standard deviation
      EXPECT_GT(largest, 13. + 2.6);
      const auto [mean, smallest] =
        drawn.properties.mean_and_least(drawn.state);
      EXPECT_EQ(smallest, least);
      // By mass: points at the slopes are smaller than those inside.
      const MaterialPoints<2> &points = drawn.state.points;
      double                   sum = 0., plain = 0., mass = 0.;
      for (std::size_t q = 0; q < points.n_points(); ++q)
        {
          sum += points.mass[q] * drawn.strength()[q];
          plain += drawn.strength()[q] / points.n_points();
          mass += points.mass[q];
        }
      EXPECT_NEAR(mean, sum / mass, 1e-12);
      EXPECT_GT(std::abs(mean - plain), 1e-6);
    }


    TEST(RandomProperties, one_field_cell_per_support_domain)
    {
      // Points of one sub-cell row that are far apart vary; equal cells agree
      // with a field of larger cells.
      const Drawn  fine(*coarse({}));
      const Drawn  wide(*coarse({field + "Cell size=1, 1"}));
      unsigned int equal = 0;
      for (std::size_t q = 0; q + 1 < fine.strength().size(); ++q)
        {
          EXPECT_NE(fine.strength()[q], fine.strength()[q + 1]);
          equal += wide.strength()[q] == wide.strength()[q + 1];
        }
      EXPECT_GT(equal, fine.strength().size() / 2);
    }


    TEST(RandomProperties, mean_may_depend_on_depth_with_either_spread)
    {
      const Drawn cov(*coarse({field + "Mean=6 + 2*(5 - y)"}));
      const Drawn sigma(*coarse(
        {field + "Mean=6 + 2*(5 - y)", field + "Standard deviation=1.5"}));
      const Drawn plain(*coarse({}));
      for (std::size_t q = 0; q < plain.strength().size(); ++q)
        {
          const double z = (plain.strength()[q] - 13.) / 2.6;
          const double mean =
            6. + 2. * (5. - plain.state.points.position[q][1]);
          ASSERT_NEAR(cov.strength()[q], mean + 0.2 * mean * z, 1e-9);
          ASSERT_NEAR(sigma.strength()[q], mean + 1.5 * z, 1e-9);
        }
    }


    TEST(RandomProperties, statistics_of_points_vary_less_in_the_cells)
    {
      const Drawn       cells(*coarse({}));
      const Drawn       points(*coarse({field + "Statistics of=points"}));
      const Correlation correlation(Correlation::Function::markov, {24., 0.5});
      const double      gamma =
        correlation.between_cells({{0.25, 0.25, 1.}}, {{0, 0, 0}});
      EXPECT_LT(gamma, 0.75);
      for (std::size_t q = 0; q < cells.strength().size(); ++q)
        ASSERT_NEAR(points.strength()[q] - 13.,
                    std::sqrt(gamma) * (cells.strength()[q] - 13.),
                    1e-9);
    }


    TEST(RandomProperties, lognormal_statistics_of_points_keep_the_mean)
    {
      // The same scores, wider and narrower: ln c = mu + s z, where the mean of
      // c is 13 kPa for the variance of z, 1 or gamma.
      const std::string lognormal = field + "Distribution=lognormal";
      const std::string spread    = field + "Coefficient of variation=1";
      const Drawn       cells(*coarse({lognormal, spread}));
      const Drawn       points(
        *coarse({lognormal, spread, field + "Statistics of=points"}));
      const Correlation correlation(Correlation::Function::markov, {24., 0.5});
      const double      gamma =
        correlation.between_cells({{0.25, 0.25, 1.}}, {{0, 0, 0}});
      const double s = std::sqrt(std::log(2.));
      for (std::size_t q = 0; q < cells.strength().size(); ++q)
        {
          const double z =
            (std::log(cells.strength()[q] / 13.) + 0.5 * s * s) / s;
          ASSERT_NEAR(std::log(points.strength()[q] / 13.),
                      -0.5 * s * s * gamma + s * std::sqrt(gamma) * z,
                      1e-9);
        }
    }


    TEST(RandomProperties, two_fields_are_correlated_as_asked)
    {
      for (const double rho : {1., 0.6, -0.5})
        {
          const std::string residual = "Random fields/residual/";
          const Drawn       drawn(
            *coarse({"Random fields/Names=strength, residual",
                           residual + "Property=residual strength",
                           residual + "Coefficient of variation=0.1",
                           residual + "Scales of fluctuation=0.5, 0.5",
                           field + "Scales of fluctuation=0.5, 0.5",
                           "Random fields/Correlations=strength, residual: " +
                             std::to_string(rho)}));
          double       xy = 0., xx = 0., yy = 0.;
          const double n = drawn.strength().size();
          for (std::size_t q = 0; q < n; ++q)
            {
              const double x = (drawn.strength()[q] - 13.) / 2.6;
              const double y =
                (drawn.values("residual strength")[q] - 5.) / 0.5;
              xy += x * y / n;
              xx += x * x / n;
              yy += y * y / n;
            }
          // The integral of rho^2 of cells is A = 0.23 m^2, the dyke has 100:
          // standard deviations of sqrt(2 A / 100) = 0.07 of the variances and
          // (1 - rho^2) sqrt(A / 100) = 0.03, 0.036 of the correlation. Below
          // 1e-3 each to fail with another seed.
          EXPECT_NEAR(xx, 1., 0.25);
          EXPECT_NEAR(yy, 1., 0.25);
          EXPECT_NEAR(xy / std::sqrt(xx * yy), rho, rho == 1. ? 1e-9 : 0.12);
        }
    }


    TEST(RandomProperties, wrong_input_is_refused_with_its_path)
    {
      const auto where = [](const std::vector<std::string> &overrides) {
        try
          {
            const Drawn drawn(*coarse(overrides));
          }
        catch (const UserError &error)
          {
            return error.where + ": " + error.problem;
          }
        return std::string("nothing");
      };
      const auto contains = [](const std::string &text,
                               const std::string &part) {
        return text.find(part) != std::string::npos;
      };
      EXPECT_TRUE(contains(where({field + "Material=sand"}), "sand"));
      EXPECT_TRUE(contains(where({field + "Scales of fluctuation=24"}),
                           "Scales of fluctuation"));
      EXPECT_TRUE(
        contains(where({field + "Scales of fluctuation=0, 1"}), "contains 0"));
      EXPECT_TRUE(contains(where({field + "Mean=1 - y"}), "at ("));
      EXPECT_TRUE(contains(where({field + "Distribution=beta"}), "Maximum"));
      for (const std::string distribution : {"truncated normal", "beta"})
        EXPECT_TRUE(contains(where({field + "Distribution=" + distribution,
                                    field + "Maximum=40",
                                    field + "Statistics of=points"}),
                             field + "Statistics of"));
      EXPECT_TRUE(contains(where({"Random fields/Correlations=strength: 1"}),
                           "Correlations"));
      EXPECT_TRUE(contains(where({"Random fields/Correlations=strength, x: 1"}),
                           "\"x\""));
      EXPECT_TRUE(
        contains(where({field + "Measurements=/nowhere.csv"}), "/nowhere.csv"));
      EXPECT_TRUE(
        contains(where({"Sweep/Parameter=Water/Levels", "Sweep/Values=1; 2"}),
                 "Water/Levels"));
      EXPECT_TRUE(
        contains(where({"Sweep/Parameter=Campaign/Seed", "Sweep/Values=1; 2"}),
                 "\"Campaign/Seed\", which cannot be swept"));
      for (const std::string path : {"Dimension",
                                     "Output/Directory",
                                     "Campaign/Realisations",
                                     "Sweep/Values"})
        EXPECT_TRUE(
          contains(where({"Sweep/Parameter=" + path, "Sweep/Values=3; 2"}),
                   "Sweep/Parameter: is \"" + path +
                     "\", which cannot be swept"))
          << path;
      EXPECT_TRUE(
        contains(where({"Sweep/Parameter=Water/Level", "Sweep/Values=4; 4.5;"}),
                 "Sweep/Values: \"4; 4.5;\" has an empty value"));

      // At the sweep, not where the parameter itself stands.
      EXPECT_TRUE(
        contains(where({"Sweep/Parameter=Water/Level", "Sweep/Values=4; none"}),
                 "--set Sweep/Values: "));
      EXPECT_TRUE(contains(where({"Sweep/Parameter=Water/Level"}), "is empty"));
    }


    TEST(RandomProperties, two_fields_of_one_property_are_refused)
    {
      // One names the only material, the other does not.
      const std::string again = "Random fields/again/";
      try
        {
          const auto        plain    = coarse({});
          const std::string material = plain->simulation.materials[0].name;
          const Drawn drawn(*coarse({"Random fields/Names=strength, again",
                                     field + "Material=",
                                     again + "Material=" + material}));
          FAIL();
        }
      catch (const UserError &error)
        {
          EXPECT_EQ(error.where, again + "Property");
          EXPECT_NE(error.problem.find("\"strength\""), std::string::npos);
        }
    }


    TEST(RandomProperties, values_that_are_not_finite_are_refused)
    {
      const auto                input = coarse({});
      const Case<2>             the_case(input->simulation, MPI_COMM_SELF);
      const RandomProperties<2> properties(the_case, input->reliability.fields);
      State<2>                  state = initial_state(the_case);
      for (const double bad : {std::nan(""), HUGE_VAL})
        {
          std::vector<double> noise =
            realisation_noise(1, 0, properties.n_noise());
          noise[0] = bad;
          try
            {
              properties.apply(noise.data(), state);
              ADD_FAILURE() << bad;
            }
          catch (const NumericalFailure &failure)
            {
              EXPECT_EQ(
                std::string(failure.what()).rfind(field.substr(0, 22), 0), 0u)
                << failure.what();
            }
        }
    }


    TEST(RandomProperties, description_has_the_cells_per_scale_of_fluctuation)
    {
      const auto lines = [](const std::string &scales) {
        const Drawn drawn(*coarse({field + "Scales of fluctuation=" + scales}));
        return drawn.properties.description();
      };
      const auto enough = lines("24, 1");
      ASSERT_EQ(enough.size(), 1u);
      EXPECT_NE(enough[0].find(", 96 x 4 cells per scale of fluctuation"),
                std::string::npos)
        << enough[0];
      const auto few = lines("24, 0.9");
      ASSERT_EQ(few.size(), 1u);
      EXPECT_NE(few[0].find(", 96 x 3.6 cells"), std::string::npos) << few[0];
    }


    TEST(RandomProperties, warn_of_coarse_cells_and_of_limits_that_cut_much_off)
    {
      const auto warnings = [](const std::vector<std::string> &settings) {
        return Drawn(*coarse(settings)).properties.warnings();
      };
      EXPECT_TRUE(warnings({field + "Scales of fluctuation=24, 1"}).empty());
      const auto few = warnings({field + "Scales of fluctuation=24, 0.9"});
      ASSERT_EQ(few.size(), 1u);
      EXPECT_NE(few[0].find("fewer than 4 cells per scale of fluctuation along "
                            "y:"),
                std::string::npos)
        << few[0];
      // A hundredth of a normal distribution is 2.33 deviations from the mean.
      EXPECT_TRUE(warnings({field + "Scales of fluctuation=24, 1",
                            field + "Coefficient of variation=0.42"})
                    .empty());
      const auto cut = warnings({field + "Scales of fluctuation=24, 1",
                                 field + "Coefficient of variation=0.5"});
      ASSERT_EQ(cut.size(), 1u);
      EXPECT_EQ(cut[0].find("Random fields/strength, of \"clay\": with mean"),
                0u)
        << cut[0];
      EXPECT_NE(cut[0].find("the limits cut off 2.27501 %"), std::string::npos)
        << cut[0];
    }


    TEST(RandomProperties, a_mean_beyond_the_limits_is_refused)
    {
      for (const char *const limit : {"Minimum=13.5", "Maximum=12.5"})
        for (const char *const distribution : {"normal", "lognormal"})
          try
            {
              const Drawn drawn(
                *coarse({field + "Mean=13",
                         field + limit,
                         field + "Distribution=" + distribution}));
              ADD_FAILURE() << limit << ", " << distribution;
            }
          catch (const UserError &error)
            {
              EXPECT_EQ(error.where, "Random fields/strength/Mean");
              EXPECT_NE(error.problem.find("is 13"), std::string::npos)
                << error.problem;
            }
    }


    TEST(RandomProperties, noise_of_a_realisation_is_its_stream_0)
    {
      std::vector<double> expected(7);
      white_noise({3, 11, 0}, 0, expected.size(), expected.data());
      EXPECT_EQ(realisation_noise(3, 11, 7), expected);
    }


    TEST(RealisationRunner, is_a_pure_function_of_the_noise)
    {
      const auto           input = coarse({"Time stepping/End time=1.5"});
      RealisationRunner<2> runner(input->simulation,
                                  input->reliability.fields,
                                  1,
                                  MPI_COMM_SELF);
      RealisationRunner<2> another(input->simulation,
                                   input->reliability.fields,
                                   1,
                                   MPI_COMM_SELF);
      const auto           first  = runner.run(1, 7, nullptr);
      const auto           second = runner.run(1, 8, nullptr);
      const auto           again  = runner.run(1, 7, nullptr);
      const auto           third  = another.run(1, 7, nullptr);
      ASSERT_TRUE(first && second && again && third);
      EXPECT_EQ(fingerprint(*first), fingerprint(*again));
      EXPECT_EQ(fingerprint(*first), fingerprint(*third));
      EXPECT_NE(first->mean_strength, second->mean_strength);
      EXPECT_NE(runner.run(2, 7, nullptr)->mean_strength, first->mean_strength);
    }


    TEST(RealisationRunner, stops_when_asked_to)
    {
      const auto                       input  = coarse({});
      const volatile std::sig_atomic_t signal = 15;
      RealisationRunner<2>             runner(input->simulation,
                                  input->reliability.fields,
                                  1,
                                  MPI_COMM_SELF);
      EXPECT_FALSE(runner.run(1, 0, &signal).has_value());
    }


    TEST(RealisationRunner,
         tries_again_with_half_the_step_then_records_a_failure)
    {
      // No step converges to this tolerance.
      const auto           input = coarse({"Newton/Tolerance=1e-15",
                                           "Newton/Maximum iterations=1",
                                           "Time stepping/Maximum halvings=1"});
      RealisationRunner<2> runner(input->simulation,
                                  input->reliability.fields,
                                  3,
                                  MPI_COMM_SELF);
      const auto           record = runner.run(1, 0, nullptr);
      ASSERT_TRUE(record);
      EXPECT_EQ(record->outcome, Outcome::numerical_failure);
      EXPECT_EQ(record->attempts, 3u);
      // The third attempt begins with a quarter of the step and halves it once.
      EXPECT_NE(record->stop_reason.find("dt = 0.00125"), std::string::npos)
        << record->stop_reason;
    }
  } // namespace
} // namespace campaign_random_properties
