// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/mechanics/direct_solver.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <array>
#include <cmath>

namespace Waker
{
  namespace
  {
    constexpr int reach  = 2;             // nodes, in each direction
    constexpr int period = 2 * reach + 1; // of the unit entries

    /// A domain that reaches 1e-8 of a cell into the next one, by round-off
    /// and what follows from it, does not touch that cell's nodes.
    constexpr double smallest_share = 1e-16; // of the largest diagonal
  }                                          // namespace


  template <int dim>
  struct DirectSolver<dim>::Factors
  {
    std::vector<Eigen::Triplet<double>>          entries;
    Eigen::SparseMatrix<double>                  matrix;
    MatrixKind                                   kind = MatrixKind::general;
    Eigen::SparseLU<Eigen::SparseMatrix<double>> lu;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> ldlt;
    Eigen::VectorXd                   rhs, solution;
    double                            shift = 0.;
    std::vector<double>               scale; // 1 / sqrt(D) of each equation
    std::vector<std::array<int, dim>> index; // of the nodes
    std::array<std::vector<unsigned int>, (dim == 2 ? 25 : 125)> colours;
  };


  template <int dim>
  DirectSolver<dim>::DirectSolver(const BackgroundGrid<dim> &grid)
    : grid(&grid)
    , src(grid.n_dofs())
    , dst(grid.n_dofs())
    , factors(std::make_unique<Factors>())
  {
    for (unsigned int node = 0; node < grid.n_nodes(); ++node)
      factors->index.push_back(grid.node_index(node));
  }


  template <int dim>
  DirectSolver<dim>::~DirectSolver() = default;


  template <int dim>
  void
  DirectSolver<dim>::factorise(const Operator  &A,
                               const double     shift,
                               const MatrixKind kind)
  {
    Factors &f = *factors;
    dst        = 0.;
    A.add_diagonal(dst);
    const double largest = dst.linfty_norm();
    equation.assign(grid->n_dofs(), -1);
    dofs.clear();
    f.entries.clear();
    f.scale.clear();
    f.shift = shift;
    f.kind  = kind;
    for (auto &colour : f.colours)
      colour.clear();
    for (unsigned int node = 0; node < grid->n_nodes(); ++node)
      {
        bool there = false;
        for (unsigned int dof = dim * node; dof < dim * (node + 1); ++dof)
          if (const double entry = dst.begin()[dof];
              std::abs(entry) > smallest_share * largest)
            {
              there         = true;
              equation[dof] = dofs.size();
              dofs.push_back(dof);
              f.scale.push_back(1. / std::sqrt(std::abs(entry)));
              f.entries.emplace_back(equation[dof], equation[dof], shift);
            }
        if (!there)
          continue;
        unsigned int colour = 0;
        for (int d = dim - 1; d >= 0; --d)
          colour = period * colour + f.index[node][d] % period;
        f.colours[colour].push_back(node);
      }

    src = 0.;
    for (unsigned int colour = 0; colour < f.colours.size(); ++colour)
      for (unsigned int c = 0; c < dim; ++c)
        {
          bool any = false;
          for (const unsigned int node : f.colours[colour])
            if (equation[dim * node + c] >= 0)
              {
                src.begin()[dim * node + c] = 1.;
                any                         = true;
              }
          if (!any)
            continue;
          A.vmult(dst, src);
          for (const unsigned int node : f.colours[colour])
            src.begin()[dim * node + c] = 0.;

          // The row of each equation meets one unit entry at most.
          for (unsigned int e = 0; e < dofs.size(); ++e)
            {
              const double value = dst.begin()[dofs[e]];
              if (value == 0.)
                continue;
              const auto  &row    = f.index[dofs[e] / dim];
              auto         column = row;
              unsigned int rest   = colour;
              bool         inside = true;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  const int phase = rest % period;
                  rest /= period;
                  const int distance =
                    (phase - row[d] % period + reach + 2 * period) % period -
                    reach;
                  column[d] += distance;
                  inside = inside && column[d] >= 0 &&
                           column[d] <
                             static_cast<int>(grid->n_nodes_per_direction()[d]);
                }
              if (!inside)
                continue;
              const int k = equation[dim * grid->node(column) + c];
              if (k >= 0)
                f.entries.emplace_back(e, k, f.scale[e] * value * f.scale[k]);
            }
        }

    f.matrix.resize(dofs.size(), dofs.size());
    f.matrix.setFromTriplets(f.entries.begin(), f.entries.end());
    const bool is_definite = kind == MatrixKind::definite;
    if (is_definite)
      f.ldlt.compute(f.matrix);
    else
      f.lu.compute(f.matrix);
    if ((is_definite ? f.ldlt.info() : f.lu.info()) != Eigen::Success)
      throw NumericalFailure("the stiffness is singular: is the body held by "
                             "a fixed boundary?");
  }


  template <int dim>
  void
  DirectSolver<dim>::solve(NodalVector &x, NodalVector &b)
  {
    Factors &f = *factors;
    f.rhs.resize(dofs.size());
    for (unsigned int e = 0; e < dofs.size(); ++e)
      f.rhs[e] = f.scale[e] * b.begin()[dofs[e]];
    if (f.kind == MatrixKind::definite)
      f.solution = f.ldlt.solve(f.rhs);
    else
      {
        f.solution = f.lu.solve(f.rhs);
        f.rhs -= f.shift * f.solution;
        f.solution = f.lu.solve(f.rhs);
        for (unsigned int e = 0; e < dofs.size(); ++e)
          b.begin()[dofs[e]] = f.rhs[e] / f.scale[e];
      }
    x = 0.;
    for (unsigned int e = 0; e < dofs.size(); ++e)
      x.begin()[dofs[e]] = f.scale[e] * f.solution[e];
  }


  template class DirectSolver<2>;
  template class DirectSolver<3>;
} // namespace Waker
