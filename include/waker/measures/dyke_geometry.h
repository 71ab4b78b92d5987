// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_measures_dyke_geometry_h
#define waker_measures_dyke_geometry_h

#include <waker/base/numbers.h>
#include <waker/surface/shape/facet.h>

#include <array>
#include <limits>
#include <vector>

namespace Waker
{
  /**
   * Height and width of a dyke, read off its detected surface (section 5.2.3
   * of Remmerswaal 2023).
   */
  struct DykeGeometry
  {
    /// H: highest vertex of all chains, on the vertical axis (m). No soil is
    /// lower than any level: -infinity.
    double height = -std::numeric_limits<double>::infinity();
    /// Where W is measured (m); NaN: nowhere.
    double level = nan;
    /// W: total width of the soil that rises above the level, at that level
    /// (m). A crest exactly at the level counts as not above it. NaN if there
    /// is no level.
    double width = nan;
    /// The intervals [x0, x1] of soil at the water level, from left to right:
    /// W may be a sum of parts (fig. 5.2e).
    std::vector<std::array<double, 2>> parts;
  };

  /// @param section segments of closed chains
  /// @param level (m) at which W is measured, or NaN. Holes count as no soil.
  DykeGeometry
  measure_dyke(const Facets<2> &section, const double level);
} // namespace Waker

#endif
