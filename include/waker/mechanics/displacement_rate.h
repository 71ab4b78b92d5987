// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_displacement_rate_h
#define waker_mechanics_displacement_rate_h

#include <cmath>

namespace Waker
{
  /// Root mean square of the points' displacement rates in a step (m/s).
  /// Nothing is at rest: 0 without points, when the last has left the grid.
  /// @param square sum of mass times squared displacement (Mg m^2)
  /// @param mass of all points (Mg)
  /// @param dt of the step (s)
  inline double
  displacement_rate(const double square, const double mass, const double dt)
  {
    return mass > 0. ? std::sqrt(square / mass) / dt : 0.;
  }
} // namespace Waker

#endif
