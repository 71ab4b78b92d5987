// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <waker/mapping/stencil.h>
#include <waker/mechanics/consistent_tangent.h>
#include <waker/mechanics/direct_solver.h>
#include <waker/mechanics/gravity_step.h>
#include <waker/mechanics/system_operator.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/nodes/operator_sum.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace Waker
{
  namespace
  {
    constexpr double relative_shift = 1e-6; // of the diagonal


    /// (1 + shift) diag K on top of K, for conjugate gradients.
    class ShiftedOperator
    {
    public:
      ShiftedOperator(const SystemOperator &system, const NodalVector &diagonal)
        : system(system)
        , diagonal(diagonal)
      {}

      void
      vmult(NodalVector &dst, const NodalVector &src) const
      {
        system.vmult(dst, src);
        for (unsigned int i = 0; i < dst.locally_owned_size(); ++i)
          dst.begin()[i] +=
            relative_shift * diagonal.begin()[i] * src.begin()[i];
      }

    private:
      const SystemOperator &system;
      const NodalVector    &diagonal;
    };


    /// In 3D: conjugate gradients with Jacobi's preconditioner.
    template <int dim>
    void
    solve_iteratively(const ConsistentTangent<dim>    &tangent,
                      const std::vector<unsigned int> &removed,
                      const Springs                   &springs,
                      const std::vector<double>       &mass,
                      const Walls<dim>                *walls,
                      NodalVector                     &x,
                      const NodalVector               &b)
    {
      std::optional<OperatorSum<Walls<dim>>> walled;
      if (walls != nullptr)
        walled.emplace(tangent, *walls);
      const SystemOperator system(walled
                                    ? static_cast<const Operator &>(*walled)
                                    : tangent,
                                  1.,
                                  0.,
                                  mass,
                                  removed,
                                  springs);
      NodalVector diagonal;
      diagonal.reinit(b);
      system.add_diagonal(diagonal);
      DiagonalMatrix<NodalVector> jacobi;
      jacobi.get_vector() = diagonal;
      for (double &entry : jacobi.get_vector())
        entry = entry > 0. ? 1. / entry : 0.;

      ReductionControl      control(5000, 1e-300, 1e-6, false, false);
      SolverCG<NodalVector> cg(control);
      x = 0.;
      try
        {
          cg.solve(ShiftedOperator(system, diagonal), x, b, jacobi);
        }
      catch (const SolverControl::NoConvergence &)
        {
          // The next iteration of the step goes on from here.
        }
    }


    /// Norm of the vector as in NewtonSolver.
    template <int dim>
    double
    weighted_norm(const NodalVector         &vector,
                  const std::vector<double> &mass,
                  const double               full_node_mass)
    {
      double sum = 0.;
      for (std::size_t i = 0; i < mass.size(); ++i)
        for (unsigned int c = 0; c < dim; ++c)
          sum += std::min(1., mass[i] / full_node_mass) *
                 vector.begin()[dim * i + c] * vector.begin()[dim * i + c];
      return std::sqrt(sum);
    }
  } // namespace


  template <int dim>
  GravityReport
  gravity_step(const Materials         &materials,
               const Weights<dim>      &weights,
               const Fixities<dim>     &fixities,
               const double             full_node_mass,
               const double             tolerance,
               const MappingParameters &mapping,
               NodalState              &nodes,
               MaterialPoints<dim>     &points,
               const Walls<dim>        *walls)
  {
    const ElasticMixture elastic = elastic_mixture(materials,
                                                   weights.background_grid(),
                                                   weights.functions(),
                                                   points);
    // For this step the points are of these materials.
    const std::vector<std::uint32_t> own_materials =
      std::exchange(points.material, elastic.of_point);
    StressUpdate<dim>      stress_update(elastic.materials,
                                    make_small_motion<dim>(mapping));
    ConsistentTangent<dim> tangent(weights);
    NodalVector            R, correction;
    R.reinit(nodes.external_force);
    correction.reinit(nodes.external_force);
    nodes.increment       = 0.;
    const Springs springs = make_springs(fixities,
                                         stiffest_modulus(materials),
                                         weights.background_grid().cell_size());

    stress_update.evaluate(points,
                           weights,
                           nodes.increment,
                           nodes.internal_force);
    tangent.reinit(stress_update, points);
    std::optional<OperatorSum<Walls<dim>>> walled;
    if (walls != nullptr)
      walled.emplace(tangent, *walls);
    const SystemOperator system(walled ? static_cast<const Operator &>(*walled)
                                       : tangent,
                                1.,
                                0.,
                                nodes.mass,
                                fixities.removed_list(),
                                springs);
    std::unique_ptr<DirectSolver<dim>> factorisation;
    if constexpr (dim == 2)
      {
        factorisation =
          std::make_unique<DirectSolver<dim>>(weights.background_grid());
        factorisation->factorise(system, relative_shift);
      }

    GravityReport report;
    report.mixed_cells = elastic.cells;
    double reference   = 0.;
    for (unsigned int iteration = 0; iteration <= 20; ++iteration)
      {
        R = nodes.external_force;
        R -= nodes.internal_force;
        for (const unsigned int dof : fixities.removed_list())
          R.begin()[dof] = 0.;
        // A load on a node without material has nothing to act on.
        for (std::size_t i = 0; i < nodes.mass.size(); ++i)
          if (!(nodes.mass[i] > 0.))
            for (unsigned int c = 0; c < dim; ++c)
              R.begin()[dim * i + c] = 0.;
        for (std::size_t k = 0; k < springs.dofs.size(); ++k)
          R.begin()[springs.dofs[k]] -=
            springs.stiffness[k] * nodes.increment.begin()[springs.dofs[k]];
        const double norm = weighted_norm<dim>(R, nodes.mass, full_node_mass);
        if (iteration == 0)
          reference = norm;
        if (reference == 0.)
          {
            report.converged = true; // no load
            break;
          }
        // Infinity is not below infinity times the tolerance.
        const bool finite = std::isfinite(norm);
        report.residuals.push_back(
          finite ? norm / reference : std::numeric_limits<double>::infinity());
        report.converged = finite && norm <= tolerance * reference;
        if (report.converged || !finite || iteration == 20)
          break;

        if constexpr (dim == 2)
          factorisation->solve(correction, R);
        else
          solve_iteratively(tangent,
                            fixities.removed_list(),
                            springs,
                            nodes.mass,
                            walls,
                            correction,
                            R);
        nodes.increment += correction;
        stress_update.evaluate(points,
                               weights,
                               nodes.increment,
                               nodes.internal_force);
        if (walls != nullptr)
          walls->add_internal_force(nodes.increment, nodes.internal_force);
      }
    stress_update.accept(points);
    points.material = own_materials;
    return report;
  }


  template GravityReport
  gravity_step(const Materials &,
               const Weights<2> &,
               const Fixities<2> &,
               const double,
               const double,
               const MappingParameters &,
               NodalState &,
               MaterialPoints<2> &,
               const Walls<2> *);
  template GravityReport
  gravity_step(const Materials &,
               const Weights<3> &,
               const Fixities<3> &,
               const double,
               const double,
               const MappingParameters &,
               NodalState &,
               MaterialPoints<3> &,
               const Walls<3> *);
} // namespace Waker
