// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_liquid_h
#define waker_loads_liquid_h

#include <algorithm>

namespace Waker
{
  /// A liquid at rest at some moment.
  struct Liquid
  {
    double unit_weight = 0.; // kN/m^3
    double level       = 0.; // m

    /// Pressure at the height y (m), in kPa: 0 above the level.
    double
    pressure(const double y) const
    {
      return unit_weight * std::max(level - y, 0.);
    }
  };
} // namespace Waker

#endif
