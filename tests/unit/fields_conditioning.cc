// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/random_numbers.h>
#include <waker/fields/cholesky_field.h>
#include <waker/fields/conditioning.h>
#include <waker/fields/local_average_subdivision.h>

#include "linear_map.h"
#include "verification_data.h"
#include <Eigen/Dense>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace fields_conditioning
{
  using namespace Waker;

  namespace
  {
    /// A field of `generator`, scaled, then conditioned, as a linear map of
    /// both noises: mean, and standard deviation through the columns of the
    /// map.
    struct Conditional
    {
      Eigen::VectorXd mean;
      Eigen::MatrixXd covariance;

      Conditional(const FieldGenerator &generator,
                  const double          scale,
                  const Conditioning   &conditioning,
                  const std::size_t     n)
      {
        std::vector<double> noise(conditioning.n_noise(), 0.), z(n, 0.);
        conditioning.apply(noise.data(), z.data());
        mean = Eigen::Map<Eigen::VectorXd>(z.data(), n);

        const auto      map = linear_map(generator, n);
        Eigen::MatrixXd G(n, map.size() + noise.size());
        for (std::size_t i = 0; i < map.size(); ++i)
          {
            z = map[i];
            for (double &value : z)
              value *= scale;
            conditioning.apply(noise.data(), z.data());
            G.col(i) = Eigen::Map<Eigen::VectorXd>(z.data(), n) - mean;
          }
        for (std::size_t i = 0; i < noise.size(); ++i)
          {
            std::fill(z.begin(), z.end(), 0.);
            noise[i] = 1.;
            conditioning.apply(noise.data(), z.data());
            noise[i] = 0.;
            G.col(map.size() + i) =
              Eigen::Map<Eigen::VectorXd>(z.data(), n) - mean;
          }
        covariance = G * G.transpose();
      }
    };



    /// The same from the formulas for a normal vector, given part of it.
    /// @param scores one per measurement, not per cell
    void
    expect_formula(const Conditional                &conditional,
                   const FieldLattice               &l,
                   const Correlation                &correlation,
                   const std::vector<MeasuredScore> &scores,
                   const double                      cell_variance,
                   const double                      error_variance,
                   const double                      tolerance)
    {
      const std::vector<double> table =
        correlation.table(l.cell_size, l.n_cells);
      const auto covariance = [&](const std::size_t a, const std::size_t b) {
        std::array<std::size_t, 3> lag;
        for (unsigned int d = 0; d < 3; ++d)
          lag[d] = std::abs(int(l.index(a)[d]) - int(l.index(b)[d]));
        return table[lag[0] + l.n_cells[0] * (lag[1] + l.n_cells[1] * lag[2])] *
               cell_variance / table[0];
      };
      const std::size_t n = l.n(), n_o = scores.size();
      Eigen::MatrixXd   C(n, n), C_lo(n, n_o), C_oo(n_o, n_o);
      Eigen::VectorXd   observed(n_o);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          C(i, j) = covariance(i, j);
      for (std::size_t o = 0; o < n_o; ++o)
        {
          observed[o] = scores[o].score;
          for (std::size_t i = 0; i < n; ++i)
            C_lo(i, o) = C(i, scores[o].cell);
          for (std::size_t p = 0; p < n_o; ++p)
            C_oo(o, p) = C(scores[o].cell, scores[p].cell);
          C_oo(o, o) += error_variance;
        }
      const Eigen::MatrixXd weights = C_oo.ldlt().solve(C_lo.transpose());
      EXPECT_LT((conditional.mean - weights.transpose() * observed)
                  .cwiseAbs()
                  .maxCoeff(),
                tolerance);
      EXPECT_LT(
        (conditional.covariance - (C - C_lo * weights)).cwiseAbs().maxCoeff(),
        tolerance);
    }



    const FieldLattice small{2,
                             {{10, 6, 1}},
                             {{0.5, 0.25, 1.}},
                             {{-1., 2., 0.}}};
  } // namespace



  TEST(Fields, conditional_mean_and_covariance_are_those_of_the_formula)
  {
    const Correlation correlation(Correlation::Function::markov, {3., 1.});
    const double      gamma =
      correlation.between_cells(small.cell_size, {{0, 0, 0}});
    const CholeskyField              cholesky(small, correlation, "");
    const std::vector<MeasuredScore> scores{{3, 1.5}, {13, -0.5}, {27, 0.7}};
    for (const double error_variance : {0., 0.2})
      for (const double cell_variance : {gamma, 1., 2.5})
        {
          const Conditioning conditioning(
            small, correlation, scores, cell_variance, error_variance, "");
          EXPECT_EQ(conditioning.n_noise(), error_variance > 0. ? 3u : 0u);
          const Conditional conditional(cholesky,
                                        std::sqrt(cell_variance / gamma),
                                        conditioning,
                                        small.n());
          expect_formula(conditional,
                         small,
                         correlation,
                         scores,
                         cell_variance,
                         error_variance,
                         1e-12);
        }
  }



  TEST(Fields, conditioning_in_3d)
  {
    const FieldLattice l{3, {{5, 4, 6}}, {{0.5, 0.25, 0.4}}, {}};
    const Correlation  correlation(Correlation::Function::markov, {3., 1., 2.});
    const double gamma = correlation.between_cells(l.cell_size, {{0, 0, 0}});
    const CholeskyField cholesky(l, correlation, "");
    // A vertical line and two others.
    const std::vector<MeasuredScore> scores{
      {42, 1.5}, {47, 1.1}, {52, 0.4}, {57, 0.2}, {0, -1.}, {119, 2.}};
    const Conditioning conditioning(l, correlation, scores, gamma, 0., "");
    expect_formula({cholesky, 1., conditioning, l.n()},
                   l,
                   correlation,
                   scores,
                   gamma,
                   0.,
                   1e-12);
  }



  TEST(Fields, several_measurements_in_a_cell_are_averaged)
  {
    const Correlation   correlation(Correlation::Function::markov, {3., 1.});
    const CholeskyField cholesky(small, correlation, "");
    const double        gamma =
      correlation.between_cells(small.cell_size, {{0, 0, 0}});
    const std::vector<MeasuredScore> scores{{3, 1.5}, {27, 0.7}, {3, -0.5}};

    const Conditioning  exact(small, correlation, scores, gamma, 0., "");
    std::vector<double> z(small.n(), 0.);
    EXPECT_EQ(exact.n_measured_cells(), 2u);
    exact.apply(nullptr, z.data());
    EXPECT_EQ(z[3], 0.5);
    EXPECT_EQ(z[27], 0.7);

    // With errors the formula takes each measurement by itself.
    const Conditioning inexact(small, correlation, scores, gamma, 0.3, "");
    EXPECT_EQ(inexact.n_noise(), 2u);
    expect_formula({cholesky, 1., inexact, small.n()},
                   small,
                   correlation,
                   scores,
                   gamma,
                   0.3,
                   1e-12);
  }



  TEST(Fields, a_conditioned_field_takes_the_measured_values)
  {
    // Of a generator that has not the exact covariance, too; and far away,
    // where the correlation is 1e-9, the field is what it was.
    const FieldLattice l{2, {{128, 32, 1}}, {{0.25, 0.25, 1.}}, {}};
    const Correlation  correlation(Correlation::Function::markov, {2., 1.});
    const LocalAverageSubdivision las(l, correlation, "");
    std::vector<MeasuredScore>    scores;
    for (unsigned int y = 4; y < 30; ++y) // a penetration test
      scores.push_back({20 + 128 * std::size_t(y), std::sin(0.3 * y)});
    const Conditioning  conditioning(l, correlation, scores, 1., 0., "");
    std::vector<double> noise(las.n_noise()), before(l.n());
    white_noise({5, 0, 0}, 0, noise.size(), noise.data());
    las.generate(noise.data(), before.data());
    std::vector<double> after = before;
    conditioning.apply(nullptr, after.data());
    double near = 0.;
    for (const MeasuredScore &m : scores)
      {
        EXPECT_EQ(after[m.cell], m.score);
        near = std::max(near, std::abs(after[m.cell + 1] - before[m.cell + 1]));
      }
    EXPECT_GT(near, 0.1);
    for (unsigned int y = 0; y < 32; ++y)
      for (unsigned int x = 110; x < 128; ++x)
        EXPECT_NEAR(after[x + 128 * y], before[x + 128 * y], 1e-8);
  }



  TEST(Fields, measurements_that_cannot_be_kept_are_refused)
  {
    // Neighbours in a very smooth field that contradict each other.
    const Correlation          correlation(Correlation::Function::gaussian,
                                  {500., 500.});
    std::vector<MeasuredScore> scores;
    for (std::size_t cell = 0; cell < 10; ++cell)
      scores.push_back({cell, cell % 2 ? 1. : -1.});
    try
      {
        const Conditioning conditioning(
          small, correlation, scores, 1., 0., "Random fields/strength");
        FAIL();
      }
    catch (const UserError &error)
      {
        EXPECT_EQ(error.where, "Random fields/strength/Measurements");
        EXPECT_NE(error.problem.find("10 cells"), std::string::npos);
      }
    const Conditioning  with_error(small, correlation, scores, 1., 0.01, "");
    std::vector<double> z(small.n(), 0.), noise(10, 0.);
    with_error.apply(noise.data(), z.data());
    for (const double value : z)
      EXPECT_LT(std::abs(value), 1.);
  }



  TEST(Fields, without_measurements_nothing_changes)
  {
    const Correlation   correlation(Correlation::Function::markov, {3., 1.});
    const Conditioning  none(small, correlation, {}, 1., 0.1, "");
    std::vector<double> z(small.n(), 2.);
    EXPECT_EQ(none.n_noise(), 0u);
    none.apply(nullptr, z.data());
    EXPECT_EQ(z, std::vector<double>(small.n(), 2.));
  }



  // The figure of doc/verification/conditioning.md.
  TEST(Long, fields_conditioning_on_two_penetration_tests)
  {
    // 16 m x 5 m; "measured" is what another realisation has in two columns.
    const FieldLattice  l{2, {{64, 20, 1}}, {{0.25, 0.25, 1.}}, {}};
    const Correlation   correlation(Correlation::Function::separable_markov,
                                  {8., 1.});
    const CholeskyField cholesky(l, correlation, "");
    const double        scale =
      1. / std::sqrt(correlation.between_cells(l.cell_size, {{0, 0, 0}}));
    const auto field = [&](const std::uint64_t realisation) {
      std::vector<double> noise(l.n()), z(l.n());
      white_noise({2024, realisation, 0}, 0, noise.size(), noise.data());
      cholesky.generate(noise.data(), z.data());
      for (double &value : z)
        value *= scale;
      return z;
    };
    const std::vector<double>  truth = field(0), unconditional = field(1);
    std::vector<MeasuredScore> scores;
    for (const std::size_t column : {16, 44})
      for (std::size_t row = 0; row < 20; ++row)
        scores.push_back({column + 64 * row, truth[column + 64 * row]});

    const Conditioning exact(l, correlation, scores, 1., 0., ""),
      inexact(l, correlation, scores, 1., 0.25, "");
    const Conditional of_exact(cholesky, scale, exact, l.n()),
      of_inexact(cholesky, scale, inexact, l.n());
    std::vector<double> conditional = unconditional;
    exact.apply(nullptr, conditional.data());
    double far = 0.; // variance at the end that no test is near
    for (std::size_t row = 0; row < 20; ++row)
      far += of_exact.covariance(63 + 64 * row, 63 + 64 * row) / 20.;
    EXPECT_NEAR(far, 1., 0.1);
    for (std::size_t cell = 0; cell < l.n(); ++cell)
      {
        const auto digits = [](const double x) {
          return std::round(1e6 * x) / 1e6;
        };
        Verification::row(
          "conditioning",
          "x,y,measured,unconditional,conditional,mean,sd,mean with error,"
          "sd with error",
          l.centre(cell)[0],
          l.centre(cell)[1],
          digits(truth[cell]),
          digits(unconditional[cell]),
          digits(conditional[cell]),
          digits(of_exact.mean[cell]),
          digits(std::sqrt(std::max(of_exact.covariance(cell, cell), 0.))),
          digits(of_inexact.mean[cell]),
          digits(std::sqrt(of_inexact.covariance(cell, cell))));
      }
  }
} // namespace fields_conditioning
