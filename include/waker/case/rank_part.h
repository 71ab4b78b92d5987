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
   * forces, loads, Newton's method and the motion of the points are found
   * there, each for its own. What lies around its points it is told of
   * others (NearCells); of the surface each rank is told all facets. Who must
   * see the places of all points, for files or to measure a body that has
   * moved, looks at the whole body, of which every rank then gets a copy
   * (State::points): know_places(). Until then that has no more than the ids.
   *
   * All functions but the const ones are collective.
   */
  template <int dim>
  class RankPart
  {
  public:
    /// @param whole the points of the whole body, which the rank has a copy of,
    ///        and gives back; kept by reference
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

    /// Mass, velocity and acceleration of the nodes; if there are loads on
    /// surfaces, the mass of theirs too.
    /// @throws NumericalFailure, on each rank, as Weights::reinit() does on one
    void
    map();

    /// The external force of the whole grid's nodes is known to each rank.
    void
    take_external_force(const NodalVector &all);

    /// Loads come to the weight that the nodes' external force has already.
    /// @param of_points by what own points carry, on the own window; changed.
    ///        And load_force, by what acts on surfaces.
    void
    add_loads(NodalVector &of_points);

    /// From the own window to that of the loads: the increments of the step.
    void
    spread_increment(NodalVector &increment) const;

    /// Values of nodes of the loads' window, of which each rank has found a
    /// part: their sum, for the whole grid.
    void
    gather_loads(const NodalVector &values, NodalVector &all) const;

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
      sum += partition->traffic();
      sum += grid->exchange().traffic();
      sum += load_grid->exchange().traffic();
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
    /// A window that reaches as far as a load may go to find support.
    std::shared_ptr<const BackgroundGrid<dim>> load_grid;
    std::vector<double>                        load_mass;  // Mg
    NodalVector                                load_force; // kN

  private:
    void
    make_window();

    void
    forget_copy();

    /// Values of own nodes, `n_components` each, go from one window to another
    /// and on to those that reach them there.
    void
    spread(const double      *mine,
           const unsigned int n_components,
           double            *there) const;

    const Case<dim>                *the_case;
    MaterialPoints<dim>            *whole;
    bool                            places_are_known = true;
    unsigned int                    steps_left       = 0; // of the copy
    NodeExchange::Traffic           sent_before; // in windows that are gone
    MPI_Comm                        communicator;
    std::unique_ptr<Partition<dim>> partition;
    PointExchange<dim>              exchange;
    bool                            loads_surfaces;
    /// Numbers of the own nodes, in both windows.
    std::vector<unsigned int> own_nodes, own_load_nodes;
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
