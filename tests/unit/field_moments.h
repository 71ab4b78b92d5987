// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_field_moments_h
#define waker_tests_field_moments_h

#include <waker/fields/field_generator.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Waker
{
  inline FieldLattice
  field_lattice(const std::array<unsigned int, 3> &n,
                const std::array<double, 3>       &cell_size = {{1., 1., 1.}})
  {
    const unsigned int dim = n[2] > 1 ? 3 : n[1] > 1 ? 2 : 1;
    return {dim, n, cell_size, {}};
  }



  /// Exact variance of every cell, and covariance with the next one in x and
  /// y: without keeping the linear map.
  struct Moments
  {
    std::vector<double> variance, next_x, next_y;

    Moments(const FieldGenerator &generator, const FieldLattice &l)
      : variance(l.n(), 0.)
      , next_x(l.n(), 0.)
      , next_y(l.n(), 0.)
    {
      std::vector<double> noise(generator.n_noise(), 0.), z(l.n());
      const std::size_t   n = l.n(), row = l.n_cells[0];
      for (double &u : noise)
        {
          u = 1.;
          generator.generate(noise.data(), z.data());
          u = 0.;
          for (std::size_t c = 0; c < n; ++c)
            variance[c] += z[c] * z[c];
          for (std::size_t c = 0; c + 1 < n; ++c)
            next_x[c] += z[c] * z[c + 1]; // of the last in a row: no meaning
          for (std::size_t c = 0; c + row < n; ++c)
            next_y[c] += z[c] * z[c + row];
        }
    }
  };



  struct Errors
  {
    double least_variance = 1e9, largest_variance = -1e9;
    double least_lag_1 = 1e9, largest_lag_1 = -1e9, mean_lag_1 = 0.;
  };



  /// Relative errors over the lattice (%); lag 1 in direction x.
  inline Errors
  errors(const Moments      &moments,
         const FieldLattice &l,
         const Correlation  &correlation)
  {
    const double gamma = correlation.between_cells(l.cell_size, {{0, 0, 0}});
    const double lag_1 = correlation.between_cells(l.cell_size, {{1, 0, 0}});
    Errors       e;
    double       n_pairs = 0.;
    for (std::size_t c = 0; c < l.n(); ++c)
      {
        const double variance = 100. * (moments.variance[c] / gamma - 1.);
        e.least_variance      = std::min(e.least_variance, variance);
        e.largest_variance    = std::max(e.largest_variance, variance);
        if (l.index(c)[0] + 1 == l.n_cells[0])
          continue;
        const double covariance = 100. * (moments.next_x[c] / lag_1 - 1.);
        e.least_lag_1           = std::min(e.least_lag_1, covariance);
        e.largest_lag_1         = std::max(e.largest_lag_1, covariance);
        e.mean_lag_1 += covariance;
        ++n_pairs;
      }
    e.mean_lag_1 /= n_pairs;
    return e;
  }
} // namespace Waker

#endif
