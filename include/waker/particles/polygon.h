// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_polygon_h
#define waker_particles_polygon_h

#include <array>
#include <string>
#include <vector>

namespace Waker
{
  /// Corners (m) of a polygon; the last is joined to the first.
  using Polygon = std::vector<std::array<double, 2>>;

  /**
   * Read "x1, y1; x2, y2; ..." (m) as a simple polygon. Either orientation is
   * taken; the result is anticlockwise. Repeated corners are dropped, also a
   * last one that repeats the first.
   *
   * @param where path of the parameter, for the error
   * @throws UserError fewer than 3 corners, not numbers, zero area, edges that
   * cross or touch
   */
  Polygon
  parse_polygon(const std::string &text, const std::string &where);

  /// Area, positive if the corners run anticlockwise (m^2).
  double
  signed_area(const Polygon &polygon);

  /// Area that two simple anticlockwise polygons share (m^2).
  double
  common_area(const Polygon &a, const Polygon &b);
} // namespace Waker

#endif
