// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_wall_gaps_h
#define waker_nodes_wall_gaps_h

#include <waker/grid/background_grid.h>
#include <waker/particles/material_points.h>

#include <vector>

namespace Waker
{
  /**
   * How far soil is from places on a wall, where it really ends: not where
   * nodes have mass, which is up to a cell further.
   *
   * The soil of a point is its support domain, of which the extent across the
   * wall is scaled to the point's volume: V / A, A the area of the domain as
   * seen along the normal. So a layer that fills its sub-cells in part ends
   * where it ends. The gap at a place is that to the nearest point of those
   * whose domains the normal through the place meets. On a wall along the grid
   * it is exact while the soil keeps its shape; on an inclined one the
   * staircase of sub-cells is known to a tenth of a domain or so: less than
   * that is no gap (doc/verification/contact.md).
   */
  template <int dim>
  class WallGaps
  {
  public:
    /// Share of the domain's extent below which a gap is none.
    static constexpr double touching_share = 0.15;

    /// Soil whose centre lies further behind a wall than this is no matter of
    /// it (in cells).
    static constexpr double behind = 0.5;

    explicit WallGaps(const BackgroundGrid<dim> &grid);

    /// @param positions, normals of the places (m), normals into the soil
    void
    set_places(std::vector<Point<dim>>     positions,
               std::vector<Tensor<1, dim>> normals);

    /// @param gaps at the places (m); 0 or less: soil touches; infinite: there
    ///        is none within a cell or so
    void
    find(const MaterialPoints<dim> &points, std::vector<double> &gaps) const;

  private:
    const BackgroundGrid<dim>  *grid;
    std::vector<Point<dim>>     positions;
    std::vector<Tensor<1, dim>> normals;
    /// The places of the cell with lower corner i are those of
    /// order[first[i]..first[i + 1]).
    std::vector<unsigned int> first, order;
    /// Has the cell, or one next to it, places?
    std::vector<unsigned char> is_near;
  };
} // namespace Waker

#endif
