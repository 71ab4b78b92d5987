// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_fields_correlation_h
#define waker_fields_correlation_h

#include <waker/fields/lattice.h>

#include <array>
#include <vector>

namespace Waker
{
  /**
   * Correlation of a stationary field between two points, and between the
   * averages of two cells. With the scales of fluctuation theta_d (m) and the
   * lag tau (m):
   *   Markov            exp(-sqrt(sum (2 tau_d / theta_d)^2)), ellipsoidal
   *   separable Markov  exp(-sum |2 tau_d / theta_d|)
   *   Gaussian          exp(-pi sum (tau_d / theta_d)^2)
   * (Vanmarcke 1983; Fenton & Griffiths 2008, functions dlavx2, dlsep2, dlspx2
   * of Fenton.)
   */
  class Correlation
  {
  public:
    enum class Function
    {
      markov,
      separable_markov,
      gaussian
    };

    /// @param scales of fluctuation (m), > 0, one per direction
    Correlation(const Function function, const std::vector<double> &scales);

    unsigned int
    dim() const
    {
      return theta.size();
    }

    const std::vector<double> &
    scales() const
    {
      return theta;
    }

    /// Between two points `lag` (m) apart.
    double
    between_points(const std::array<double, 3> &lag) const;

    /**
     * Between the averages over two cells that are `lag` cells apart, for unit
     * variance of a point: lag 0 gives the variance function gamma of the cell
     * (Vanmarcke 1983, variance function). In closed form
     * where there is one, otherwise by Gauss quadrature with a relative error
     * below 1e-9 near the origin.
     */
    double
    between_cells(const std::array<double, 3> &cell_size,
                  const std::array<int, 3>    &lag) const;

    /// between_cells() for lags 0 <= lag_d < n_d, first index fastest.
    std::vector<double>
    table(const std::array<double, 3>       &cell_size,
          const std::array<unsigned int, 3> &n) const;

  private:
    /// The factor of one direction in the average of two cells `lag` apart;
    /// of the functions that are a product of such factors.
    double
    line(const double cell_size, const unsigned int d, const int lag) const;

    /// Is it such a product?
    bool
    is_product() const;

    Function            kind;
    std::vector<double> theta;
  };

  constexpr const char *
  name_of(const Correlation::Function function)
  {
    switch (function)
      {
        case Correlation::Function::markov:
          return "Markov";
        case Correlation::Function::separable_markov:
          return "separable Markov";
        case Correlation::Function::gaussian:
          return "Gaussian";
      }
    return nullptr;
  }
} // namespace Waker

#endif
