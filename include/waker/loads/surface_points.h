// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_surface_points_h
#define waker_loads_surface_points_h

#include <waker/loads/point_shares.h>
#include <waker/particles/material_points.h>

#include <cstdint>
#include <vector>

namespace Waker
{
  /**
   * The material points among which the closest to a place on some facets is:
   * all of them on one rank; on several ranks those of all ranks that may be
   * the closest, which are few.
   *
   * A facet is in a ball of radius r around its centre. If some point is at
   * distance d of the centre, the point closest to any place of the facet is
   * within d + 2r of it. For each facet the rank in whose cells the centre lies
   * says what d is; then each rank tells of its points that are within d + 2r.
   *
   * Keeps its work arrays from call to call.
   */
  template <int dim>
  class SurfacePoints
  {
  public:
    /// @param grid the whole one
    /// @param window of this rank; on one rank the grid
    SurfacePoints(const BackgroundGrid<dim> &grid,
                  const BackgroundGrid<dim> &window);

    /// Look at the points as they lie, which are this rank's own, for these
    /// facets, which each rank knows. Collective.
    void
    find(const MaterialPoints<dim>              &points,
         const std::vector<const Facets<dim> *> &facets);

    /// A piece of a facet and the own point that it belongs to.
    using Visitor = typename PointShares<dim>::Visitor;

    /// The pieces of a facet, or of a part of one of those of find(), that
    /// belong to own points (PointShares::split()).
    void
    split(const Facet<dim> &facet, const Visitor &visit);

  private:
    /// A facet and how far from its centre points may matter (m).
    struct Ball
    {
      Point<dim> centre;
      double     facet_radius, radius;
    };

    void
    find_radii(const MaterialPoints<dim> &points);

    void
    tell_all(const MaterialPoints<dim> &points);

    const BackgroundGrid<dim> *grid, *window;
    PointShares<dim>           shares;
    // On several ranks.
    PointShares<dim>               own_shares;
    std::vector<Ball>              balls;
    std::vector<Point<dim>>        positions; // of all that may be the closest
    std::vector<std::uint32_t>     place;     // of own ones, or not_here
    Point<dim>                     low, high; // between which the own ones are
    static constexpr std::uint32_t not_here = -1;
  };
} // namespace Waker

#endif
