// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/ranks.h>
#include <waker/case/rank_part.h>
#include <waker/mapping/transfer.h>

namespace Waker
{
  namespace
  {
    /// The points are dealt out anew when a rank has so many times the mean.
    constexpr double largest_imbalance = 1.1;


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
  {
    make_window();
    for (const LoadProgrammeParameters &programme :
         the_case.parameters.load_programmes)
      {
        for (const Watched watched :
             {programme.held_by, programme.stopped_by, programme.quantity})
          if (watched == Watched::plastic_strain)
            needed.push_back("plastic strain");
        // What becomes mass has the acceleration of its point.
        needed.push_back("acceleration");
      }
  }


  template <int dim>
  void
  RankPart<dim>::make_window()
  {
    if (grid)
      sent_before += grid->exchange().traffic();
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
  }


  template <int dim>
  bool
  RankPart<dim>::balance()
  {
    if (exchange.imbalance() <= largest_imbalance)
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
  }


  template <int dim>
  void
  RankPart<dim>::gather_mass(std::vector<double> &all) const
  {
    partition->gather(*grid, nodes->mass.data(), 1, all.data());
  }


  template <int dim>
  void
  RankPart<dim>::take_loads(const NodalVector *const all,
                            NodalVector             &of_points)
  {
    NodalVector &force = nodes->external_force;
    if (all != nullptr)
      partition->restrict_to(*grid, all->begin(), dim, force.begin());
    grid->exchange().sum({{of_points.begin(), dim}});
    force += of_points;
  }


  template <int dim>
  void
  RankPart<dim>::gather_increment(NodalVector &all) const
  {
    all.reinit(dim * the_case->grid.n_nodes());
    partition->gather(*grid, nodes->increment.begin(), dim, all.begin());
  }


  template <int dim>
  void
  RankPart<dim>::moved()
  {
    exchange.send_home(*partition);
    places_are_known = false;
  }


  template <int dim>
  MaterialPoints<dim> &
  RankPart<dim>::know_places()
  {
    if (!places_are_known)
      exchange.gather_places(*whole, needed);
    places_are_known = true;
    return *whole;
  }


  template <int dim>
  void
  RankPart<dim>::complete(NodalState &all)
  {
    exchange.gather(*whole);
    places_are_known = true;
    complete_nodes(all);
  }


  template <int dim>
  void
  RankPart<dim>::complete_nodes(NodalState &all) const
  {
    gather_mass(all.mass);
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
