// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_boxes_box_union_chains_h
#define waker_surface_boxes_box_union_chains_h

#include <waker/surface/shape/surface.h>

#include <array>
#include <cstddef>
#include <vector>

namespace Waker
{
  /**
   * Closed chains from the vertical edges of a contour, which come from left to
   * right: the horizontal edges follow from where they end.
   *
   * Two parts of a body that touch in a corner only are apart there: the chain
   * turns left, round the part that it has followed. A chain may so pass a
   * place twice, but never crosses itself.
   */
  class ContourChains
  {
  public:
    /// A vertical edge between ranks of coordinates. Upwards if the body lies
    /// on its left, downwards if on its right.
    struct Edge
    {
      unsigned int x;
      unsigned int low;
      unsigned int high;
      bool         upwards;
    };

    /// Which ranks of x and y are closed faces, in the order of the faces'
    /// numbers; no_face: none.
    using FaceRanks                       = std::array<unsigned int, 4>;
    static constexpr unsigned int no_face = -1;

    /// @param n_y number of ranks of y
    void
    start(const unsigned int n_y);

    /// All edges at one x, from the lowest to the highest; no two go on in the
    /// same direction.
    void
    add(const std::vector<Edge> &edges_at_x);

    /// Put the chains together, in the order of Surface.
    void
    finish(const std::vector<double> &x,
           const std::vector<double> &y,
           const FaceRanks           &faces,
           Surface                   &surface);

  private:
    static constexpr unsigned int none = -1;

    // Edge e has the vertices 2e (low) and 2e + 1 (high).
    void
    open(const unsigned int vertex, const unsigned int y);

    void
    close(const unsigned int vertex, const unsigned int y);

    std::vector<Edge>          edges;
    std::vector<unsigned int>  open_vertex; // per rank of y
    std::vector<unsigned int>  next_edge;   // per edge, along the chain
    std::vector<unsigned char> followed;    // per edge
    std::vector<std::size_t>   order;
    std::vector<double>        areas;
  };
} // namespace Waker

#endif
