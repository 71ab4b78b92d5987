// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_reached_nodes_h
#define waker_nodes_reached_nodes_h

#include <waker/grid/background_grid.h>

#include <vector>

namespace Waker
{
  /**
   * The nodes that points reach, in runs of neighbours along x: the part of
   * the grid that a step has to do with, often a third of it. On each line of
   * nodes the run covers, from its first to its last, all nodes with mass and
   * their neighbours: with linear functions a node without mass may have a
   * force.
   */
  class ReachedNodes
  {
  public:
    struct Run
    {
      std::size_t begin, end; // nodes
    };

    template <int dim>
    explicit ReachedNodes(const BackgroundGrid<dim> &grid);

    /// @param mass of the nodes (Mg)
    void
    reinit(const std::vector<double> &mass);

    std::vector<Run>::const_iterator
    begin() const
    {
      return runs.begin();
    }

    std::vector<Run>::const_iterator
    end() const
    {
      return runs.end();
    }

    /// Those of them that this rank owns: what sums over the nodes go over
    /// before the ranks add them up (NodeExchange). On one rank all.
    const std::vector<Run> &
    owned() const
    {
      return exchange->is_one_rank() ? runs : owned_runs;
    }

    /// What the ranks tell each other of the nodes.
    const NodeExchange &
    ranks() const
    {
      return *exchange;
    }

  private:
    unsigned int              n[3];        // nodes per direction, 1 in z in 2D
    std::vector<unsigned int> first, last; // with mass, per line; n[0], 0: none
    std::vector<Run>          runs;
    std::vector<Run>          owned_runs; // empty on one rank
    const NodeExchange       *exchange;
  };
} // namespace Waker

#endif
