// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_linear_map_h
#define waker_tests_linear_map_h

#include <waker/fields/field_generator.h>

#include <vector>

namespace Waker
{
  /// The columns of the linear map G from noise to field: field = G noise, so
  /// that its covariance is G G^T, exactly.
  inline std::vector<std::vector<double>>
  linear_map(const FieldGenerator &generator, const std::size_t n_cells)
  {
    std::vector<double>              noise(generator.n_noise(), 0.);
    std::vector<std::vector<double>> columns(noise.size());
    for (std::size_t i = 0; i < noise.size(); ++i)
      {
        noise[i] = 1.;
        columns[i].resize(n_cells);
        generator.generate(noise.data(), columns[i].data());
        noise[i] = 0.;
      }
    return columns;
  }



  /// Covariance of two cells.
  inline double
  covariance(const std::vector<std::vector<double>> &map,
             const std::size_t                       a,
             const std::size_t                       b)
  {
    double sum = 0.;
    for (const auto &column : map)
      sum += column[a] * column[b];
    return sum;
  }
} // namespace Waker

#endif
