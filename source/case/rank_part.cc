// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/host.h>
#include <waker/base/ranks.h>
#include <waker/case/rank_part.h>
#include <waker/loads/nodal_support.h>
#include <waker/mapping/transfer.h>
#include <waker/measures/sliding_masses.h>
#include <waker/surface/user_surface.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    /// A forest whose cells cost what the points in them do.
    template <int dim>
    std::unique_ptr<Partition<dim>>
    balanced(const BackgroundGrid<dim> &grid,
             const MPI_Comm             communicator,
             const MaterialPoints<dim> &points)
    {
      auto partition = std::make_unique<Partition<dim>>(grid, communicator);
      partition->balance(points.position);
      return partition;
    }
  } // namespace


  template <int dim>
  RankPart<dim>::RankPart(const Case<dim> &the_case, MaterialPoints<dim> &whole)
    : the_case(&the_case)
    , whole(&whole)
    , communicator(the_case.grid.communicator())
    , partition(balanced(the_case.grid, communicator, whole))
    , exchange(*partition, communicator, whole)
    , loads_surfaces(the_case.parameters.water.stands() ||
                     !the_case.parameters.tractions.empty())
  {
    forget_copy();
    make_window();
  }


  template <int dim>
  void
  RankPart<dim>::forget_copy()
  {
    // What flows in comes to the copy first.
    if (the_case->flow.has_inflow())
      return;
    exchange.forget(*whole);
    places_are_known = false;
    give_back_memory();
  }


  namespace
  {
    /// A copy of the whole body that nobody has asked for in so many steps
    /// goes.
    constexpr unsigned int steps_of_copy = 20;


    std::vector<unsigned int>
    owned_nodes(const NodeExchange &ranks, const unsigned int n_nodes)
    {
      std::vector<unsigned int> owned;
      for (unsigned int node = 0; node < n_nodes; ++node)
        if (ranks.owns(node))
          owned.push_back(node);
      return owned;
    }
  } // namespace


  template <int dim>
  void
  RankPart<dim>::make_window()
  {
    if (grid)
      {
        sent_before += grid->exchange().traffic();
        sent_before += load_grid->exchange().traffic();
      }
    // Those that look at the window go first.
    weights.reset();
    fixities.reset();
    grid     = partition->make_window();
    fixities = std::make_unique<const Fixities<dim>>(the_case->fixities,
                                                     the_case->grid,
                                                     *grid);
    weights =
      std::make_unique<Weights<dim>>(*grid,
                                     the_case->parameters.mapping.functions);
    nodes = std::make_unique<NodalState>(*grid);

    constexpr int reach = std::max(support_reach, carrying_reach);
    load_grid           = partition->make_window({reach, reach});
    load_mass.assign(load_grid->n_nodes(), 0.);
    load_force.reinit(load_grid->n_dofs());
    // Both in the order of the whole grid.
    own_nodes      = owned_nodes(grid->exchange(), grid->n_nodes());
    own_load_nodes = owned_nodes(load_grid->exchange(), load_grid->n_nodes());
    AssertDimension(own_nodes.size(), own_load_nodes.size());
  }


  template <int dim>
  bool
  RankPart<dim>::balance()
  {
    if (exchange.imbalance() <= the_case->parameters.ranks.largest_imbalance)
      return false;
    partition->balance(exchange.own().position);
    exchange.send_home(*partition);
    make_window();
    return true;
  }


  template <int dim>
  void
  RankPart<dim>::map()
  {
    grid->exchange().together([&]() { weights->reinit(exchange.own()); });
    to_nodes(exchange.own(), *weights, *nodes);
    if (loads_surfaces)
      spread(nodes->mass.data(), 1, load_mass.data());
  }


  template <int dim>
  void
  RankPart<dim>::spread(const double *const mine,
                        const unsigned int  n_components,
                        double *const       there) const
  {
    for (std::size_t k = 0; k < own_nodes.size(); ++k)
      std::copy_n(mine + std::size_t(n_components) * own_nodes[k],
                  n_components,
                  there + std::size_t(n_components) * own_load_nodes[k]);
    load_grid->exchange().send_to_others({{there, n_components}});
  }


  template <int dim>
  void
  RankPart<dim>::spread_increment(NodalVector &increment) const
  {
    increment.reinit(load_grid->n_dofs());
    spread(nodes->increment.begin(), dim, increment.begin());
  }


  template <int dim>
  void
  RankPart<dim>::take_external_force(const NodalVector &all)
  {
    partition->restrict_to(*grid,
                           all.begin(),
                           dim,
                           nodes->external_force.begin());
  }


  template <int dim>
  void
  RankPart<dim>::add_loads(NodalVector &of_points)
  {
    if (loads_surfaces)
      {
        load_grid->exchange().add_to_owners({{load_force.begin(), dim}});
        for (std::size_t k = 0; k < own_nodes.size(); ++k)
          for (unsigned int c = 0; c < dim; ++c)
            of_points.local_element(dim * own_nodes[k] + c) +=
              load_force.local_element(dim * own_load_nodes[k] + c);
      }
    grid->exchange().sum({{of_points.begin(), dim}});
    nodes->external_force += of_points;
  }


  template <int dim>
  void
  RankPart<dim>::gather_loads(const NodalVector &values, NodalVector &all) const
  {
    NodalVector sum = values;
    load_grid->exchange().add_to_owners({{sum.begin(), dim}});
    all.reinit(dim * the_case->grid.n_nodes());
    partition->gather(*load_grid, sum.begin(), dim, all.begin());
  }


  template <int dim>
  void
  RankPart<dim>::moved()
  {
    exchange.send_home(*partition);
    places_are_known = false;
    if (steps_left > 0 && --steps_left == 0)
      forget_copy();
  }


  template <int dim>
  MaterialPoints<dim> &
  RankPart<dim>::know_places()
  {
    if (!places_are_known)
      exchange.gather_places(*whole,
                             {"initial_position",
                              "initial half size",
                              SlidingMassFinder<dim>::changed_scalar(),
                              SlidingMassFinder<dim>::volume_scalar()});
    places_are_known = true;
    steps_left       = steps_of_copy;
    return *whole;
  }


  template <int dim>
  void
  RankPart<dim>::complete(NodalState &all)
  {
    exchange.gather(*whole);
    places_are_known = true;
    steps_left       = steps_of_copy;
    complete_nodes(all);
  }


  template <int dim>
  void
  RankPart<dim>::complete_nodes(NodalState &all) const
  {
    partition->gather(*grid, nodes->mass.data(), 1, all.mass.data());
    const auto gather = [&](const NodalVector &mine, NodalVector &theirs) {
      theirs.reinit(dim * the_case->grid.n_nodes());
      partition->gather(*grid, mine.begin(), dim, theirs.begin());
    };
    gather(nodes->velocity, all.velocity);
    gather(nodes->acceleration, all.acceleration);
    gather(nodes->external_force, all.external_force);
    gather(nodes->internal_force, all.internal_force);
    gather(nodes->increment, all.increment);
  }


  template <int dim>
  bool
  has_several_ranks(const Case<dim> &the_case)
  {
    return n_ranks(the_case.grid.communicator()) > 1;
  }


  template <int dim>
  std::unique_ptr<RankPart<dim>>
  make_rank_part(const Case<dim> &the_case, MaterialPoints<dim> &points)
  {
    if (!has_several_ranks(the_case))
      return nullptr;
    return std::make_unique<RankPart<dim>>(the_case, points);
  }


  template bool
  has_several_ranks(const Case<2> &);
  template bool
  has_several_ranks(const Case<3> &);
  template class RankPart<2>;
  template class RankPart<3>;
  template std::unique_ptr<RankPart<2>>
  make_rank_part(const Case<2> &, MaterialPoints<2> &);
  template std::unique_ptr<RankPart<3>>
  make_rank_part(const Case<3> &, MaterialPoints<3> &);
} // namespace Waker
