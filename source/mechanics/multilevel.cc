// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/index_set.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <waker/mechanics/multilevel.h>
#include <waker/mechanics/node_matrix.h>

#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <ml_MultiLevelPreconditioner.h>
#include <ml_utils.h>

namespace Waker
{
  namespace
  {
    /// As in a factorisation (DirectSolver).
    constexpr double smallest_share = 1e-16; // of the largest diagonal

    /// Where the matrix is so many times as stiff as the operator, the latter's
    /// diagonal helps.
    constexpr double much_stiffer = 4.;

    /// Of the diagonal, added to it: motions without stiffness are not for this
    /// to find.
    constexpr double shift = 1e-8;


    /// Motions of a rigid body, dof by dof of the own nodes, one after another:
    /// translations, then rotations about the middle of the grid, of the size
    /// of 1.
    template <int dim>
    std::vector<double>
    rigid_motions(const BackgroundGrid<dim>       &grid,
                  const std::vector<unsigned int> &nodes)
    {
      constexpr unsigned int n_modes = dim == 2 ? 3 : 6;
      const std::size_t      n       = dim * nodes.size();
      std::vector<double>    modes(n_modes * n, 0.);
      const Point<dim>       middle =
        0.5 * (grid.lower_corner() + Tensor<1, dim>(grid.upper_corner()));
      const double inverse =
        1. / grid.lower_corner().distance(grid.upper_corner());
      for (std::size_t k = 0; k < nodes.size(); ++k)
        {
          const Tensor<1, dim> x =
            inverse * (grid.node_position(nodes[k]) - middle);
          for (unsigned int c = 0; c < dim; ++c)
            modes[c * n + dim * k + c] = 1.;
          unsigned int mode = dim;
          for (unsigned int a = 0; a < dim; ++a)
            for (unsigned int b = a + 1; b < dim; ++b, ++mode)
              {
                modes[mode * n + dim * k + a] = -x[b];
                modes[mode * n + dim * k + b] = x[a];
              }
        }
      return modes;
    }
  } // namespace


  template <int dim>
  struct Multilevel<dim>::Levels
  {
    std::unique_ptr<TrilinosWrappers::SparseMatrix> matrix;
    TrilinosWrappers::PreconditionAMG               ml;
    std::vector<unsigned int>                       dofs; // row after row
    std::vector<unsigned char>  is_there;   // has the row an equation?
    std::vector<double>         additional; // inverse diagonal, or 0
    mutable std::vector<double> src, dst;
  };


  template <int dim>
  Multilevel<dim>::Multilevel(const BackgroundGrid<dim> &grid)
    : grid(&grid)
  {}


  template <int dim>
  Multilevel<dim>::~Multilevel() = default;


  template <int dim>
  void
  Multilevel<dim>::clear()
  {
    levels.reset();
  }


  template <int dim>
  bool
  Multilevel<dim>::reinit(const Operator &A)
  {
    levels       = std::make_unique<Levels>();
    double fails = 0.;
    try
      {
        set_up(A);
      }
    catch (...) // ML throws numbers, too
      {
        fails = 1.;
      }
    if (grid->exchange().largest(fails) == 0. && is_positive())
      return true;
    clear();
    return false;
  }


  template <int dim>
  void
  Multilevel<dim>::set_up(const Operator &A)
  {
    const NodeExchange &ranks = grid->exchange();
    NodalVector         diagonal(grid->n_dofs());
    A.add_diagonal(diagonal);
    const double limit = smallest_share * ranks.largest(diagonal.linfty_norm());
    std::vector<unsigned char> is_equation(grid->n_dofs(), 0);
    for (unsigned int dof = 0; dof < is_equation.size(); ++dof)
      is_equation[dof] = std::abs(diagonal.begin()[dof]) > limit;

    Levels             &l = *levels;
    std::vector<double> modes;
    {
      NodeMatrix<dim> nodes(*grid, is_equation);
      A.add_entries(nodes);
      nodes.compress();
      fill(nodes, diagonal, is_equation);
      modes = rigid_motions(*grid, nodes.own_nodes());
      for (std::size_t k = 0; k < modes.size(); ++k)
        if (!l.is_there[k % l.dofs.size()])
          modes[k] = 0.;
    } // and its memory is free

    Teuchos::ParameterList parameters;
    ML_Epetra::SetDefaults("SA", parameters);
    parameters.set("ML output", 0);
    parameters.set("PDE equations", static_cast<int>(dim));
    parameters.set("aggregation: type", "Uncoupled");
    parameters.set("aggregation: threshold", 0.);
    parameters.set("smoother: type", "Chebyshev");
    parameters.set("smoother: sweeps", 2);
    parameters.set("smoother: pre or post", "both");
    parameters.set("coarse: max size", 1000);
    parameters.set("coarse: type", "Amesos-KLU");
    parameters.set("null space: type", "pre-computed");
    parameters.set("null space: add default vectors", false);
    parameters.set("null space: dimension", dim == 2 ? 3 : 6);
    parameters.set("null space: vectors", modes.data());
    ML_set_random_seed(1); // of its estimates of eigenvalues
    l.ml.initialize(*l.matrix, parameters);
  }


  template <int dim>
  void
  Multilevel<dim>::fill(const NodeMatrix<dim>            &nodes,
                        const NodalVector                &diagonal,
                        const std::vector<unsigned char> &is_equation)
  {
    Levels                              &l   = *levels;
    const std::vector<unsigned int>     &own = nodes.own_nodes();
    typename NodeMatrix<dim>::Row        row;
    std::vector<unsigned int>            lengths;
    std::vector<types::global_dof_index> columns;
    const auto                           for_each_row = [&](const auto &f) {
      for (std::size_t k = 0; k < own.size(); ++k)
        for (unsigned int c = 0; c < dim; ++c)
          {
            nodes.get_row(k, c, row);
            f(dim * own[k] + c);
          }
    };
    for_each_row([&](const unsigned int) {
      lengths.push_back(std::max<std::size_t>(row.columns.size(), 1));
    });
    IndexSet rows(nodes.n_rows());
    rows.add_range(nodes.first_row(), nodes.first_row() + dim * own.size());
    l.matrix = std::make_unique<TrilinosWrappers::SparseMatrix>(
      rows, grid->exchange().communicator(), lengths);

    for_each_row([&](const unsigned int dof) {
      const std::uint64_t number = nodes.first_row() + l.dofs.size();
      const double        D      = std::abs(diagonal.begin()[dof]);
      l.dofs.push_back(dof);
      l.is_there.push_back(is_equation[dof]);
      l.additional.push_back(
        is_equation[dof] && row.diagonal > much_stiffer * D ? 1. / D : 0.);
      if (!(row.diagonal > 0.))
        {
          // None, or one of which nothing is known but its diagonal: as stiff
          // as any component of the node, so that the levels see no other kind
          // of number.
          const unsigned int first = dof - dof % dim;
          double             like  = D;
          for (unsigned int d = first; d < first + dim; ++d)
            like = std::max(like, std::abs(diagonal.begin()[d]));
          l.matrix->set(number, number, like);
          return;
        }
      columns.assign(row.columns.begin(), row.columns.end());
      for (std::size_t k = 0; k < columns.size(); ++k)
        if (columns[k] == number)
          row.values[k] *= 1. + shift;
      l.matrix->set(number, columns.size(), columns.data(), row.values.data());
    });
    l.matrix->compress(VectorOperation::insert);
    l.src.resize(l.dofs.size());
    l.dst.resize(l.dofs.size());
  }


  template <int dim>
  bool
  Multilevel<dim>::is_positive() const
  {
    // Of a vector without order, the same on any number of ranks.
    NodalVector x(grid->n_dofs()), y(grid->n_dofs());
    for (std::size_t k = 0; k < levels->dofs.size(); ++k)
      if (levels->is_there[k])
        {
          const Point<dim> place = grid->node_position(levels->dofs[k] / dim);
          x.begin()[levels->dofs[k]] =
            std::sin(1e3 * (place.square() + levels->dofs[k] % dim));
        }
    vmult(y, x);
    const double product = grid->exchange().sum(x * y);
    return std::isfinite(product) && product > 0.;
  }


  template <int dim>
  void
  Multilevel<dim>::vmult(NodalVector &dst, const NodalVector &src) const
  {
    const Levels       &l   = *levels;
    const Epetra_Map   &map = l.matrix->trilinos_matrix().DomainMap();
    const double *const x   = src.begin();
    double *const       y   = dst.begin();
    for (std::size_t k = 0; k < l.dofs.size(); ++k)
      l.src[k] = l.is_there[k] ? x[l.dofs[k]] : 0.;
    Epetra_Vector in(View, map, l.src.data()), out(View, map, l.dst.data());
    l.ml.trilinos_operator().ApplyInverse(in, out);
    dst = 0.;
    for (std::size_t k = 0; k < l.dofs.size(); ++k)
      if (l.is_there[k])
        y[l.dofs[k]] = l.dst[k] + l.additional[k] * x[l.dofs[k]];
  }


  template class Multilevel<2>;
  template class Multilevel<3>;
} // namespace Waker
