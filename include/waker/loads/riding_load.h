// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_riding_load_h
#define waker_loads_riding_load_h

#include <waker/grid/node_exchange.h>
#include <waker/loads/point_shares.h>
#include <waker/particles/material_points.h>
#include <waker/surface/shape/facet.h>

#include <array>
#include <cstdint>
#include <vector>

namespace Waker
{
  /**
   * The part of a surface on which a load was put at t = 0, in pieces that stay
   * with the soil: the soil may sink, turn or tear, and carries what it
   * carries.
   *
   * A piece of a surface that was found rides on the point that is closest to
   * it (loads/point_shares.h): it keeps its place on the support domain of
   * that point, so that the load fits the internal force wherever the point
   * goes, and none of it falls on nodes without mass. A piece of a user's
   * surface lies between vertices that the material carries.
   *
   * Made once, at t = 0, and shared by all realisations: where the pieces are
   * follows from the points, which are known by their id, and from the
   * vertices, which are part of the state (SurfaceVertices).
   */
  template <int dim>
  struct RidingLoad
  {
    struct Piece
    {
      Facet<dim>     start;     // at t = 0
      std::uint32_t  point;     // place in the arrays at t = 0; if on_points
      std::uint64_t  id;        // of that point
      Tensor<1, dim> half_size; // of its support domain at t = 0 (m)
    };

    std::vector<Piece> pieces;
    bool               on_points = true; // or on vertices
    /// Do vertices say how large the pieces are, and how they are turned?
    bool has_vertices = false;
    /// Length or area at t = 0 (m^(dim-1)).
    double measure = 0.;

    /// Let the facets ride on the points. @param shares of these points
    void
    ride_on_points(const Facets<dim>         &part,
                   const MaterialPoints<dim> &points,
                   PointShares<dim>          &shares);

    /// Let the facets ride on vertices.
    void
    ride_on_vertices(const Facets<dim> &part);

    /// The vertices at t = 0, dim for each piece; none if it needs none.
    std::vector<Point<dim>>
    start_vertices() const;

    /// A piece now.
    struct Placed
    {
      const Piece   *piece;
      Tensor<1, dim> area; // vector, m^(dim-1); what it was if not has_vertices
    };

    /**
     * Where the pieces are. Those whose point has left the grid are not among
     * them.
     *
     * @param points those of this rank, of which each has some
     * @param vertices as start_vertices(), carried to now
     * @param facets, placed overwritten; one for each piece that is there, on
     *        each rank
     */
    void
    place(const NodeExchange            &ranks,
          const MaterialPoints<dim>     &points,
          const std::vector<Point<dim>> &vertices,
          Facets<dim>                   &facets,
          std::vector<Placed>           &placed) const;

  private:
    /// Where a piece lies now.
    struct Vertices
    {
      std::uint64_t                            piece;
      std::array<std::array<double, dim>, dim> x; // m
    };

    /// Of those that ride on points which are there, by piece.
    std::vector<Vertices>
    ride_with_points(const NodeExchange        &ranks,
                     const MaterialPoints<dim> &points) const;

    /// Of each piece the place of its point among these, or n_points().
    std::vector<std::size_t>
    find_points(const NodeExchange        &ranks,
                const MaterialPoints<dim> &points) const;
  };

  /// The place at t = 0 of a place on a facet.
  /// @param now, start the facet, its vertices in the same order
  template <int dim>
  Point<dim>
  start_place(const Facet<dim> &now,
              const Facet<dim> &start,
              const Point<dim> &x);
} // namespace Waker

#endif
