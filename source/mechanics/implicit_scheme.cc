// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/implicit_scheme.h>

namespace Waker
{
  template <int dim>
  ImplicitScheme<dim>::ImplicitScheme(const SchemeInput<dim> &input,
                                      const LinearMethod      method)
    : in(input)
    , reached(in.grid)
    , held(in)
    , newton(in.grid, in.fixities, in.newton, in.full_node_mass, method)
  {
    resistances = held.supports;
    resistances.insert(resistances.begin(), &held.soil);
  }


  template <int dim>
  StepReport<dim>
  ImplicitScheme<dim>::solve(const MaterialPoints<dim> &points,
                             const double               t,
                             const double               dt,
                             NodalState                &nodes)
  {
    reached.reinit(nodes.mass);
    in.find_motion(t, dt, removed_increments);
    for (Resistance<dim> *const resistance : resistances)
      resistance->begin(points, nodes, t, dt);

    nodes.increment             = 0.;
    const ResidualTerms terms   = begin(t, dt, nodes);
    const auto         &removed = in.fixities.removed_list();
    for (std::size_t k = 0; k < removed.size(); ++k)
      nodes.increment.begin()[removed[k]] = removed_increments[k];

    const NewtonReport solved = newton.solve(resistances, terms, nodes);
    move_nodes(dt, nodes);

    StepReport<dim> report;
    report.converged         = solved.converged;
    report.newton_iterations = solved.iterations;
    report.linear_iterations = solved.linear_iterations;
    report.residuals         = solved.residuals;
    return report;
  }


  template <int dim>
  void
  ImplicitScheme<dim>::to_points(const double         t,
                                 const double         dt,
                                 NodalState          &nodes,
                                 MaterialPoints<dim> &points,
                                 StepReport<dim>     &report)
  {
    using Role = typename Resistance<dim>::Role;
    Tensor<1, dim> reaction;
    ResistanceWork internal, supports, pushed, lost;
    for (Resistance<dim> *const resistance : resistances)
      {
        reaction += resistance->accept(nodes.increment, points);
        const ResistanceWork work = resistance->work(nodes.increment);
        const Role           role = resistance->role();
        if (role != Role::support)
          internal += work;
        if (role == Role::support || role == Role::load)
          supports += work;
        if (role == Role::support)
          pushed += work;
        if (role == Role::remedy)
          lost += work;
      }
    const StressReport &stress = held.soil.report();
    report.mean_plastic_strain = stress.plastic_strain;
    report.dissipation         = stress.dissipation;
    report.elastic_energy      = stress.elastic_energy;

    move_points(dt, nodes, points, report);
    add_works(t, dt, nodes, internal, report);
    report.reaction += reaction;
    // What friction takes from the body is no work of a support.
    report.friction = supports.lost;
    report.support_work += supports.mean() + supports.lost;
    // The force of the supports at the start is no part of what add_works()
    // takes for the forces there.
    report.mapping_loss += 0.5 * pushed.start - lost.mean();
    report.sum(in.grid.exchange(), points.n_points());
  }


  template class ImplicitScheme<2>;
  template class ImplicitScheme<3>;
} // namespace Waker
