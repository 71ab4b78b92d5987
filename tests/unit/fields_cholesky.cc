// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/fields/cholesky_field.h>
#include <waker/fields/covariance_factor.h>

#include "linear_map.h"
#include "user_errors.h"
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace fields_cholesky
{
  using namespace Waker;

  namespace
  {
    /// Largest difference between G G^T and the covariance of cell averages.
    double
    largest_error(const FieldGenerator &generator,
                  const FieldLattice   &l,
                  const Correlation    &correlation)
    {
      const auto                map = linear_map(generator, l.n());
      const std::vector<double> table =
        correlation.table(l.cell_size, l.n_cells);
      double error = 0.;
      for (std::size_t a = 0; a < l.n(); ++a)
        for (std::size_t b = 0; b <= a; ++b)
          {
            // Not with the function that the generator uses.
            const auto i = l.index(a), j = l.index(b);
            const int  x = std::abs(int(i[0]) - int(j[0])),
                      y  = std::abs(int(i[1]) - int(j[1])),
                      z  = std::abs(int(i[2]) - int(j[2]));
            error =
              std::max(error,
                       std::abs(
                         covariance(map, a, b) -
                         table[x + l.n_cells[0] * (y + l.n_cells[1] * z)]));
          }
      return error;
    }
  } // namespace



  TEST(Fields, cholesky_has_the_covariance_of_cell_averages)
  {
    const std::array<double, 3> size{{0.25, 0.125, 0.5}};
    const std::vector<double>   theta{4., 0.5, 2.};
    for (const FieldLattice &l : {FieldLattice{1, {{40, 1, 1}}, size, {}},
                                  FieldLattice{2, {{12, 8, 1}}, size, {}},
                                  FieldLattice{3, {{6, 5, 4}}, size, {}}})
      for (const auto function : {Correlation::Function::markov,
                                  Correlation::Function::separable_markov,
                                  Correlation::Function::gaussian})
        {
          const Correlation   correlation(function,
                                        {theta.begin(), theta.begin() + l.dim});
          const CholeskyField field(l, correlation, "");
          EXPECT_EQ(field.n_noise(), l.n());
          EXPECT_LT(largest_error(field, l, correlation), 1e-13);
        }
  }



  TEST(Fields, cholesky_of_a_covariance_that_is_singular_in_double_precision)
  {
    // 144 cells much smaller than the scale: rank 10 or so.
    const FieldLattice l{2, {{12, 12, 1}}, {{0.1, 0.1, 1.}}, {}};
    const Correlation  correlation(Correlation::Function::gaussian, {20., 20.});
    const CholeskyField field(l, correlation, "");
    EXPECT_NE(field.description().find("rank"), std::string::npos);
    EXPECT_EQ(field.n_noise(), l.n());
    EXPECT_LT(largest_error(field, l, correlation), 1e-12);
  }



  TEST(Fields, cholesky_of_too_many_cells_is_refused)
  {
    const FieldLattice l{2, {{240, 40, 1}}, {{0.125, 0.125, 1.}}, {}};
    const Correlation  correlation(Correlation::Function::markov, {24., 0.5});
    try
      {
        const CholeskyField field(l, correlation, "Random fields/strength");
        FAIL();
      }
    catch (const UserError &error)
      {
        EXPECT_EQ(error.where, "Random fields/strength/Generator");
        EXPECT_NE(error.problem.find("9600"), std::string::npos);
        EXPECT_NE(error.allowed.find("6000"), std::string::npos);
      }
  }



  TEST(Fields, no_covariance_is_factorised_that_is_none)
  {
    Eigen::MatrixXd C = Eigen::MatrixXd::Identity(3, 3);
    C(0, 1) = C(1, 0) = C(1, 2) = C(2, 1) = 0.9;
    C(0, 2) = C(2, 0) = -0.9;
    EXPECT_USER_ERROR(covariance_factor(C, "Random fields/strength"),
                      "Random fields/strength/Generator",
                      "the covariance of 3 cells is not positive semidefinite");
    C(0, 0) = std::nan("");
    EXPECT_USER_ERROR(covariance_factor(C, "Random fields/strength"),
                      "Random fields/strength/Scales of fluctuation",
                      "is not finite");

    // Singular, but a covariance: two numbers that are the same.
    C                       = Eigen::MatrixXd::Ones(2, 2);
    const Eigen::MatrixXd L = covariance_factor(C, "");
    EXPECT_EQ(L.cols(), 1);
    EXPECT_LT((L * L.transpose() - C).cwiseAbs().maxCoeff(), 1e-15);
  }
} // namespace fields_cholesky
