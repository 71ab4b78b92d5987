// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_rows_h
#define waker_particles_rows_h

#include <waker/particles/polygon.h>

#include <vector>

namespace Waker
{
  /// A rectangle of a row of the lattice, in units of the sub-cells: it fills
  /// the row from x = begin to x = end, and y from row to row + 1.
  struct RowRectangle
  {
    int    row;
    double begin;
    double end;
  };

  /**
   * Divide [begin, end] into equal parts, as near to unit length as a whole
   * number of them allows, at least one, none longer than `largest`.
   *
   * @return the ends of the parts, ascending, the first and last as given
   */
  std::vector<double>
  divide(const double begin, const double end, const double largest);

  /**
   * Fill a polygon with rectangles, row by row (section 3.5 and fig. 3.5b of
   * Remmerswaal 2023): in each row of the lattice every stretch that the
   * polygon has at the row's mid-height is divided into equal rectangles of
   * nearly unit width. So a slope cuts the middle of the side of each
   * outermost rectangle. Bottom row first, each from left to right.
   *
   * The area is that of the polygon by the mid-point rule, one point a row: it
   * is exact if corners lie only on the lines between rows. Stretches
   * shorter than 1e-6 get no rectangle.
   *
   * @param corners simple polygon, in units of the lattice
   * @param largest width that a rectangle may have, at least 1
   */
  std::vector<RowRectangle>
  fill_rows(const Polygon &corners, const double largest);
} // namespace Waker

#endif
