// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <waker/base/errors.h>
#include <waker/mapping/stencil.h>
#include <waker/materials/linear_elastic.h>
#include <waker/mechanics/consistent_tangent.h>
#include <waker/mechanics/gravity_step.h>
#include <waker/mechanics/system_operator.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    constexpr double relative_shift = 1e-6; // of the diagonal


    /// The elastic part of each material.
    Materials
    elastic_materials(const Materials &materials)
    {
      Materials elastic;
      for (const auto &m : materials)
        {
          const double K = m->bulk_modulus(), G = m->shear_modulus();
          elastic.push_back(
            std::make_unique<LinearElastic>(m->density(),
                                            9. * K * G / (3. * K + G),
                                            (3. * K - 2. * G) /
                                              (2. * (3. * K + G))));
        }
      return elastic;
    }


    /**
     * K + shift diag K of the equations that are there, factorised. Two nodes
     * are coupled if they are at most two apart in each direction: 5 x 5 blocks
     * per node.
     */
    class Factorisation
    {
    public:
      Factorisation(const ConsistentTangent<2>       &tangent,
                    const std::vector<unsigned char> &removed,
                    const Springs                    &springs,
                    const std::vector<double>        &mass);

      void
      solve(NodalVector &x, const NodalVector &b) const;

    private:
      std::vector<int>          equation; // of each dof, or -1
      std::vector<unsigned int> dofs;     // of each equation
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> ldlt;
    };


    Factorisation::Factorisation(const ConsistentTangent<2>       &tangent,
                                 const std::vector<unsigned char> &removed,
                                 const Springs                    &springs,
                                 const std::vector<double>        &mass)
      : equation(removed.size(), -1)
    {
      for (unsigned int dof = 0; dof < removed.size(); ++dof)
        if (!removed[dof] && mass[dof / 2] > 0.)
          {
            equation[dof] = dofs.size();
            dofs.push_back(dof);
          }

      const Weights<2>  &weights = tangent.point_weights();
      const unsigned int row     = weights.background_grid().stride(1);
      // blocks[node][dy + 2][dx + 2] couples node with node + (dx, dy).
      using Block = std::array<double, 4>;
      std::vector<std::array<Block, 25>> blocks(mass.size());
      for (auto &node : blocks)
        node.fill({{0., 0., 0., 0.}});
      for (std::size_t p = 0; p < weights.size(); ++p)
        {
          const PointWeights<2> &w = weights[p];
          const auto            &A = tangent.point_tangents()[p].A;
          double                 g[9][2];
          for (unsigned int j = 0; j < 3; ++j)
            for (unsigned int i = 0; i < 3; ++i)
              {
                g[3 * j + i][0] = w.gradient[0][i] * w.value[1][j];
                g[3 * j + i][1] = w.value[0][i] * w.gradient[1][j];
              }
          for (unsigned int n = 0; n < 9; ++n)
            {
              double rows[2][4]; // of the force on node n over the gradient
              for (unsigned int k = 0; k < 4; ++k)
                {
                  rows[0][k] = g[n][0] * A[0][k] + g[n][1] * A[2][k];
                  rows[1][k] = g[n][0] * A[2][k] + g[n][1] * A[1][k];
                }
              auto &node = blocks[w.base + (n / 3) * row + n % 3];
              for (unsigned int m = 0; m < 9; ++m)
                {
                  Block &block =
                    node[(m / 3 + 2 - n / 3) * 5 + (m % 3 + 2 - n % 3)];
                  for (unsigned int c = 0; c < 2; ++c)
                    for (unsigned int d = 0; d < 2; ++d)
                      block[2 * c + d] +=
                        rows[c][2 * d] * g[m][0] + rows[c][2 * d + 1] * g[m][1];
                }
            }
        }

      Eigen::SparseMatrix<double> matrix(dofs.size(), dofs.size());
      matrix.reserve(Eigen::VectorXi::Constant(dofs.size(), 28));
      for (unsigned int e = 0; e < dofs.size(); ++e)
        {
          const unsigned int node = dofs[e] / 2, d = dofs[e] % 2;
          for (unsigned int k = 12; k < 25; ++k) // lower triangle
            {
              const unsigned int other =
                node + (k / 5) * row + k % 5 - 2 * row - 2;
              if (other >= mass.size())
                continue;
              for (unsigned int c = 0; c < 2; ++c)
                {
                  const int r = equation[2 * other + c];
                  if (r < static_cast<int>(e))
                    continue;
                  // The entry (other c, node d): blocks are symmetric.
                  double value = blocks[node][k][2 * d + c];
                  if (r == static_cast<int>(e))
                    value *= 1. + relative_shift;
                  if (value != 0.)
                    matrix.insert(r, e) = value;
                }
            }
        }
      for (std::size_t k = 0; k < springs.dofs.size(); ++k)
        if (const int e = equation[springs.dofs[k]]; e >= 0)
          matrix.coeffRef(e, e) += springs.stiffness[k];
      matrix.makeCompressed();
      ldlt.compute(matrix);
      if (ldlt.info() != Eigen::Success)
        throw NumericalFailure("the gravity step's stiffness is singular: is "
                               "the body held by a fixed boundary?");
    }


    void
    Factorisation::solve(NodalVector &x, const NodalVector &b) const
    {
      Eigen::VectorXd rhs(dofs.size());
      for (unsigned int e = 0; e < dofs.size(); ++e)
        rhs[e] = b.begin()[dofs[e]];
      const Eigen::VectorXd solution = ldlt.solve(rhs);
      x                              = 0.;
      for (unsigned int e = 0; e < dofs.size(); ++e)
        x.begin()[dofs[e]] = solution[e];
    }


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
                      NodalVector                     &x,
                      const NodalVector               &b)
    {
      const SystemOperator system(tangent, 1., 0., mass, removed, springs);
      NodalVector          diagonal;
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
  gravity_step(const Materials     &materials,
               const Weights<dim>  &weights,
               const Fixities<dim> &fixities,
               const double         full_node_mass,
               const double         tolerance,
               NodalState          &nodes,
               MaterialPoints<dim> &points)
  {
    const Materials        elastic = elastic_materials(materials);
    StressUpdate<dim>      stress_update(elastic, /*objective_rate=*/false);
    ConsistentTangent<dim> tangent(weights);
    NodalVector            R, correction;
    R.reinit(nodes.external_force);
    correction.reinit(nodes.external_force);
    nodes.increment = 0.;
    double modulus  = 0.;
    for (const auto &material : elastic)
      modulus = std::max(modulus,
                         material->bulk_modulus() +
                           4. / 3. * material->shear_modulus());
    const Springs springs =
      make_springs(fixities, modulus, weights.background_grid().cell_size());

    stress_update.evaluate(points,
                           weights,
                           nodes.increment,
                           nodes.internal_force);
    tangent.reinit(stress_update, points);
    std::unique_ptr<Factorisation> factorisation;
    if constexpr (dim == 2)
      factorisation = std::make_unique<Factorisation>(tangent,
                                                      fixities.removed(),
                                                      springs,
                                                      nodes.mass);

    GravityReport report;
    double        reference = 0.;
    for (unsigned int iteration = 0; iteration <= 20; ++iteration)
      {
        R = nodes.external_force;
        R -= nodes.internal_force;
        for (const unsigned int dof : fixities.removed_list())
          R.begin()[dof] = 0.;
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
        report.residuals.push_back(norm / reference);
        report.converged = norm <= tolerance * reference;
        if (report.converged || iteration == 20)
          break;

        if constexpr (dim == 2)
          factorisation->solve(correction, R);
        else
          solve_iteratively(tangent,
                            fixities.removed_list(),
                            springs,
                            nodes.mass,
                            correction,
                            R);
        nodes.increment += correction;
        stress_update.evaluate(points,
                               weights,
                               nodes.increment,
                               nodes.internal_force);
      }
    stress_update.accept(points);
    return report;
  }


  template GravityReport
  gravity_step(const Materials &,
               const Weights<2> &,
               const Fixities<2> &,
               const double,
               const double,
               NodalState &,
               MaterialPoints<2> &);
  template GravityReport
  gravity_step(const Materials &,
               const Weights<3> &,
               const Fixities<3> &,
               const double,
               const double,
               NodalState &,
               MaterialPoints<3> &);
} // namespace Waker
