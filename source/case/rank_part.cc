// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/case/rank_part.h>
#include <waker/mapping/transfer.h>

#include <string>

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
  RankPart<dim>::RankPart(const Case<dim>           &the_case,
                          const MaterialPoints<dim> &points)
    : the_case(&the_case)
    , communicator(the_case.grid.communicator())
    , partition(balanced(the_case.grid, communicator, points))
    , exchange(*partition, communicator, points)
  {
    make_window();
  }


  template <int dim>
  void
  RankPart<dim>::make_window()
  {
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
  RankPart<dim>::map(std::vector<double> &all_mass)
  {
    std::string problem;
    try
      {
        weights->reinit(exchange.own());
      }
    catch (const NumericalFailure &failure)
      {
        problem = failure.what();
      }
    for (const std::string &text :
         Utilities::MPI::all_gather(communicator, problem))
      if (!text.empty())
        throw NumericalFailure(text);
    to_nodes(exchange.own(), *weights, *nodes);
    partition->gather(*grid, nodes->mass.data(), 1, all_mass.data());
  }


  template <int dim>
  void
  RankPart<dim>::take_loads(const NodalVector &all)
  {
    NodalVector &force = nodes->external_force;
    if (!the_case->pore_water.empty())
      {
        NodalVector of_pores(grid->n_dofs());
        the_case->pore_water.add_nodal_forces(exchange.own(),
                                              *weights,
                                              of_pores);
        grid->exchange().sum({{of_pores.begin(), dim}});
        partition->restrict_to(*grid, all.begin(), dim, force.begin());
        force += of_pores;
      }
    else
      partition->restrict_to(*grid, all.begin(), dim, force.begin());
  }


  template <int dim>
  void
  RankPart<dim>::moved(MaterialPoints<dim> &whole)
  {
    exchange.send_home(*partition);
    exchange.gather_places(whole);
  }


  template <int dim>
  void
  RankPart<dim>::complete(MaterialPoints<dim> &whole, NodalState &all) const
  {
    exchange.gather(whole);
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
  void
  check_for_ranks(const Case<dim> &the_case)
  {
    const unsigned int n =
      Utilities::MPI::n_mpi_processes(the_case.grid.communicator());
    if (n == 1)
      return;
    const Parameters &p = the_case.parameters;
    const auto refuse = [&](const std::string &path, const std::string &what) {
      throw UserError(path,
                      what + ", and the run is on " + std::to_string(n) +
                        " ranks",
                      "one rank for it, for now");
    };
    if (p.time.scheme != Scheme::newmark)
      refuse("Time stepping/Scheme",
             "is " + std::string(name_of(p.time.scheme)));
    if (p.newton.tangent != Tangent::consistent)
      refuse("Newton/Tangent", "is " + std::string(name_of(p.newton.tangent)));
    // Both look at soil beyond what a rank sees.
    if (p.mapping.volumetric_strain != VolumetricStrain::standard)
      refuse("Kinematics and mapping/Volumetric strain",
             "is " + std::string(name_of(p.mapping.volumetric_strain)));
    for (const MaterialParameters &material : p.materials)
      if (material.regularisation == Regularisation::nonlocal)
        refuse("Materials/" + material.name + "/Regularisation",
               "is " + std::string(name_of(Regularisation::nonlocal)));
    if (!p.walls.empty())
      refuse("Walls/Names", "there are walls off the grid");
    if (!p.tractions.empty())
      refuse("Tractions/Names", "there are tractions");
    if (!p.load_programmes.empty())
      refuse("Load programmes/Names", "there are load programmes");
    if (the_case.flow.is_used())
      refuse("Outflow/Names", "soil flows in or out");
  }


  template <int dim>
  std::unique_ptr<RankPart<dim>>
  make_rank_part(const Case<dim> &the_case, const MaterialPoints<dim> &points)
  {
    check_for_ranks(the_case);
    if (Utilities::MPI::n_mpi_processes(the_case.grid.communicator()) == 1)
      return nullptr;
    return std::make_unique<RankPart<dim>>(the_case, points);
  }


  template void
  check_for_ranks(const Case<2> &);
  template void
  check_for_ranks(const Case<3> &);
  template class RankPart<2>;
  template class RankPart<3>;
  template std::unique_ptr<RankPart<2>>
  make_rank_part(const Case<2> &, const MaterialPoints<2> &);
  template std::unique_ptr<RankPart<3>>
  make_rank_part(const Case<3> &, const MaterialPoints<3> &);
} // namespace Waker
