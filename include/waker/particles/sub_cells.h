// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_sub_cells_h
#define waker_particles_sub_cells_h

#include <waker/particles/polygon.h>

#include <array>
#include <vector>

namespace Waker
{
  /**
   * The part of a sub-cell that lies in a layer, in units of the sub-cells:
   * sub-cell (i, j) is the unit square from (i, j) to (i + 1, j + 1).
   */
  struct SubCellPart
  {
    std::array<int, 2> index; // i, j
    double             share; // of the sub-cell's area; after merging also > 1
    std::array<double, 2> centroid; // after merging also outside the sub-cell
  };

  /**
   * Cut the lattice of unit squares with a polygon: the parts that are not
   * empty, lexicographically (i fastest). Exact for every simple polygon, in
   * O(area + cut squares): each piece of an edge in a square adds what lies to
   * its right, signed, to the square and to the rest of its row.
   *
   * @param corners simple polygon, anticlockwise, in units of the lattice
   */
  std::vector<SubCellPart>
  cut_sub_cells(const Polygon &corners);

  /**
   * Give the parts with a share below `minimum_share` to a neighbour across a
   * side, the one of largest share (if equal, of the nearest centroid). Area
   * and first moment are kept. A part that still is too small goes on to its
   * own neighbour; one without a neighbour stays.
   */
  std::vector<SubCellPart>
  merge_small_parts(const std::vector<SubCellPart> &parts,
                    const double                    minimum_share);

  /// A piece of an interval: the same in one dimension.
  struct IntervalPart
  {
    int    index;
    double share;
    double centroid;
  };

  /// Cut the unit intervals with [begin, end]; end pieces with a share below
  /// `minimum_share` go to their neighbour.
  std::vector<IntervalPart>
  cut_intervals(const double begin,
                const double end,
                const double minimum_share);
} // namespace Waker

#endif
