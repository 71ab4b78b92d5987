// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_wetted_segments_h
#define waker_loads_wetted_segments_h

#include <waker/surface/shape/facet.h>

namespace Waker
{
  /**
   * The outer slope of the largest body, from its outer toe along its surface
   * up to where it first reaches the water level, the last segment clipped
   * there (section 5.2.2 of Remmerswaal 2023).
   *
   * The outer toe, with the water on the left, is the left end of the body's
   * contact with the closed bottom of the grid. If the body also leans against
   * the closed left wall, it is the point where its surface leaves the wall. A
   * body that touches no bottom starts at its lowest vertex, the left one of
   * several; if that is more than a cell above the bottom, the body floats and
   * is wet on both sides of it. One that does not reach the level is loaded
   * until it meets a closed face again, other than that wall. Water on the
   * right: mirrored.
   *
   * @param section segments of closed chains, that of the largest body first
   *        (to_facets())
   * @param level of the water (m)
   * @param bottom height of the lower side of the grid's box (m)
   * @param cell_size of the grid (m)
   * @param wetted overwritten, from the toe up: so do the vertices of each run,
   *        whatever side the body is on
   */
  void
  find_wetted_segments(const Facets<2> &section,
                       const bool       water_left,
                       const double     level,
                       const double     bottom,
                       const double     cell_size,
                       Facets<2>       &wetted);
} // namespace Waker

#endif
