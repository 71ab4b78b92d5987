// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_rank_part_h
#define waker_case_rank_part_h

#include <waker/case/case.h>
#include <waker/case/state.h>
#include <waker/grid/partition.h>
#include <waker/mapping/weights.h>
#include <waker/nodes/nodal_state.h>
#include <waker/particles/point_exchange.h>

#include <memory>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * What one of several ranks computes of a realisation: the points in its
   * cells, and the nodes that they reach, on a window of the grid. Stresses,
   * forces, Newton's method and the motion of the points are found there, each
   * for its own. Surfaces, loads and measures belong to the whole body, which
   * every rank has a copy of (State::points, Scene::nodes), right in what they
   * need: places, and mass.
   *
   * All functions but the const ones are collective.
   */
  template <int dim>
  class RankPart
  {
  public:
    /// @param points of the whole body
    RankPart(const Case<dim> &the_case, const MaterialPoints<dim> &points);

    MaterialPoints<dim> &
    points()
    {
      return exchange.own();
    }

    /// Deal the points out anew if one rank has many more than the others.
    /// @return whether that was done: grid, weights and nodes are new ones
    bool
    balance();

    /// Mass, velocity and acceleration of the nodes, and all nodes' mass.
    /// @throws NumericalFailure, on each rank, as Weights::reinit() does on one
    void
    map(std::vector<double> &all_mass);

    /// The external force of this part.
    /// @param all that of the whole grid
    /// @param of_points by what own points carry, on the own window:
    /// overwritten
    void
    take_loads(const NodalVector &all, NodalVector &of_points);

    /// The points have moved: they go where they belong, and the whole body
    /// gets its places.
    void
    moved(MaterialPoints<dim> &whole);

    /// How far the nodes of the whole grid have moved in the step.
    void
    gather_increment(NodalVector &all) const;

    /// Points have left the whole body, or are about to.
    /// @param list, own_list their places in it, and in the own points
    void
    remove(const std::vector<std::size_t> &list,
           const std::vector<std::size_t> &own_list)
    {
      exchange.remove(list, own_list);
    }

    /// The whole body has got points at its end.
    void
    take_new(const MaterialPoints<dim> &whole)
    {
      exchange.take_new(*partition, whole);
    }

    /// All that the whole body's copy lacks: arrays of the points, and nodes.
    void
    complete(MaterialPoints<dim> &whole, NodalState &nodes) const;

    PointExchange<dim> &
    point_exchange()
    {
      return exchange;
    }

    // Of this rank; balance() makes new ones.
    std::unique_ptr<const BackgroundGrid<dim>> grid;
    std::unique_ptr<const Fixities<dim>>       fixities;
    std::unique_ptr<Weights<dim>>              weights;
    std::unique_ptr<NodalState>                nodes;

  private:
    void
    make_window();

    const Case<dim>                *the_case;
    MPI_Comm                        communicator;
    std::unique_ptr<Partition<dim>> partition;
    PointExchange<dim>              exchange;
    /// Arrays that the whole body must have after each step, beside places.
    std::vector<std::string> needed;
  };


  /// On one rank there is none.
  template <int dim>
  std::unique_ptr<RankPart<dim>>
  make_rank_part(const Case<dim> &the_case, const MaterialPoints<dim> &points);
} // namespace Waker

#endif
