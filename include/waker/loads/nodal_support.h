// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_nodal_support_h
#define waker_loads_nodal_support_h

#include <array>
#include <limits>
#include <vector>

namespace Waker
{
  /// A node that takes a share of another node's load.
  template <int dim>
  struct SupportNode
  {
    unsigned int         node;     // number in the lattice, x fastest
    std::array<int, dim> offset;   // from the node without support, in cells
    double               distance; // squared, in cells
    double               weight;
  };

  /// So many nodes away from a node one looks for support; further only if
  /// there is none.
  constexpr int support_reach = 4;

  /// All nodes of the lattice are known.
  constexpr int anywhere = std::numeric_limits<int>::max();


  /**
   * Hand the load of a node with hardly any mass to nodes of the body.
   *
   * Finds the nodes with at least `minimum_mass` around a node of a lattice and
   * weights w of them with sum w = 1 and sum w (x - x_node) = 0: a force on the
   * node, and w times it on the others, have the same resultant and the same
   * moment. The weights are those of moving least squares with linear
   * polynomials and 1/distance^4, over the smallest square (cube) of 3, 5, ...
   * nodes a side in which they exist (not all on one line, in 3D in one plane)
   * and none exceeds 2 in size; if no square up to 9 nodes a side
   * (support_reach) keeps that limit, over the best one.
   *
   * If the nodes with mass determine no linear function, the nearest share the
   * load equally: the resultant is kept, the moment is not. If there is none,
   * `nodes` is empty.
   *
   * @param mass of the lattice's nodes, n[0] n[1] (n[2]) entries (any unit)
   * @param nodes overwritten; its storage is used again
   * @param reach what lies further away is not known: at least support_reach
   * @return false if there may be support beyond `reach`; `nodes` is empty then
   */
  template <int dim>
  bool
  find_support(const double                        *mass,
               const double                         minimum_mass,
               const std::array<unsigned int, dim> &n,
               const unsigned int                   node,
               std::vector<SupportNode<dim>>       &nodes,
               const int                            reach = anywhere);
} // namespace Waker

#endif
