// SPDX-License-Identifier: LGPL-2.1-or-later

#include <waker/base/errors.h>
#include <waker/mechanics/direct_solver.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

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
    Eigen::VectorXd            rhs, solution;
    double                     shift = 0.;
    std::vector<Index>         index; // of the nodes, in the whole grid
    std::vector<double>        scale; // 1 / sqrt(D) of all equations
    std::vector<int>           equation_of_dof; // on one rank; or -1
    std::vector<int>           own;  // numbers of this rank's equations
    std::vector<int>           all;  // of all ranks' equations, rank by rank
    std::vector<std::uint64_t> keys; // of all equations, on several ranks
    std::array<std::vector<unsigned int>, (dim == 2 ? 25 : 125)> colours;

    std::uint64_t
    key(const Index &i, const unsigned int c) const
    {
      // Lattice indices have less than 2^20 values, margin and reach included.
      std::uint64_t number = 0;
      for (int d = dim - 1; d >= 0; --d)
        number = number << 20 | static_cast<std::uint64_t>(i[d] + reach);
      return number << 2 | c;
    }
  };


  template <int dim>
  DirectSolver<dim>::DirectSolver(const BackgroundGrid<dim> &grid)
    : grid(&grid)
    , src(grid.n_dofs())
    , dst(grid.n_dofs())
    , factors(std::make_unique<Factors>())
  {
    for (unsigned int node = 0; node < grid.n_nodes(); ++node)
      {
        Index index = grid.node_index(node);
        for (unsigned int d = 0; d < dim; ++d)
          index[d] += grid.offset()[d];
        factors->index.push_back(index);
      }
  }


  template <int dim>
  DirectSolver<dim>::~DirectSolver() = default;


  template <int dim>
  void
  DirectSolver<dim>::number_equations()
  {
    Factors            &f     = *factors;
    const NodeExchange &ranks = grid->exchange();
    if (ranks.is_one_rank())
      {
        f.equation_of_dof.assign(grid->n_dofs(), -1);
        for (unsigned int e = 0; e < dofs.size(); ++e)
          f.equation_of_dof[dofs[e]] = e;
        f.own.resize(dofs.size());
        std::iota(f.own.begin(), f.own.end(), 0);
        f.all = f.own;
        return;
      }
    std::vector<std::uint64_t> mine;
    for (const unsigned int dof : dofs)
      mine.push_back(f.key(f.index[dof / dim], dof % dim));
    const std::vector<std::uint64_t> keys   = ranks.all_gather(mine);
    const std::vector<double>        scales = ranks.all_gather(f.scale);
    f.keys                                  = keys;
    std::sort(f.keys.begin(), f.keys.end());
    const auto number = [&](const std::uint64_t key) {
      return static_cast<int>(
        std::lower_bound(f.keys.begin(), f.keys.end(), key) - f.keys.begin());
    };
    f.own.clear();
    for (const std::uint64_t key : mine)
      f.own.push_back(number(key));
    f.all.clear();
    f.scale.resize(f.keys.size());
    for (std::size_t e = 0; e < keys.size(); ++e)
      {
        f.all.push_back(number(keys[e]));
        f.scale[f.all.back()] = scales[e];
      }
  }


  template <int dim>
  int
  DirectSolver<dim>::find_equation(const Index       &index,
                                   const unsigned int c) const
  {
    const Factors &f = *factors;
    if (grid->exchange().is_one_rank())
      {
        for (unsigned int d = 0; d < dim; ++d)
          if (index[d] < 0 ||
              index[d] >= static_cast<int>(grid->n_nodes_per_direction()[d]))
            return -1;
        return f.equation_of_dof[dim * grid->node(index) + c];
      }
    const std::uint64_t key = f.key(index, c);
    const auto found = std::lower_bound(f.keys.begin(), f.keys.end(), key);
    return found != f.keys.end() && *found == key ? found - f.keys.begin() : -1;
  }


  template <int dim>
  void
  DirectSolver<dim>::read_entries(const Operator &A)
  {
    Factors            &f     = *factors;
    const NodeExchange &ranks = grid->exchange();
    src                       = 0.;
    for (unsigned int colour = 0; colour < f.colours.size(); ++colour)
      for (unsigned int c = 0; c < dim; ++c)
        {
          bool any = false;
          for (const unsigned int node : f.colours[colour])
            if (find_equation(f.index[node], c) >= 0)
              {
                src.begin()[dim * node + c] = 1.;
                any                         = true;
              }
          if (ranks.largest(any ? 1. : 0.) == 0.)
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
              const Index &row    = f.index[dofs[e] / dim];
              Index        column = row;
              unsigned int rest   = colour;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  const int phase = rest % period;
                  rest /= period;
                  column[d] +=
                    (phase - row[d] % period + reach + 2 * period) % period -
                    reach;
                }
              if (const int k = find_equation(column, c); k >= 0)
                f.entries.emplace_back(f.own[e],
                                       k,
                                       f.scale[f.own[e]] * value * f.scale[k]);
            }
        }
    if (ranks.is_one_rank())
      return;
    f.entries = ranks.all_gather(f.entries);
  }


  template <int dim>
  void
  DirectSolver<dim>::factorise(const Operator  &A,
                               const double     shift,
                               const MatrixKind kind)
  {
    Factors            &f     = *factors;
    const NodeExchange &ranks = grid->exchange();
    dst                       = 0.;
    A.add_diagonal(dst);
    const double largest = ranks.largest(dst.linfty_norm());
    dofs.clear();
    f.entries.clear();
    f.scale.clear();
    f.shift = shift;
    f.kind  = kind;
    for (auto &colour : f.colours)
      colour.clear();
    for (unsigned int node = 0; node < grid->n_nodes(); ++node)
      {
        if (!ranks.owns(node))
          continue;
        bool there = false;
        for (unsigned int dof = dim * node; dof < dim * (node + 1); ++dof)
          if (const double entry = dst.begin()[dof];
              std::abs(entry) > smallest_share * largest)
            {
              there = true;
              dofs.push_back(dof);
              f.scale.push_back(1. / std::sqrt(std::abs(entry)));
            }
        if (!there)
          continue;
        unsigned int colour = 0;
        for (int d = dim - 1; d >= 0; --d)
          colour = period * colour + f.index[node][d] % period;
        f.colours[colour].push_back(node);
      }
    number_equations();
    for (const int e : f.own)
      f.entries.emplace_back(e, e, shift);
    read_entries(A);

    f.matrix.resize(f.scale.size(), f.scale.size());
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
    Factors            &f = *factors;
    std::vector<double> values; // of all ranks, rank by rank
    for (unsigned int e = 0; e < dofs.size(); ++e)
      values.push_back(f.scale[f.own[e]] * b.begin()[dofs[e]]);
    values = grid->exchange().all_gather(values);
    f.rhs.resize(f.scale.size());
    for (std::size_t k = 0; k < values.size(); ++k)
      f.rhs[f.all[k]] = values[k];
    if (f.kind == MatrixKind::definite)
      f.solution = f.ldlt.solve(f.rhs);
    else
      {
        f.solution = f.lu.solve(f.rhs);
        f.rhs -= f.shift * f.solution;
        f.solution = f.lu.solve(f.rhs);
        for (unsigned int e = 0; e < dofs.size(); ++e)
          b.begin()[dofs[e]] = f.rhs[f.own[e]] / f.scale[f.own[e]];
      }
    x = 0.;
    for (unsigned int e = 0; e < dofs.size(); ++e)
      x.begin()[dofs[e]] = f.scale[f.own[e]] * f.solution[f.own[e]];
  }


  template class DirectSolver<2>;
  template class DirectSolver<3>;
} // namespace Waker
