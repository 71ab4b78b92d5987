// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <waker/mechanics/system_operator.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  template <int dim>
  Springs
  make_springs(const Fixities<dim> &fixities,
               const double         modulus,
               const double         h)
  {
    Springs springs;
    for (const auto &penalty : fixities.penalties())
      {
        springs.dofs.push_back(penalty.dof);
        springs.stiffness.push_back(penalty.factor * modulus *
                                    std::pow(h, dim - 2));
      }
    return springs;
  }


  template Springs
  make_springs(const Fixities<2> &, const double, const double);
  template Springs
  make_springs(const Fixities<3> &, const double, const double);


  SystemOperator::SystemOperator(const Operator                  &stiffness,
                                 const double                     ramp,
                                 const double                     inertia,
                                 const std::vector<double>       &mass,
                                 const std::vector<unsigned int> &removed,
                                 const Springs                   &springs)
    : stiffness(&stiffness)
    , ramp(ramp)
    , inertia(inertia)
    , mass(&mass)
    , removed(&removed)
    , springs(&springs)
  {}


  void
  SystemOperator::vmult(NodalVector &dst, const NodalVector &src) const
  {
    stiffness->vmult(dst, src);
    double *const       y       = dst.begin();
    const double *const x       = src.begin();
    const std::size_t   n_nodes = mass->size();
    const unsigned int  dim     = dst.locally_owned_size() / n_nodes;
    const double *const m       = mass->data();
    if (dim == 2)
      for (std::size_t i = 0; i < n_nodes; ++i)
        for (unsigned int c = 0; c < 2; ++c)
          y[2 * i + c] = ramp * y[2 * i + c] + inertia * m[i] * x[2 * i + c];
    else
      for (std::size_t i = 0; i < n_nodes; ++i)
        for (unsigned int c = 0; c < 3; ++c)
          y[3 * i + c] = ramp * y[3 * i + c] + inertia * m[i] * x[3 * i + c];
    for (std::size_t k = 0; k < springs->dofs.size(); ++k)
      y[springs->dofs[k]] += springs->stiffness[k] * x[springs->dofs[k]];
    for (const unsigned int dof : *removed)
      y[dof] = 0.;
  }


  void
  SystemOperator::add_diagonal(NodalVector &diagonal) const
  {
    NodalVector &K = stiffness_diagonal;
    K.reinit(diagonal);
    stiffness->add_diagonal(K);
    double *const      y   = diagonal.begin();
    const unsigned int dim = diagonal.locally_owned_size() / mass->size();
    for (std::size_t i = 0; i < mass->size(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        y[dim * i + c] += ramp * K.begin()[dim * i + c] + inertia * (*mass)[i];
    for (std::size_t k = 0; k < springs->dofs.size(); ++k)
      y[springs->dofs[k]] += springs->stiffness[k];
    for (const unsigned int dof : *removed)
      y[dof] = 0.;
  }


  LinearSolver::LinearSolver(const unsigned int n_dofs)
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


  LinearReport
  LinearSolver::solve(const Operator    &A,
                      NodalVector       &x,
                      const NodalVector &b,
                      const double       tolerance,
                      const unsigned int max_iterations)
  {
    x = 0.;
    LinearReport report;
    if (A.is_symmetric())
      {
        ReductionControl control(
          max_iterations, 1e-300, tolerance, false, false);
        SolverCG<NodalVector> cg(control);
        try
          {
            cg.solve(A, x, b, jacobi);
            report.converged = true;
          }
        catch (const SolverControl::NoConvergence &)
          {
            // GMRES will try.
          }
        report.iterations = control.last_step();
        const double work = x * b;
        if (report.converged && work > 0.)
          return report;
      }
    LinearReport last = gmres.solve(A, x, b, tolerance, max_iterations);
    last.iterations += report.iterations;
    return last;
  }
} // namespace Waker
