// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/multilevel.h>
#include <waker/mechanics/newton.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Waker
{
  namespace
  {
    /// Linear residuals aim at this share of Newton's tolerance.
    constexpr double linear_margin = 0.3;

    /// A residual below this share of the parts it is made of is round-off.
    constexpr double round_off = 1e-13;

    /// Added to a factorised stiffness, relative to its diagonal. Small next to
    /// the softest motion that counts, the bending of a slender body: 1e-7.
    constexpr double relative_shift = 1e-10;

    /// Added to that of a linear body, whose iterations take it away again: all
    /// but a share s / a of a motion whose stiffness is a of its diagonal. The
    /// softest ones have an `a` of the square of cell size over length. In
    /// space bodies have more cells along them, and s is what products of
    /// single precision bear.
    template <int dim>
    constexpr double elastic_shift = dim == 2 ? 1e-6 : 1e-7;

    /// Corrections of bodies whose forces have corners are halved up to so many
    /// times where they make the residual larger, from this iteration on: the
    /// first ones find out what touches what.
    constexpr unsigned int most_halvings = 4, free_iterations = 4;

    /// More of the residual than this in motions without stiffness is no
    /// matter of hardly touched nodes.
    constexpr double unsolvable_limit = 1e-4;


    template <int dim>
    bool
    has_role(const Resistances<dim>              &resistances,
             const typename Resistance<dim>::Role role)
    {
      return std::any_of(resistances.begin(),
                         resistances.end(),
                         [&](const Resistance<dim> *const r) {
                           return r->role() == role;
                         });
    }
  } // namespace


  template <int dim>
  NewtonSolver<dim>::NewtonSolver(const BackgroundGrid<dim> &grid,
                                  const Fixities<dim>       &fixities,
                                  const NewtonParameters    &parameters,
                                  const double               full_node_mass,
                                  const LinearMethod         method)
    : fixities(&fixities)
    , parameters(parameters)
    , full_node_mass(full_node_mass)
    , method(method)
    , linear_solver(grid.n_dofs(),
                    grid.exchange(),
                    dim == 3 && method != LinearMethod::krylov
                      ? std::make_unique<Multilevel<dim>>(grid)
                      : nullptr)
    , reached(grid)
    , R(grid.n_dofs())
    , correction(grid.n_dofs())
  {
    if (dim == 2 && method != LinearMethod::krylov)
      direct_solver = std::make_unique<DirectSolver<dim>>(grid);
  }


  template <int dim>
  void
  NewtonSolver<dim>::set_forces(const Resistances<dim> &resistances,
                                NodalState             &nodes)
  {
    using Role           = typename Resistance<dim>::Role;
    nodes.internal_force = 0.;
    if (load_force.size() > 0)
      load_force = 0.;
    if (support_force.size() > 0)
      support_force = 0.;
    const auto add = [&](const Role role, NodalVector &force) {
      for (Resistance<dim> *const resistance : resistances)
        if (resistance->role() == role)
          resistance->add_force(nodes.increment, force);
    };
    add(Role::body, nodes.internal_force);
    add(Role::load, load_force);
    if (load_force.size() > 0)
      nodes.internal_force += load_force;
    add(Role::remedy, nodes.internal_force);
    add(Role::support, support_force);
    const NodeExchange &ranks = reached.ranks();
    for (NodalVector *const force :
         {&nodes.internal_force, &load_force, &support_force})
      if (force->size() > 0)
        ranks.sum({{force->begin(), dim}});
  }


  template <int dim>
  double
  NewtonSolver<dim>::residual(const ResidualTerms &terms,
                              const NodalState    &nodes)
  {
    const double *const external = nodes.external_force.begin();
    const double *const internal = nodes.internal_force.begin();
    const double *const u        = nodes.increment.begin();
    const double *const q =
      terms.history != nullptr ? terms.history->begin() : nullptr;
    double *const r = R.begin();

    for (const auto &run : reached)
      for (std::size_t i = run.begin; i < run.end; ++i)
        for (unsigned int c = 0; c < dim; ++c)
          {
            const std::size_t dof = dim * i + c;
            r[dof] = terms.ramp * (terms.load * external[dof] - internal[dof]);
            if (q != nullptr)
              r[dof] -= nodes.mass[i] * (terms.factor * u[dof] - q[dof]);
          }
    if (support_force.size() > 0)
      R -= support_force;
    for (const unsigned int dof : fixities->removed_list())
      r[dof] = 0.;

    const double               inverse_full = 1. / full_node_mass;
    const unsigned char *const removed      = fixities->removed().data();
    double                     sum = 0., parts = 0., loads = 0.;
    reference = 0.;
    for (const auto &run : reached.owned())
      for (std::size_t i = run.begin; i < run.end; ++i)
        {
          // Nothing of a node without mass counts.
          const double mass  = nodes.mass[i];
          const double share = std::min(1., mass * inverse_full);
          for (unsigned int c = 0; c < dim; ++c)
            {
              const std::size_t dof  = dim * i + c;
              const double      load = terms.load * external[dof];
              const double square = load * load + internal[dof] * internal[dof];
              const double ku     = mass * terms.factor * u[dof];
              const double mq     = q != nullptr ? mass * q[dof] : 0.;
              parts += share * (square + ku * ku + mq * mq);
              if (!removed[dof])
                {
                  const double inertial = q != nullptr ? ku - mq : 0.;
                  sum += share * r[dof] * r[dof];
                  loads += share * load * load;
                  reference += share * (square + inertial * inertial);
                }
            }
        }
    // The internal force is less that of the loads, and may be nothing else.
    if (load_force.size() > 0)
      for (const auto &run : reached.owned())
        for (std::size_t i = run.begin; i < run.end; ++i)
          for (unsigned int c = 0; c < dim; ++c)
            {
              const double force = load_force.begin()[dim * i + c];
              const double square =
                std::min(1., nodes.mass[i] * inverse_full) * force * force;
              parts += square;
              if (!removed[dim * i + c])
                {
                  loads += square;
                  reference += square;
                }
            }
    double sums[] = {sum, parts, loads, reference};
    reached.ranks().sum(sums, 4);
    sum       = sums[0];
    parts     = sums[1];
    loads     = sums[2];
    reference = sums[3];
    // A body that only its supports push has no other forces than theirs.
    if (q == nullptr && loads == 0.)
      reference = parts;
    if (support_force.size() > 0)
      {
        double supports = 0.;
        for (const auto &run : reached.owned())
          for (std::size_t i = run.begin; i < run.end; ++i)
            for (unsigned int c = 0; c < dim; ++c)
              if (const double force = support_force.begin()[dim * i + c];
                  !removed[dim * i + c])
                supports +=
                  std::min(1., nodes.mass[i] * inverse_full) * force * force;
        reference = std::max(reference, reached.ranks().sum(supports));
      }
    // Not a number is not small: comparisons with it are false, and a residual
    // of 0 would pass for converged.
    if (!std::isfinite(sum) || !std::isfinite(parts))
      return std::numeric_limits<double>::infinity();
    return sum > round_off * round_off * parts ? std::sqrt(sum / reference)
                                               : 0.;
  }


  template <int dim>
  double
  NewtonSolver<dim>::norm_of_residual(const std::vector<double> &mass) const
  {
    const double *const r   = R.begin();
    double              sum = 0.;
    for (const auto &run : reached.owned())
      for (std::size_t i = run.begin; i < run.end; ++i)
        for (unsigned int c = 0; c < dim; ++c)
          sum += std::min(1., mass[i] / full_node_mass) * r[dim * i + c] *
                 r[dim * i + c];
    return std::sqrt(reached.ranks().sum(sum) / reference);
  }


  template <int dim>
  LinearReport
  NewtonSolver<dim>::solve_linear(const Resistances<dim> &resistances,
                                  const ResidualTerms    &terms,
                                  const NodalState       &nodes,
                                  const bool              first,
                                  const double            norm)
  {
    const SystemOperator<dim> system(resistances,
                                     terms.ramp,
                                     terms.factor,
                                     nodes.mass,
                                     reached,
                                     fixities->removed_list());
    const bool                is_elastic = method == LinearMethod::elastic;
    if (direct_solver)
      {
        if (!is_elastic)
          direct_solver->factorise(system, relative_shift);
        else if (first)
          direct_solver->factorise(system,
                                   elastic_shift<dim>,
                                   MatrixKind::definite);
        direct_solver->solve(correction, R);
        return {1, true};
      }
    // The first tangent's diagonal preconditions all systems of the step.
    if (first)
      linear_solver.prepare(system);
    // A correction need not be better than the convergence it leads to.
    const double reduction =
      is_elastic
        ? parameters.linear_tolerance
        : std::min(std::max(parameters.linear_tolerance,
                            linear_margin * parameters.tolerance / norm),
                   0.5);
    const auto solve = [&](const Operator &A) {
      return linear_solver.solve(
        A, correction, R, reduction, parameters.maximum_linear_iterations);
    };
    if (method == LinearMethod::krylov)
      return solve(system);
    return solve(
      StaticOperator(system, R, is_elastic ? elastic_shift<dim> : 0.));
  }


  template <int dim>
  NewtonReport
  NewtonSolver<dim>::solve(const Resistances<dim> &resistances,
                           const ResidualTerms    &terms,
                           NodalState             &nodes)
  {
    using Role        = typename Resistance<dim>::Role;
    const auto n_dofs = [&](const Role role) {
      return has_role(resistances, role) ? R.size() : 0;
    };
    load_force.reinit(n_dofs(Role::load));
    support_force.reinit(n_dofs(Role::support));
    reached.reinit(nodes.mass);
    R = 0.;
    NewtonReport report;
    const bool   may_cycle = have_corners(resistances);
    double       last = std::numeric_limits<double>::infinity(), share = 1.;
    unsigned int n_halvings = 0;
    while (true)
      {
        set_forces(resistances, nodes);
        const double norm = residual(terms, nodes);
        if (may_cycle && report.iterations > free_iterations &&
            !(norm < last) && n_halvings < most_halvings)
          {
            share *= 0.5;
            ++n_halvings;
            nodes.increment.add(-share, correction);
            continue;
          }
        last       = norm;
        share      = 1.;
        n_halvings = 0;
        report.residuals.push_back(norm);
        if (norm <= parameters.tolerance)
          {
            report.converged = true;
            return report;
          }
        // Not a number, hopeless, or out of patience: the step is too long.
        if (!(norm < 1e6) || report.iterations == parameters.maximum_iterations)
          return report;

        const bool first = report.iterations == 0;
        if (first || method != LinearMethod::elastic)
          for (Resistance<dim> *const resistance : resistances)
            resistance->linearise();
        const LinearReport linear =
          solve_linear(resistances, terms, nodes, first, norm);
        report.linear_iterations += linear.iterations;
        report.strong_iterations += linear.strong_iterations;
        report.strong_failures += linear.strong_failed;
        ++report.iterations;
        if (direct_solver && norm < unsolvable_limit &&
            norm_of_residual(nodes.mass) <= parameters.tolerance)
          {
            report.residuals.push_back(norm_of_residual(nodes.mass));
            report.converged = true;
            return report;
          }
        reached.ranks().send_to_others({{correction.begin(), dim}});
        nodes.increment += correction;
      }
  }


  template class NewtonSolver<2>;
  template class NewtonSolver<3>;
} // namespace Waker
