// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_rank_part_h
#define waker_case_rank_part_h

#include <waker/case/case.h>
#include <waker/case/state.h>
#include <waker/grid/partition.h>
#include <waker/mapping/weights.h>
#include <waker/nodes/nodal_state.h>
#include <waker/particles/body.h>
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
    /// @param whole the points of the whole body, which the rank has a copy of;
    ///        kept by reference
    RankPart(const Case<dim> &the_case, MaterialPoints<dim> &whole);

    MaterialPoints<dim> &
    points()
    {
      return exchange.own();
    }

    /// Deal the points out anew if one rank has many more than the others.
    /// @return whether that was done: grid, weights and nodes are new ones
    bool
    balance();

    /// Mass, velocity and acceleration of the nodes.
    /// @throws NumericalFailure, on each rank, as Weights::reinit() does on one
    void
    map();

    /// Those of the whole grid.
    void
    gather_mass(std::vector<double> &all) const;

    /// The external force of this part.
    /// @param all that of the whole grid; nullptr: it is in the nodes already
    /// @param of_points by what own points carry, on the own window; changed
    void
    take_loads(const NodalVector *all, NodalVector &of_points);

    /// The points have moved: they go where they belong.
    void
    moved();

    /// The whole body's copy gets its places, if it does not have them since
    /// the points have moved.
    MaterialPoints<dim> &
    know_places();

    /// For those who look at all of it.
    Body<dim>
    body()
    {
      return Body<dim>(exchange.own(),
                       grid,
                       [this]() -> const MaterialPoints<dim> & {
                         return know_places();
                       });
    }

    /// How far the nodes of the whole grid have moved in the step.
    void
    gather_increment(NodalVector &all) const;

    /// Points leave the body.
    /// @param own_list their places in the own points, ascending
    /// @return those of all of them in the whole body
    std::vector<std::size_t>
    remove(const std::vector<std::size_t> &own_list)
    {
      return exchange.remove(own_list);
    }

    /// The whole body has got points at its end.
    void
    take_new()
    {
      exchange.take_new(*partition, *whole);
    }

    /// All that the whole body's copy lacks: arrays of the points, and nodes.
    void
    complete(NodalState &nodes);

    /// The nodes alone.
    void
    complete_nodes(NodalState &nodes) const;

    /// What this rank has sent so far.
    NodeExchange::Traffic
    traffic() const
    {
      NodeExchange::Traffic sum = sent_before;
      sum += exchange.traffic();
      sum += grid->exchange().traffic();
      return sum;
    }

    PointExchange<dim> &
    point_exchange()
    {
      return exchange;
    }

    // Of this rank; balance() makes new ones.
    std::shared_ptr<const BackgroundGrid<dim>> grid;
    std::unique_ptr<const Fixities<dim>>       fixities;
    std::unique_ptr<Weights<dim>>              weights;
    std::unique_ptr<NodalState>                nodes;

  private:
    void
    make_window();

    const Case<dim>                *the_case;
    MaterialPoints<dim>            *whole;
    bool                            places_are_known = true;
    NodeExchange::Traffic           sent_before; // in windows that are gone
    MPI_Comm                        communicator;
    std::unique_ptr<Partition<dim>> partition;
    PointExchange<dim>              exchange;
    /// Arrays that the whole body must have after each step, beside places.
    std::vector<std::string> needed;
  };


  /// Is the case computed by more than one? Without MPI there is one.
  template <int dim>
  bool
  has_several_ranks(const Case<dim> &the_case);

  /// On one rank there is none.
  template <int dim>
  std::unique_ptr<RankPart<dim>>
  make_rank_part(const Case<dim> &the_case, MaterialPoints<dim> &points);
} // namespace Waker

#endif
