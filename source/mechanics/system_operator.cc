// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/vector_memory.templates.h>

#include <waker/mechanics/shared_vector.h>
#include <waker/mechanics/system_operator.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Waker
{
  template <int dim>
  SystemOperator<dim>::SystemOperator(const Resistances<dim>    &resistances,
                                      const double               ramp,
                                      const double               inertia,
                                      const std::vector<double> &mass,
                                      const ReachedNodes        &reached,
                                      const std::vector<unsigned int> &removed)
    : resistances(&resistances)
    , ramp(ramp)
    , inertia(inertia)
    , mass(&mass)
    , reached(&reached)
    , removed(&removed)
  {}


  template <int dim>
  void
  SystemOperator<dim>::vmult(NodalVector &dst, const NodalVector &src) const
  {
    using Role                = typename Resistance<dim>::Role;
    const NodeExchange &ranks = reached->ranks();
    const NodalVector  *all   = &src;
    if (!ranks.is_one_rank())
      {
        everywhere = src;
        ranks.send_to_others({{everywhere.begin(), dim}});
        all = &everywhere;
      }
    dst = 0.;
    for (const Resistance<dim> *const resistance : *resistances)
      if (resistance->role() != Role::support)
        resistance->vmult_add(dst, *all);
    ranks.add_to_owners({{dst.begin(), dim}});
    double *const       y = dst.begin();
    const double *const x = src.begin();
    const double *const m = mass->data();
    for (const auto &run : *reached)
      for (std::size_t i = run.begin; i < run.end; ++i)
        for (unsigned int c = 0; c < dim; ++c)
          y[dim * i + c] =
            ramp * y[dim * i + c] + inertia * m[i] * x[dim * i + c];
    if (ranks.is_one_rank())
      add_supports(dst, src);
    else if (has_supports())
      {
        // Of their own: their forces are not multiplied by the ramp.
        of_supports.reinit(dst);
        add_supports(of_supports, everywhere);
        ranks.add_to_owners({{of_supports.begin(), dim}});
        dst += of_supports;
      }
    for (const unsigned int dof : *removed)
      y[dof] = 0.;
  }


  template <int dim>
  bool
  SystemOperator<dim>::has_supports() const
  {
    return std::any_of(resistances->begin(),
                       resistances->end(),
                       [](const Resistance<dim> *const resistance) {
                         return resistance->role() ==
                                Resistance<dim>::Role::support;
                       });
  }


  template <int dim>
  void
  SystemOperator<dim>::add_supports(NodalVector       &dst,
                                    const NodalVector &src) const
  {
    for (const Resistance<dim> *const resistance : *resistances)
      if (resistance->role() == Resistance<dim>::Role::support)
        resistance->vmult_add(dst, src);
  }


  template <int dim>
  void
  SystemOperator<dim>::add_diagonal(NodalVector &diagonal) const
  {
    using Role     = typename Resistance<dim>::Role;
    NodalVector &K = stiffness_diagonal;
    K.reinit(diagonal);
    for (const Resistance<dim> *const resistance : *resistances)
      if (resistance->role() != Role::support)
        resistance->add_diagonal(K);
    const NodeExchange &ranks = reached->ranks();
    ranks.add_to_owners({{K.begin(), dim}});
    double *const y = diagonal.begin();
    for (std::size_t i = 0; i < mass->size(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        y[dim * i + c] += ramp * K.begin()[dim * i + c] + inertia * (*mass)[i];
    ranks.clear_others({y, dim});
    for (const Resistance<dim> *const resistance : *resistances)
      if (resistance->role() == Role::support)
        resistance->add_diagonal(diagonal);
    ranks.add_to_owners({{y, dim}});
    for (const unsigned int dof : *removed)
      y[dof] = 0.;
  }


  template <int dim>
  void
  SystemOperator<dim>::add_entries(MatrixEntries &entries) const
  {
    Assert(ramp == 1. && inertia == 0., ExcNotImplemented());
    for (const Resistance<dim> *const resistance : *resistances)
      resistance->add_entries(entries);
  }


  template <int dim>
  bool
  SystemOperator<dim>::is_symmetric() const
  {
    return std::all_of(resistances->begin(),
                       resistances->end(),
                       [](const Resistance<dim> *const resistance) {
                         return resistance->is_symmetric();
                       });
  }


  StaticOperator::StaticOperator(const Operator    &A,
                                 const NodalVector &like,
                                 const double       s)
    : A(A)
  {
    if (s == 0.)
      return;
    shift.reinit(like);
    A.add_diagonal(shift);
    for (double &entry : shift)
      entry = s * std::abs(entry);
  }


  void
  StaticOperator::vmult(NodalVector &dst, const NodalVector &src) const
  {
    A.vmult(dst, src);
    for (unsigned int i = 0; i < shift.locally_owned_size(); ++i)
      dst.begin()[i] += shift.begin()[i] * src.begin()[i];
  }


  namespace
  {
    /// Iterations with the diagonal that take as long as to set up the stronger
    /// preconditioner: 200 with 5,000 equations, 160 with 38,000, 100 with
    /// 300,000 (doc/verification/static_steps.md).
    constexpr unsigned int patience = 200;


    /// How many are to be expected of a body in space, about as long as wide:
    /// as many as it has equations along an edge, for each digit (same page).
    double
    expected_iterations(const double n_equations, const double tolerance)
    {
      return std::cbrt(n_equations) * std::log10(1. / tolerance);
    }
  } // namespace


  LinearSolver::LinearSolver(const unsigned int              n_dofs,
                             const NodeExchange             &ranks,
                             std::unique_ptr<Preconditioner> strong)
    : gmres(ranks)
    , ranks(&ranks)
    , strong(std::move(strong))
  {
    jacobi.get_vector().reinit(n_dofs);
  }


  void
  LinearSolver::prepare(const Operator &A)
  {
    NodalVector &diagonal = jacobi.get_vector();
    diagonal              = 0.;
    A.add_diagonal(diagonal);
    // A zero stands for an equation that does not exist; a softening node may
    // have a negative diagonal, which would spoil the preconditioner.
    for (double &entry : diagonal)
      entry = entry != 0. ? 1. / std::abs(entry) : 0.;
    gmres.prepare(diagonal);
    if (strong)
      {
        strong->clear();
        state       = Strong::later;
        n_diagonal  = 0;
        n_equations = ranks->sum(
          std::count_if(diagonal.begin(),
                        diagonal.end(),
                        [](const double entry) { return entry != 0.; }));
      }
  }


  template <typename M>
  LinearReport
  LinearSolver::conjugate_gradients(const Operator    &A,
                                    NodalVector       &x,
                                    const NodalVector &b,
                                    const M           &preconditioner,
                                    SolverControl     &control) const
  {
    const auto solve = [&](auto &x, const auto &b) {
      SolverCG<std::decay_t<decltype(x)>> cg(control);
      try
        {
          cg.solve(A, x, b, preconditioner);
        }
      catch (const SolverControl::NoConvergence &)
        {
          return false; // another way will be tried
        }
      return x * b > 0.; // else A is not definite
    };
    LinearReport report;
    if (ranks->is_one_rank())
      report.converged = solve(x, b);
    else
      {
        SharedVector shared_x(*ranks), shared_b(*ranks);
        shared_x.reinit(x, true);
        shared_x = x;
        shared_b.reinit(b, true);
        // Equations of others, and those that do not exist, have none.
        const double *const inverse = jacobi.get_vector().begin();
        for (unsigned int i = 0; i < b.locally_owned_size(); ++i)
          shared_b.begin()[i] = inverse[i] != 0. ? b.begin()[i] : 0.;
        report.converged = solve(shared_x, shared_b);
        x                = shared_x;
      }
    report.iterations = control.last_step();
    return report;
  }


  LinearReport
  LinearSolver::solve_symmetric(const Operator    &A,
                                NodalVector       &x,
                                const NodalVector &b,
                                const double       tolerance,
                                const unsigned int max_iterations)
  {
    LinearReport report;
    const auto   add = [&](const LinearReport &part) {
      report.converged = part.converged;
      report.iterations += part.iterations;
    };
    if (state != Strong::ready)
      {
        unsigned int n = max_iterations;
        if (state == Strong::later)
          n = expected_iterations(n_equations, tolerance) > patience
                ? 0
                : std::min(n, patience - std::min(n_diagonal, patience));
        ReductionControl control(n, 1e-300, tolerance, false, false);
        add(conjugate_gradients(A, x, b, jacobi, control));
        n_diagonal += report.iterations;
        if (report.converged || state == Strong::failed || n == max_iterations)
          return report;
        state = strong->reinit(A) ? Strong::ready : Strong::failed;
        report.strong_failed = state == Strong::failed;
      }

    // From here on, or from the start if that has come to nothing.
    const double *const inverse = jacobi.get_vector().begin();
    double              square  = 0.;
    bool                is_sane = true;
    for (unsigned int i = 0; i < b.locally_owned_size(); ++i)
      {
        square += inverse[i] != 0. ? b.begin()[i] * b.begin()[i] : 0.;
        is_sane = is_sane && std::isfinite(x.begin()[i]);
      }
    if (ranks->largest(is_sane ? 0. : 1.) != 0.)
      x = 0.;
    SolverControl control(max_iterations,
                          std::max(tolerance * std::sqrt(ranks->sum(square)),
                                   1e-300),
                          false,
                          false);
    if (state == Strong::failed)
      add(conjugate_gradients(A, x, b, jacobi, control));
    else
      {
        add(conjugate_gradients(A, x, b, *strong, control));
        report.strong_iterations = control.last_step();
      }
    return report;
  }


  LinearReport
  LinearSolver::solve(const Operator    &A,
                      NodalVector       &x,
                      const NodalVector &b,
                      const double       tolerance,
                      const unsigned int max_iterations)
  {
    x = 0.;
    LinearReport report;
    // All ranks go the same way.
    if (ranks->largest(A.is_symmetric() ? 0. : 1.) == 0.)
      {
        report = solve_symmetric(A, x, b, tolerance, max_iterations);
        if (report.converged)
          return report;
      }
    const bool         is_strong = state == Strong::ready;
    const LinearReport last      = gmres.solve(
      A, x, b, tolerance, max_iterations, is_strong ? strong.get() : nullptr);
    report.converged = last.converged;
    report.iterations += last.iterations;
    report.strong_iterations += is_strong ? last.iterations : 0;
    return report;
  }


  template class SystemOperator<2>;
  template class SystemOperator<3>;
} // namespace Waker
