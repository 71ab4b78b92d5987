// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/random_numbers.h>
#include <waker/program/parameter_reader.h>
#include <waker/reliability/input.h>
#include <waker/reliability/realisation_runner.h>

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>

namespace
{
  using namespace Waker;

  const std::string base_case =
    WAKER_SOURCE_DIRECTORY "/parameters/chapter5/analysis1.prm";
  const std::string field = "Random fields/strength/";

  /// Coarse: four points per metre.
  std::unique_ptr<Input>
  coarse(std::vector<std::string> overrides)
  {
    overrides.push_back("Grid/Cell size=0.5");
    return std::move(read_scenarios(base_case, overrides)[0]);
  }


  struct Drawn
  {
    Drawn(const Input &input, const std::uint64_t realisation = 0)
      : the_case(input.simulation, MPI_COMM_SELF)
      , properties(the_case, input.reliability.fields)
      , state(initial_state(the_case))
    {
      std::vector<double> noise(properties.n_noise());
      white_noise({1, realisation, 0}, 0, noise.size(), noise.data());
      properties.apply(noise.data(), state);
    }

    const std::vector<double> &
    values(const std::string &name) const
    {
      return state.points.scalars[state.points.find_scalar(name)].values;
    }

    const std::vector<double> &
    strength() const
    {
      return values("undrained shear strength");
    }

    Case<2>             the_case;
    RandomProperties<2> properties;
    State<2>            state;
  };


  TEST(RandomProperties, residual_strength_goes_along_with_the_strength)
  {
    const Drawn drawn(*coarse({}));
    double      least = 1e9, largest = 0.;
    for (std::size_t q = 0; q < drawn.strength().size(); ++q)
      {
        const double c = drawn.strength()[q];
        ASSERT_NEAR(drawn.values("residual strength")[q], c * 5. / 13., 1e-12);
        least   = std::min(least, c);
        largest = std::max(largest, c);
      }
    EXPECT_LT(least, 13. - 2.6); // more than the standard deviation
    EXPECT_GT(largest, 13. + 2.6);
    const auto [mean, smallest] = drawn.properties.mean_and_least(drawn.state);
    EXPECT_EQ(smallest, least);
    EXPECT_NEAR(mean, 13., 2.);
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
        const double z    = (plain.strength()[q] - 13.) / 2.6;
        const double mean = 6. + 2. * (5. - plain.state.points.position[q][1]);
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
            const double y = (drawn.values("residual strength")[q] - 5.) / 0.5;
            xy += x * y / n;
            xx += x * x / n;
            yy += y * y / n;
          }
        // 1,600 points, four and more to a scale of fluctuation: an error of
        // 0.1 is three standard deviations.
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
    const auto contains = [](const std::string &text, const std::string &part) {
      return text.find(part) != std::string::npos;
    };
    EXPECT_TRUE(contains(where({field + "Material=sand"}), "sand"));
    EXPECT_TRUE(contains(where({field + "Scales of fluctuation=24"}),
                         "Scales of fluctuation"));
    EXPECT_TRUE(
      contains(where({field + "Scales of fluctuation=0, 1"}), "contains 0"));
    EXPECT_TRUE(contains(where({field + "Mean=1 - y"}), "at ("));
    EXPECT_TRUE(contains(where({field + "Distribution=beta"}), "Maximum"));
    EXPECT_TRUE(contains(where({"Random fields/Correlations=strength: 1"}),
                         "Correlations"));
    EXPECT_TRUE(
      contains(where({"Random fields/Correlations=strength, x: 1"}), "\"x\""));
    EXPECT_TRUE(
      contains(where({field + "Measurements=/nowhere.csv"}), "/nowhere.csv"));
    EXPECT_TRUE(
      contains(where({"Sweep/Parameter=Water/Levels", "Sweep/Values=1; 2"}),
               "Water/Levels"));
    EXPECT_TRUE(
      contains(where({"Sweep/Parameter=Campaign/Seed", "Sweep/Values=1; 2"}),
               "Campaign/Seed"));
    EXPECT_TRUE(contains(where({"Sweep/Parameter=Water/Level"}), "is empty"));
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


  TEST(RealisationRunner, tries_again_with_half_the_step_then_records_a_failure)
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


  TEST(MovedSoil, is_counted_by_direction_with_its_mean_way)
  {
    MaterialPoints<2> points;
    points.id               = {0, 1, 2, 3};
    points.volume           = {1., 3., 2., 5.};
    points.initial_position = {{0., 0.}, {0., 0.}, {0., 0.}, {0., 0.}};
    points.position         = {{0.6, -1.}, {1., 0.}, {-2., -0.5}, {0.4, -3.}};
    const MovedSoil right   = moved_soil(points, true);
    EXPECT_DOUBLE_EQ(right.area, 4.);
    EXPECT_DOUBLE_EQ(right.dx, 0.9);
    EXPECT_DOUBLE_EQ(right.dy, -0.25);
    const MovedSoil left = moved_soil(points, false);
    EXPECT_DOUBLE_EQ(left.area, 2.);
    EXPECT_DOUBLE_EQ(left.dx, -2.);
    EXPECT_DOUBLE_EQ(left.dy, -0.5);
  }
} // namespace
