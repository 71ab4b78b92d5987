// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/choice.h>
#include <waker/base/errors.h>
#include <waker/fields/correlation.h>

#include "user_errors.h"
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace fields_correlation
{
  namespace
  {
    using namespace Waker;
    using Function = Correlation::Function;

    const std::array<Function, 3> functions{
      {Function::markov, Function::separable_markov, Function::gaussian}};


    double
    gamma(const Function             function,
          const std::vector<double> &scales,
          const double               cell)
    {
      return Correlation(function, scales)
        .between_cells({{cell, cell, cell}}, {{0, 0, 0}});
    }


    /// Integral over -1 < s < 1, split where the weight 1 - |s| and (for whole
    /// lags) the correlation have kinks.
    template <typename F>
    double
    integral(const F &f)
    {
      using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
      return Rule::integrate(f, -1., 0., 15, 1e-11) +
             Rule::integrate(f, 0., 1., 15, 1e-11);
    }


    // Vanmarcke's table for lines and the two 2D and 3D columns of the notes on
    // numerics, section 7.3, to their five digits.
    TEST(Correlation, variance_function_of_a_line)
    {
      const std::array<std::array<double, 2>, 7> expected{{{{0.125, 0.921625}},
                                                           {{0.25, 0.852245}},
                                                           {{0.5, 0.735759}},
                                                           {{1., 0.567668}},
                                                           {{2., 0.377289}},
                                                           {{4., 0.218760}},
                                                           {{10., 0.095000}}}};
      for (const auto &[T, value] : expected)
        {
          EXPECT_NEAR(gamma(Function::markov, {1.}, T), value, 5e-7);
          EXPECT_NEAR(gamma(Function::separable_markov, {1.}, T), value, 5e-7);
        }
    }


    TEST(Correlation, cells_on_a_line)
    {
      const std::array<double, 5> expected{
        {0.852245, 0.619272, 0.375608, 0.227818, 0.138178}};
      const Correlation         markov(Function::markov, {4.});
      const std::vector<double> table =
        markov.table({{1., 1., 1.}}, {{5, 1, 1}});
      for (int k = 0; k < 5; ++k)
        {
          EXPECT_NEAR(markov.between_cells({{1., 1., 1.}}, {{k, 0, 0}}),
                      expected[k],
                      5e-7);
          EXPECT_NEAR(table[k], expected[k], 5e-7);
        }
    }


    TEST(Correlation, variance_function_of_cells)
    {
      struct Row
      {
        std::vector<double> scales;
        double              cell, separable, ellipsoidal;
      };
      const std::vector<Row> rows{
        {{0.5, 0.5}, 0.125, 0.72632, 0.77640},
        {{4., 0.5}, 0.125, 0.83476, 0.84876},
        {{24., 0.5}, 0.125, 0.84929, 0.85209},
        {{48., 0.5}, 0.125, 0.85077, 0.85220},
        {{0.25, 0.25, 0.25}, 0.0625, 0.61900, 0.72390},
        {{1.25, 1.25, 0.25}, 0.0625, 0.79772, 0.83861},
        {{10., 10., 0.25}, 0.0625, 0.84518, 0.85182}};
      for (const Row &row : rows)
        {
          EXPECT_NEAR(gamma(Function::separable_markov, row.scales, row.cell),
                      row.separable,
                      5.1e-6);
          EXPECT_NEAR(gamma(Function::markov, row.scales, row.cell),
                      row.ellipsoidal,
                      5.1e-6);
        }
    }


    // Against an adaptive quadrature of the definition, with its own splits.
    TEST(Correlation, ellipsoidal_cells_against_adaptive_quadrature)
    {
      const Correlation                     markov(Function::markov, {3., 0.5});
      const std::array<double, 3>           cell{{0.2, 0.125, 1.}};
      const std::vector<std::array<int, 3>> lags{{{0, 0, 0}},
                                                 {{1, 0, 0}},
                                                 {{0, 1, 0}},
                                                 {{5, 1, 0}},
                                                 {{40, 0, 0}},
                                                 {{-3, 7, 0}}};
      for (const auto &lag : lags)
        {
          const double expected = integral([&](const double s) {
            return (1. - std::fabs(s)) * integral([&](const double t) {
                     return (1. - std::fabs(t)) *
                            markov.between_points({{(lag[0] + s) * cell[0],
                                                    (lag[1] + t) * cell[1],
                                                    0.}});
                   });
          });
          EXPECT_NEAR(markov.between_cells(cell, lag) / expected, 1., 1e-9)
            << lag[0] << ' ' << lag[1];
        }
    }


    TEST(Correlation, lines_against_adaptive_quadrature)
    {
      // The Gaussian one changes its formula at cell = 2.26 theta, the Markov
      // one at 0.005 theta.
      for (const Function f : {Function::markov, Function::gaussian})
        for (const double cell : {0.001, 0.00499, 0.00501, 0.3, 2.2, 2.3, 9.})
          for (const int k : {0, 1, 2, 5})
            {
              const Correlation line(f, {1.});
              const double      expected = integral([&](const double s) {
                return (1. - std::fabs(s)) *
                       line.between_points({{(k + s) * cell, 0., 0.}});
              });
              EXPECT_NEAR(line.between_cells({{cell, 1., 1.}}, {{k, 0, 0}}),
                          expected,
                          1e-11 * (k == 0 ? expected : 1.))
                << int(f) << ' ' << cell << ' ' << k;
            }
    }


    // The average over 2 x 2 x 2 cells is that over one of twice the size: ties
    // the covariances of neighbours to the variance of the large cell.
    TEST(Correlation, small_cells_make_up_the_large_one)
    {
      for (const Function f : functions)
        for (const double scale : {0.3, 4., 300.})
          {
            const std::vector<double>   scales{scale, 2., 0.7};
            const std::array<double, 3> cell{{0.4, 0.25, 0.5}};
            const std::array<double, 3> large{{0.8, 0.5, 1.}};
            for (unsigned int dim = 1; dim <= 3; ++dim)
              {
                const Correlation  correlation(f,
                                              {scales.begin(),
                                                scales.begin() + dim});
                double             sum = 0.;
                std::array<int, 3> i{{0, 0, 0}};
                const int          y = dim > 1, z = dim > 2;
                for (i[0] = -1; i[0] <= 1; ++i[0])
                  for (i[1] = -y; i[1] <= y; ++i[1])
                    for (i[2] = -z; i[2] <= z; ++i[2])
                      {
                        double weight = 1.;
                        for (unsigned int d = 0; d < dim; ++d)
                          weight *= i[d] == 0 ? 0.5 : 0.25;
                        sum += weight * correlation.between_cells(cell, i);
                      }
                EXPECT_NEAR(sum / correlation.between_cells(large, {{0, 0, 0}}),
                            1.,
                            1e-12)
                  << int(f) << ' ' << scale << ' ' << dim;
              }
          }
    }


    TEST(Correlation, table_holds_every_lag)
    {
      const std::array<double, 3>       cell{{0.125, 0.1, 0.2}};
      const std::array<unsigned int, 3> n{{7, 5, 4}};
      for (const Function f : functions)
        for (unsigned int dim = 1; dim <= 3; ++dim)
          {
            const std::vector<double>         scales{2., 0.5, 0.9};
            const Correlation                 correlation(f,
                                          {scales.begin(),
                                                           scales.begin() + dim});
            const std::array<unsigned int, 3> size{
              {n[0], dim > 1 ? n[1] : 1, dim > 2 ? n[2] : 1}};
            const std::vector<double> table = correlation.table(cell, size);
            ASSERT_EQ(table.size(), std::size_t(size[0]) * size[1] * size[2]);
            std::size_t number = 0;
            for (int k = 0; k < int(size[2]); ++k)
              for (int j = 0; j < int(size[1]); ++j)
                for (int i = 0; i < int(size[0]); ++i, ++number)
                  {
                    const double expected =
                      correlation.between_cells(cell, {{i, -j, k}});
                    ASSERT_NEAR(table[number], expected, 1e-14);
                  }
          }
    }


    // exp(-2 |x| / theta) and exp(-pi x^2 / theta^2) have the scale of
    // fluctuation theta: their integral over the line.
    TEST(Correlation, scale_of_fluctuation_is_the_integral)
    {
      for (const Function f : functions)
        for (const double theta : {0.5, 24.})
          {
            const Correlation correlation(f, {theta});
            double            sum = 0.;
            const double      dx  = theta / 1000.;
            for (int i = -12000; i < 12000; ++i)
              sum +=
                dx * correlation.between_points({{(i + 0.5) * dx, 0., 0.}});
            EXPECT_NEAR(sum / theta, 1., 1e-6);
          }
      const Correlation markov(Function::markov, {3., 0.5});
      EXPECT_NEAR(markov.between_points({{1.5, 0.25, 0.}}),
                  std::exp(-std::sqrt(2.)),
                  1e-15);
      const Correlation separable(Function::separable_markov, {3., 0.5});
      EXPECT_NEAR(separable.between_points({{-1.5, 0.25, 0.}}),
                  std::exp(-2.),
                  1e-15);
    }


    TEST(Correlation, names)
    {
      const auto named = [](const std::string &name) {
        return choice_named<Function>(name, "Correlation");
      };
      EXPECT_EQ(named("Markov"), Function::markov);
      EXPECT_EQ(named("separable Markov"), Function::separable_markov);
      EXPECT_EQ(named("Gaussian"), Function::gaussian);
      EXPECT_USER_ERROR(named("markov"), "Correlation", "is \"markov\"");
    }
  } // namespace
} // namespace fields_correlation
