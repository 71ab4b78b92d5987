// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_shape_surface_h
#define waker_surface_shape_surface_h

#include <deal.II/base/point.h>

#include <vector>

namespace Waker
{
  using namespace dealii;

  /**
   * A closed, oriented chain of straight segments: segment k runs from
   * vertices[k] to vertices[k + 1], the last back to vertices[0]. The body lies
   * on its left: outer chains run anticlockwise, holes clockwise.
   */
  struct SurfaceChain
  {
    std::vector<Point<2>> vertices; // m
    /// on_face[k]: the face of the grid that segment k closes the body against
    /// (2d lower, 2d + 1 upper face in direction d), or -1: a free surface.
    std::vector<int> on_face;

    /// Signed area: positive for an outer chain (m^2).
    double
    area() const;
  };

  /// The detected surface of a body in 2D, outer chains in the order of
  /// decreasing area, then holes, the largest first as well.
  struct Surface
  {
    std::vector<SurfaceChain> chains;
  };
} // namespace Waker

#endif
