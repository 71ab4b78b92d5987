// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_fields_ellipsoidal_moments_h
#define waker_fields_ellipsoidal_moments_h

#include <array>

namespace Waker
{
  /**
   * The 2^dim integrals over a unit box of lags, first corner j, of
   *   prod w_d(t_d) exp(-|a (j + t)|), w = 1 - t (bit d of m is 0) or t (1),
   * for the ellipsoidal Markov correlation; a = 2 cell size / theta. The
   * covariance of two cells is a sum over the 2^dim boxes that meet at their
   * lag (Correlation::between_cells).
   */
  class EllipsoidalMoments
  {
  public:
    /// @param dim 1 to 3; a of the other directions is not read
    EllipsoidalMoments(const unsigned int dim, const std::array<double, 3> &a);

    /// Number m of the integrals, box >= 0; relative error below 1e-9.
    std::array<double, 8>
    operator()(const std::array<int, 3> &box) const;

  private:
    unsigned int          dim;
    std::array<double, 3> a;

    /// Adds the integrals over the part [low, low + length] of the unit box.
    void
    add(const std::array<double, 3> &low,
        const std::array<double, 3> &length,
        const std::array<int, 3>    &box,
        std::array<double, 8>       &moments) const;
  };
} // namespace Waker

#endif
