// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_shape_facet_h
#define waker_surface_shape_facet_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace Waker
{
  using namespace dealii;

  struct Surface;

  /**
   * A flat piece of a body's surface: a segment in 2D, a triangle in 3D.
   *
   * The vertices are ordered so that the body lies on the left of the segment
   * from the first to the second, or behind the triangle seen anticlockwise.
   */
  template <int dim>
  struct Facet
  {
    std::array<Point<dim>, dim> vertices; // m
    Tensor<1, dim>              normal;   // unit vector out of the body
    /// Face of the grid that the facet closes the body against (2d lower, 2d +
    /// 1 upper face in direction d), or -1: a free surface.
    int on_face = -1;
    /// Does it bound a hole that lies inside a body?
    bool in_hole = false;
    /// Number of the chain that it is a segment of, or that it was extruded
    /// from; -1: it is of none.
    int chain = -1;

    /// Length (m) or area (m^2).
    double
    measure() const;

    /// The mean of the vertices (m).
    Point<dim>
    centroid() const;
  };

  /// The facet of these vertices, its normal from their order. The normal of a
  /// facet without extent is zero.
  template <int dim>
  Facet<dim>
  make_facet(const std::array<Point<dim>, dim> &vertices,
             const int                          on_face = -1);

  /// A whole surface. What has found it says how its facets hang together.
  template <int dim>
  using Facets = std::vector<Facet<dim>>;

  /// The segments of all chains, in their order: each begins where the one
  /// before ends.
  Facets<2>
  to_facets(const Surface &surface);

  /// The same in `facets`, which is overwritten, its storage used again.
  void
  to_facets(const Surface &surface, Facets<2> &facets);

  /// The sides of a body that has this section from `back` to `front` along z
  /// (m), without its ends: two triangles a segment, in their order.
  Facets<3>
  extrude(const Facets<2> &section, const double back, const double front);

  /// Volume (m^dim) that closed facets enclose: the divergence theorem.
  template <int dim>
  double
  enclosed_volume(const Facets<dim> &facets);
} // namespace Waker

#endif
