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

    /// The external force of this part: that of the whole grid, and what the
    /// water in the ground does to the own points.
    void
    take_loads(const NodalVector &all);

    /// The points have moved: they go where they belong, and the whole body
    /// gets its places.
    void
    moved(MaterialPoints<dim> &whole);

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
  };


  /// @throws UserError for what cannot be computed on several ranks yet, if
  ///         there are several
  template <int dim>
  void
  check_for_ranks(const Case<dim> &the_case);

  /// On one rank there is none.
  /// @throws UserError as check_for_ranks() does
  template <int dim>
  std::unique_ptr<RankPart<dim>>
  make_rank_part(const Case<dim> &the_case, const MaterialPoints<dim> &points);
} // namespace Waker

#endif
