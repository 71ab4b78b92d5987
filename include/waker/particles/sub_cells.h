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
   * sub-cell (i, j[, k]) is the unit square (cube) with its lower corner there.
   */
  template <int dim>
  struct LatticePart
  {
    std::array<int, dim>    index;    // i, j[, k]
    double                  share;    // of the sub-cell; after merging also > 1
    std::array<double, dim> centroid; // after merging also outside the sub-cell
  };

  using SubCellPart = LatticePart<2>;

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
   * side, the one of largest share (if equal, of the nearest centroid). Volume
   * and first moment are kept. A part that still is too small goes on to its
   * own neighbour; one without a neighbour stays.
   *
   * @param parts lexicographically (i fastest)
   */
  template <int dim>
  std::vector<LatticePart<dim>>
  merge_small_parts(const std::vector<LatticePart<dim>> &parts,
                    const double                         minimum_share);

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
