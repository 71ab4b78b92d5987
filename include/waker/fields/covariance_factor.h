// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_fields_covariance_factor_h
#define waker_fields_covariance_factor_h

#include <waker/fields/lattice.h>

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace Waker
{
  /// Position of the lag between two cells in a table as Correlation::table()
  /// gives it, of n[0] x n[1] x n[2] lags.
  inline std::size_t
  lag_index(const std::array<unsigned int, 3> &a,
            const std::array<unsigned int, 3> &b,
            const std::array<unsigned int, 3> &n)
  {
    const auto lag = [&](const unsigned int d) {
      return std::size_t(a[d] > b[d] ? a[d] - b[d] : b[d] - a[d]);
    };
    return lag(0) + n[0] * (lag(1) + n[1] * lag(2));
  }



  /**
   * C of all cells of a box of n[0] x n[1] x n[2] cells, first direction
   * fastest.
   * @param table of lags, as Correlation::table(cell_size, n) gives it
   */
  Eigen::MatrixXd
  covariance_matrix(const std::vector<double>         &table,
                    const std::array<unsigned int, 3> &n);

  /**
   * L with L L^T = C: the lower triangle of Cholesky if C is positive definite
   * in double precision, otherwise the pivoted factorisation up to the
   * numerical rank r (then L has r columns and is no triangle).
   *
   * @param C square and symmetric; used up as work space
   * @param variance what rounding errors in C are relative to; 0: its largest
   *        diagonal
   * @throws UserError path + "/Generator" if C has clearly negative eigenvalues
   */
  Eigen::MatrixXd
  covariance_factor(Eigen::MatrixXd    C,
                    const std::string &path,
                    const double       variance = 0.);
} // namespace Waker

#endif
