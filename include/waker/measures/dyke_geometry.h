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
  template <int dim>
  class BackgroundGrid;
  template <int dim>
  struct MaterialPoints;

  /**
   * Height and width of a dyke, read off its detected surface (section 5.2.3
   * of Remmerswaal 2023).
   */
  struct DykeGeometry
  {
    /// H: highest vertex of all chains, on the vertical axis (m). No soil is
    /// lower than any level: -infinity. In space that of the lowest section.
    double height = -std::numeric_limits<double>::infinity();
    /// Where W is measured (m); NaN: nowhere.
    double level = nan;
    /// W: total width of the soil that rises above the level, at that level
    /// (m). A crest exactly at the level counts as not above it. NaN if there
    /// is no level. In space that of the narrowest section.
    double width = nan;
    /// The intervals [x0, x1] of soil at the water level, from left to right:
    /// W may be a sum of parts (fig. 5.2e).
    std::vector<std::array<double, 2>> parts;
    /// z of the lowest and of the narrowest section (m); NaN in the plane, and
    /// without a level.
    double height_z = std::numeric_limits<double>::quiet_NaN();
    double width_z  = std::numeric_limits<double>::quiet_NaN();
  };

  /// @param section segments of closed chains
  /// @param level (m) at which W is measured, or NaN. Holes count as no soil.
  DykeGeometry
  measure_dyke(const Facets<2> &section, const double level);

  /**
   * A dyke in space is measured in sections across it: the z in the middle of
   * each layer of cells in which there was soil at t = 0 (m, ascending).
   */
  std::vector<double>
  dyke_sections(const BackgroundGrid<3> &grid, const MaterialPoints<3> &points);

  /**
   * H and W are the least of all sections, each with its z (of several the
   * first): water gets over a dyke where it is lowest.
   *
   * @param facets a closed surface
   * @param sections z of them (m), ascending
   */
  DykeGeometry
  measure_dyke(const Facets<3>           &facets,
               const std::vector<double> &sections,
               const double               level);
} // namespace Waker

#endif
