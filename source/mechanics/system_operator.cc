// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/vector_memory.templates.h>

#include <waker/mechanics/shared_vector.h>
#include <waker/mechanics/system_operator.h>

#include <algorithm>
#include <cmath>

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


  LinearSolver::LinearSolver(const unsigned int  n_dofs,
                             const NodeExchange &ranks)
    : gmres(ranks)
    , ranks(&ranks)
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
  }


  namespace
  {
    /// x and b may be vectors that ranks share.
    /// @return has it converged, without a sign that A is not definite?
    template <typename Vector, typename Preconditioner>
    bool
    conjugate_gradients(const Operator       &A,
                        Vector               &x,
                        const Vector         &b,
                        const Preconditioner &preconditioner,
                        ReductionControl     &control)
    {
      SolverCG<Vector> cg(control);
      try
        {
          cg.solve(A, x, b, preconditioner);
        }
      catch (const SolverControl::NoConvergence &)
        {
          return false; // GMRES will try
        }
      return x * b > 0.;
    }
  } // namespace


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
    const bool is_symmetric = ranks->largest(A.is_symmetric() ? 0. : 1.) == 0.;
    if (is_symmetric)
      {
        ReductionControl control(
          max_iterations, 1e-300, tolerance, false, false);
        if (ranks->is_one_rank())
          report.converged = conjugate_gradients(A, x, b, jacobi, control);
        else
          {
            SharedVector shared_x(*ranks), shared_b(*ranks);
            shared_x.reinit(x);
            shared_b.reinit(b, true);
            // Equations of others, and those that do not exist, have none.
            const double *const inverse = jacobi.get_vector().begin();
            for (unsigned int i = 0; i < b.locally_owned_size(); ++i)
              shared_b.begin()[i] = inverse[i] != 0. ? b.begin()[i] : 0.;
            report.converged =
              conjugate_gradients(A, shared_x, shared_b, jacobi, control);
            x = shared_x;
          }
        report.iterations = control.last_step();
        if (report.converged)
          return report;
      }
    LinearReport last = gmres.solve(A, x, b, tolerance, max_iterations);
    last.iterations += report.iterations;
    return last;
  }


  template class SystemOperator<2>;
  template class SystemOperator<3>;
} // namespace Waker
