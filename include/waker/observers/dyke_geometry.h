// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_observers_dyke_geometry_h
#define waker_observers_dyke_geometry_h

#include <waker/boundary/surface.h>

#include <array>
#include <vector>

namespace Waker
{
  /**
   * Height and width of a dyke, read off its detected surface (section 5.2.3
   * of Remmerswaal 2023).
   */
  struct DykeGeometry
  {
    double height = 0.; // H: highest vertex of the surface (m)
    double width  = 0.; // W: total width at the water level (m)
    /// The intervals [x0, x1] of soil at the water level, from left to right:
    /// W may be a sum of parts (fig. 5.2e).
    std::vector<std::array<double, 2>> parts;
  };

  /// @param level water level (m)
  DykeGeometry
  measure_dyke(const Surface &surface, const double level);
} // namespace Waker

#endif
