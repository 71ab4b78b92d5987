// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/newton.h>
#include <waker/nodes/operator_sum.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace Waker
{
  namespace
  {
    /// Linear residuals aim at this share of Newton's tolerance.
    constexpr double linear_margin = 0.3;

    /// A residual below this share of the terms it is made of is round-off.
    constexpr double round_off = 1e-13;

    /// Added to a factorised stiffness, relative to its diagonal. Small next to
    /// the softest motion that counts, the bending of a slender body: 1e-7.
    constexpr double relative_shift = 1e-10;

    /// More of the residual than this in motions without stiffness is no
    /// matter of hardly touched nodes.
    constexpr double unsolvable_limit = 1e-4;


    /// A stiffness that conjugate gradients may try, though it is only nearly
    /// symmetric.
    class SymmetricOperator : public Operator
    {
    public:
      explicit SymmetricOperator(const Operator &A)
        : A(A)
      {}

      void
      vmult(NodalVector &dst, const NodalVector &src) const override
      {
        A.vmult(dst, src);
      }

      void
      add_diagonal(NodalVector &diagonal) const override
      {
        A.add_diagonal(diagonal);
      }

      bool
      is_symmetric() const override
      {
        return true;
      }

    private:
      const Operator &A;
    };
  } // namespace


  template <int dim>
  NewtonSolver<dim>::NewtonSolver(const Weights<dim>        &weights,
                                  const Fixities<dim>       &fixities,
                                  const NewtonParameters    &parameters,
                                  const double               full_node_mass,
                                  const Springs             &springs,
                                  const LinearMethod         method,
                                  const Walls<dim>          *walls,
                                  const GhostStiffness<dim> *ghost)
    : fixities(&fixities)
    , parameters(parameters)
    , full_node_mass(full_node_mass)
    , springs(springs)
    , consistent(weights)
    , double_mapped(weights)
    , linear_solver(weights.background_grid().n_dofs())
    , reached(weights.background_grid())
    , R(weights.background_grid().n_dofs())
    , correction(weights.background_grid().n_dofs())
    , method(method)
    , walls(walls)
    , wall_force(walls != nullptr ? weights.background_grid().n_dofs() : 0)
    , ghost(ghost)
  {
    if (dim == 2 && method == LinearMethod::direct)
      direct_solver =
        std::make_unique<DirectSolver<dim>>(weights.background_grid());
  }


  template <int dim>
  double
  NewtonSolver<dim>::residual(const Inertia             &inertia,
                              const std::vector<double> &spring_targets,
                              const NodalState          &nodes)
  {
    const double *const external = nodes.external_force.begin();
    const double *const internal = nodes.internal_force.begin();
    const double *const u        = nodes.increment.begin();
    const double *const q =
      inertia.history != nullptr ? inertia.history->begin() : nullptr;
    double *const r = R.begin();

    for (const auto &run : reached)
      for (std::size_t i = run.begin; i < run.end; ++i)
        for (unsigned int c = 0; c < dim; ++c)
          {
            const std::size_t dof = dim * i + c;
            r[dof] =
              inertia.ramp * (inertia.load * external[dof] - internal[dof]);
            if (q != nullptr)
              r[dof] -= nodes.mass[i] * (inertia.factor * u[dof] - q[dof]);
          }
    for (std::size_t k = 0; k < springs.dofs.size(); ++k)
      {
        const unsigned int dof = springs.dofs[k];
        if (nodes.mass[dof / dim] > 0.)
          r[dof] -= springs.stiffness[k] * (u[dof] - spring_targets[k]);
      }
    for (const unsigned int dof : fixities->removed_list())
      r[dof] = 0.;

    const double               inverse_full = 1. / full_node_mass;
    const unsigned char *const removed      = fixities->removed().data();
    double                     sum = 0., terms = 0.;
    reference = 0.;
    for (const auto &run : reached)
      for (std::size_t i = run.begin; i < run.end; ++i)
        {
          // Nothing of a node without mass counts.
          const double mass  = nodes.mass[i];
          const double share = std::min(1., mass * inverse_full);
          for (unsigned int c = 0; c < dim; ++c)
            {
              const std::size_t dof  = dim * i + c;
              const double      load = inertia.load * external[dof];
              const double square = load * load + internal[dof] * internal[dof];
              const double ku     = mass * inertia.factor * u[dof];
              const double mq     = q != nullptr ? mass * q[dof] : 0.;
              terms += share * (square + ku * ku + mq * mq);
              if (!removed[dof])
                {
                  const double inertial = q != nullptr ? ku - mq : 0.;
                  sum += share * r[dof] * r[dof];
                  reference += share * (square + inertial * inertial);
                }
            }
        }
    // With walls the internal force is less theirs, and may be nothing else.
    if (walls != nullptr)
      for (const auto &run : reached)
        for (std::size_t i = run.begin; i < run.end; ++i)
          for (unsigned int c = 0; c < dim; ++c)
            {
              const double force = wall_force.begin()[dim * i + c];
              const double square =
                std::min(1., nodes.mass[i] * inverse_full) * force * force;
              terms += square;
              if (!removed[dim * i + c])
                reference += square;
            }
    // Not a number is not small: comparisons with it are false, and a residual
    // of 0 would pass for converged.
    if (!std::isfinite(sum) || !std::isfinite(terms))
      return std::numeric_limits<double>::infinity();
    return sum > round_off * round_off * terms ? std::sqrt(sum / reference)
                                               : 0.;
  }


  template <int dim>
  double
  NewtonSolver<dim>::norm_of_residual(const std::vector<double> &mass) const
  {
    const double *const r   = R.begin();
    double              sum = 0.;
    for (const auto &run : reached)
      for (std::size_t i = run.begin; i < run.end; ++i)
        for (unsigned int c = 0; c < dim; ++c)
          sum += std::min(1., mass[i] / full_node_mass) * r[dim * i + c] *
                 r[dim * i + c];
    return std::sqrt(sum / reference);
  }


  template <int dim>
  LinearReport
  NewtonSolver<dim>::solve_linear(const Operator   &stiffness,
                                  const Inertia    &inertia,
                                  const NodalState &nodes,
                                  const bool        first,
                                  const double      norm)
  {
    std::optional<OperatorSum<Walls<dim>>> walled;
    if (walls != nullptr)
      walled.emplace(stiffness, *walls);
    const Operator &soil =
      walled ? static_cast<const Operator &>(*walled) : stiffness;
    std::optional<OperatorSum<GhostStiffness<dim>>> ghosted;
    if (ghost != nullptr)
      ghosted.emplace(soil, *ghost);
    const SystemOperator system(ghosted
                                  ? static_cast<const Operator &>(*ghosted)
                                  : soil,
                                inertia.ramp,
                                inertia.factor,
                                nodes.mass,
                                fixities->removed_list(),
                                springs);
    if (direct_solver)
      {
        direct_solver->factorise(system, relative_shift);
        direct_solver->solve(correction, R);
        return {1, true};
      }
    // The first tangent's diagonal preconditions all systems of the step.
    if (first)
      linear_solver.prepare(system);
    // A correction need not be better than the convergence it leads to.
    const double reduction =
      std::min(std::max(parameters.linear_tolerance,
                        linear_margin * parameters.tolerance / norm),
               0.5);
    if (method == LinearMethod::direct)
      return linear_solver.solve(SymmetricOperator(system),
                                 correction,
                                 R,
                                 reduction,
                                 parameters.maximum_linear_iterations);
    return linear_solver.solve(
      system, correction, R, reduction, parameters.maximum_linear_iterations);
  }


  template <int dim>
  NewtonReport
  NewtonSolver<dim>::solve(const MaterialPoints<dim> &points,
                           const Inertia             &inertia,
                           const std::vector<double> &spring_targets,
                           StressUpdate<dim>         &stress_update,
                           NodalState                &nodes)
  {
    const bool      use_consistent = parameters.tangent == "consistent";
    const Operator &stiffness =
      use_consistent ? static_cast<const Operator &>(consistent)
                     : static_cast<const Operator &>(double_mapped);
    const Weights<dim> &weights = consistent.point_weights();
    reached.reinit(nodes.mass);
    R = 0.;
    NewtonReport report;
    while (true)
      {
        stress_update.evaluate(points,
                               weights,
                               nodes.increment,
                               nodes.internal_force);
        if (walls != nullptr)
          {
            wall_force = 0.;
            walls->add_internal_force(nodes.increment, wall_force);
            nodes.internal_force += wall_force;
          }
        if (ghost != nullptr)
          ghost->vmult_add(nodes.internal_force, nodes.increment);
        const double norm = residual(inertia, spring_targets, nodes);
        report.residuals.push_back(norm);
        if (norm <= parameters.tolerance)
          {
            report.converged = true;
            return report;
          }
        // Not a number, hopeless, or out of patience: the step is too long.
        if (!(norm < 1e6) || report.iterations == parameters.maximum_iterations)
          return report;

        if (use_consistent)
          consistent.reinit(stress_update, points);
        else
          double_mapped.reinit(stress_update, points);
        const LinearReport linear =
          solve_linear(stiffness, inertia, nodes, report.iterations == 0, norm);
        report.linear_iterations += linear.iterations;
        ++report.iterations;
        if (direct_solver && norm < unsolvable_limit &&
            norm_of_residual(nodes.mass) <= parameters.tolerance)
          {
            report.residuals.push_back(norm_of_residual(nodes.mass));
            report.converged = true;
            return report;
          }
        nodes.increment += correction;
      }
  }


  template class NewtonSolver<2>;
  template class NewtonSolver<3>;
} // namespace Waker
