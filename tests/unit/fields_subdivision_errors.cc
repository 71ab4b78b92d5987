// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/random_numbers.h>
#include <waker/fields/local_average_subdivision.h>

#include "field_moments.h"
#include "verification_data.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace fields_subdivision_errors
{
  using namespace Waker;

  // The tables of doc/verification/local_average_subdivision.md.
  TEST(Long, fields_local_average_subdivision_errors)
  {
    const auto write = [](const unsigned int dim,
                          const unsigned int k,
                          const unsigned int m,
                          const double       theta) {
      std::array<unsigned int, 3> n{{1, 1, 1}};
      std::fill_n(n.begin(), dim, k << m);
      const FieldLattice            l = field_lattice(n);
      const Correlation             correlation(Correlation::Function::markov,
                                    std::vector<double>(dim, theta));
      const LocalAverageSubdivision las(l, correlation, "", std::pow(k, dim));
      const Errors                  e = errors({las, l}, l, correlation);
      EXPECT_LE(m == 1 ? std::max(-e.least_variance, e.largest_variance) : 0.,
                1e-6);
      Verification::row(
        "local_average_subdivision",
        "dim,k,m,theta/cell,least variance %,largest variance %,"
        "mean lag 1 %,least lag 1 %,largest lag 1 %",
        dim,
        k,
        m,
        theta,
        e.least_variance,
        e.largest_variance,
        e.mean_lag_1,
        e.least_lag_1,
        e.largest_lag_1);
    };
    for (const unsigned int m : {1u, 2u, 3u})
      for (const double theta : {4., 8., 16., 32.})
        {
          write(1, 8, m, theta);
          write(2, 8, m, theta);
        }
    write(3, 8, 1, 4.);
    write(3, 8, 2, 4.);
  }



  TEST(Long, fields_local_average_subdivision_chapter_5)
  {
    // The random field of the dyke: 30 m x 5 m in cells of 0.125 m.
    const FieldLattice l = field_lattice({{240, 40, 1}}, {{0.125, 0.125, 1.}});
    struct Case
    {
      unsigned int stage_0, m;
      double       theta_h, least, largest; // known_errors(): the same patterns
    };
    for (const Case &c : {Case{256, 3, 24., -28.409, 32.671},
                          Case{256, 3, 4., -24.564, 19.675},
                          Case{256, 3, 0.5, -19.477, 11.363},
                          Case{600, 2, 24., 0., 0.},
                          Case{600, 2, 4., 0., 0.},
                          Case{600, 2, 0.5, -8.695, 5.620}})
      {
        const Correlation             correlation(Correlation::Function::markov,
                                      {c.theta_h, 0.5});
        const LocalAverageSubdivision las(l, correlation, "", c.stage_0);
        EXPECT_EQ(las.n_subdivisions(), c.m);
        EXPECT_EQ(las.stage_0()[0], 240u >> c.m);
        EXPECT_EQ(las.stage_0()[1], 40u >> c.m);
        const Moments moments(las, l);
        const Errors  e = errors(moments, l, correlation);
        const double  gamma =
          correlation.between_cells(l.cell_size, {{0, 0, 0}});
        const double lag_y =
          correlation.between_cells(l.cell_size, {{0, 1, 0}});
        double mean_variance = 0., mean_y = 0.;
        for (std::size_t cell = 0; cell < l.n(); ++cell)
          {
            const auto   i = l.index(cell);
            const double variance =
              100. * (moments.variance[cell] / gamma - 1.);
            mean_variance += variance / l.n();
            if (i[1] + 1 < 40)
              mean_y +=
                100. * (moments.next_y[cell] / lag_y - 1.) / (240. * 39.);
            if (c.m == 3 && i[0] < 120 &&
                i[1] < 20) // the rest is a mirror image
              Verification::row("local_average_subdivision_map",
                                "theta_h,i,j,variance %",
                                c.theta_h,
                                i[0],
                                i[1],
                                std::round(100. * variance) / 100.);
          }
        if (c.least < 0.)
          {
            EXPECT_NEAR(e.least_variance, c.least, 0.001);
            EXPECT_NEAR(e.largest_variance, c.largest, 0.001);
          }
        Verification::row("local_average_subdivision_chapter5",
                          "m,theta_h,gamma,least variance %,mean variance %,"
                          "largest variance %,mean lag 1 x %,mean lag 1 y %",
                          c.m,
                          c.theta_h,
                          gamma,
                          e.least_variance,
                          mean_variance,
                          e.largest_variance,
                          e.mean_lag_1,
                          mean_y);
      }
  }



  TEST(Long, fields_local_average_subdivision_of_white_noise)
  {
    // 5,000 fields: mean and variance of every cell are those of the linear
    // map, within statistical error.
    const FieldLattice l = field_lattice({{64, 64, 1}});
    const Correlation  correlation(Correlation::Function::markov, {4., 4.});
    const LocalAverageSubdivision las(l, correlation, "", 64);
    const Moments                 exact(las, l);
    constexpr unsigned int        n = 5000;
    std::vector<double>           noise(las.n_noise()), z(l.n()), sum(l.n()),
      squares(l.n());
    for (unsigned int field = 0; field < n; ++field)
      {
        white_noise({77, field, 0}, 0, noise.size(), noise.data());
        las.generate(noise.data(), z.data());
        for (std::size_t c = 0; c < z.size(); ++c)
          {
            sum[c] += z[c];
            squares[c] += z[c] * z[c];
          }
      }
    // In standard deviations of the estimates; 4,096 cells, correlated.
    double worst_mean = 0., worst_variance = 0., mean_square = 0.;
    for (std::size_t c = 0; c < z.size(); ++c)
      {
        const double mean = sum[c] / std::sqrt(n * exact.variance[c]);
        const double variance =
          (squares[c] / n / exact.variance[c] - 1.) / std::sqrt(2. / n);
        worst_mean     = std::max(worst_mean, std::abs(mean));
        worst_variance = std::max(worst_variance, std::abs(variance));
        mean_square += variance * variance / z.size();
      }
    EXPECT_LT(worst_mean, 5.);
    EXPECT_LT(worst_variance, 5.);
    EXPECT_NEAR(mean_square, 1., 0.25);
  }
} // namespace fields_subdivision_errors
