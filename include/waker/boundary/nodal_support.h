// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_boundary_nodal_support_h
#define waker_boundary_nodal_support_h

#include <array>
#include <vector>

namespace Waker
{
  /// A node that takes a share of another node's load.
  struct SupportNode
  {
    unsigned int node; // number in the plane's lattice, x fastest
    int          dx;   // offset from the node without support, in cells
    int          dy;
    double       distance; // squared, in cells
    double       weight;
  };

  /**
   * Hand the load of a node with hardly any mass to nodes of the body.
   *
   * Finds the nodes with at least `minimum_mass` around a node of an x-y plane
   * and weights w of them with sum w = 1 and sum w (x - x_node) = 0: a force on
   * the node, and w times it on the others, have the same resultant and the
   * same moment. The weights are those of moving least squares with linear
   * polynomials and 1/distance^4, over the smallest square of 3 x 3, 5 x 5, ...
   * nodes in which they exist (not all on one line) and none exceeds 2 in size;
   * if no square up to 9 x 9 keeps that limit, over the best one.
   *
   * If all nodes with mass lie on one line, the nearest share the load equally:
   * the resultant is kept, the moment is not. If there is none, `nodes` is
   * empty.
   *
   * @param mass of the plane's nodes, n[0] n[1] entries (any unit)
   * @param nodes overwritten; its storage is used again
   */
  void
  find_support(const double                      *mass,
               const double                       minimum_mass,
               const std::array<unsigned int, 2> &n,
               const unsigned int                 node,
               std::vector<SupportNode>          &nodes);
} // namespace Waker

#endif
