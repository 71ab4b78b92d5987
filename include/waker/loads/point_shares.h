// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_point_shares_h
#define waker_loads_point_shares_h

#include <waker/grid/background_grid.h>
#include <waker/surface/shape/facet.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace Waker
{
  /**
   * Which material point is the closest to a piece of the surface: equivalent
   * point loads give each surface point the traction on the part of the surface
   * that lies closer to it than to any other (eq. 3.1 of Remmerswaal 2023).
   *
   * Keeps its work arrays from call to call.
   */
  template <int dim>
  class PointShares
  {
  public:
    explicit PointShares(const BackgroundGrid<dim> &grid);

    /// Sort points, which must lie inside grid and margin, into the cells.
    /// @param positions kept by reference
    void
    sort(const std::vector<Point<dim>> &positions);

    static constexpr std::uint32_t none = -1;

    /// The point closest to x; of several the first, by place in the arrays.
    /// @param n_rings if there is none within so many cells: none. Else there
    ///        must be points.
    std::uint32_t
    nearest(const Point<dim> &x,
            const int         n_rings = std::numeric_limits<int>::max()) const;

    /// Call `visit` for each point within the radius of x.
    void
    visit_within(const Point<dim>                         &x,
                 const double                              radius,
                 const std::function<void(std::uint32_t)> &visit) const;

    /// A piece of a facet and the point that it belongs to.
    using Visitor = std::function<void(const Facet<dim> &, std::uint32_t)>;

    /// Cut the facet along the bisectors of the points, and call `visit` for
    /// every piece.
    void
    split(const Facet<dim> &facet, const Visitor &visit);

  private:
    const BackgroundGrid<dim>     *grid;
    const std::vector<Point<dim>> *points = nullptr;
    std::vector<std::uint32_t>     first; // of each cell, in `order`
    std::vector<std::uint32_t>     order; // points by cell
    std::vector<std::uint32_t>     cell;  // of each point
    Facets<dim>                    pending;
  };
} // namespace Waker

#endif
