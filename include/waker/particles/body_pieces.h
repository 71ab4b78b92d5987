// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_body_pieces_h
#define waker_particles_body_pieces_h

#include <waker/particles/layer_body.h>

#include <functional>
#include <utility>
#include <vector>

namespace Waker
{
  /// A trapezoid of a prism's cross-section: between two heights that are
  /// linear in x, from x = begin to x = end.
  struct Trapezoid
  {
    double begin, end;
    Plane  floor, roof;
  };


  /// Cut a cross-section at the x of all its corners.
  std::vector<Trapezoid>
  trapezoids(const Polygon &corners);


  /// A convex piece in plan, over which a body reaches from the highest of
  /// the floors to the lowest of the roofs.
  struct Piece
  {
    Plan               plan;
    std::vector<Plane> floors, roofs;
  };


  /// Call f(piece) for the pieces of a trapezoid of a body over a convex part
  /// of the plan.
  void
  for_each_piece(const LayerBody                          &body,
                 const Trapezoid                          &trapezoid,
                 const Plan                               &window,
                 const std::function<void(const Piece &)> &f);


  /// Volume and first moments.
  struct Moments
  {
    double                volume = 0.;
    std::array<double, 3> first{}; // x, y, z
  };


  /// Add the volume and first moment of a piece; exact.
  void
  add_piece(const Piece &piece, Moments &sum);

  /// Heights between which all of a piece lies.
  std::pair<double, double>
  height_range(const Piece &piece);
} // namespace Waker

#endif
