// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_direct_solver_h
#define waker_mechanics_direct_solver_h

#include <waker/grid/background_grid.h>
#include <waker/nodes/operator.h>

#include <memory>
#include <vector>

namespace Waker
{
  /// What a matrix is.
  enum class MatrixKind
  {
    general, // perhaps unsymmetric or indefinite: LU
    definite // symmetric and positive: LDL^T, a fraction of the time
  };


  /**
   * A x = b by a sparse factorisation, for operators that couple nodes at most
   * two apart in each direction: the matrix is read from products with 5^dim
   * dim vectors, in each of which the unit entries are too far apart to meet.
   *
   * In a static step some motions of nodes that only one support domain touches
   * have no stiffness, or so little that it means nothing. `shift` times its
   * diagonal D is added to the matrix, and where that is what carries a force
   * the force is left out:
   *   x = B (b - s D B b),  B = (A + s D)^-1.
   * Rows and columns are scaled by D: some nodes have next to nothing of it.
   * Motions much stiffer than s D are solved for but for a share of
   * (s D / A)^2, those much softer stay as they are.
   *
   * On several ranks each of them reads its own rows, and all factorise the
   * whole matrix.
   *
   * Of a definite matrix x = B b, for one factorisation that serves several
   * iterations: they take the shift away.
   */
  template <int dim>
  class DirectSolver
  {
  public:
    /// @param grid must outlive this object
    explicit DirectSolver(const BackgroundGrid<dim> &grid);

    ~DirectSolver();

    /// Factorise A + shift |diag A|, of the equations whose diagonal is more
    /// than round-off of the largest.
    /// @throws NumericalFailure if the matrix is singular
    void
    factorise(const Operator  &A,
              const double     shift,
              const MatrixKind kind = MatrixKind::general);

    /// x as above, zero where there is no equation.
    /// @param x, b on several ranks at the own nodes
    /// @param b out: the part of it that the stiffness can carry, b - s D B b
    ///        (as it is, if the matrix is definite)
    void
    solve(NodalVector &x, NodalVector &b);

  private:
    struct Factors;

    using Index = typename BackgroundGrid<dim>::Index;

    /// Number the equations of all ranks.
    void
    number_equations();

    /// Number of the equation of a component at a node, by its lattice index in
    /// the whole grid; -1 if there is none.
    int
    find_equation(const Index &index, const unsigned int c) const;

    /// Row after row, the entries of the own equations, from products.
    void
    read_entries(const Operator &A);

    const BackgroundGrid<dim> *grid;
    std::vector<unsigned int>  dofs; // of the own equations
    NodalVector                src, dst;
    std::unique_ptr<Factors>   factors;
  };
} // namespace Waker

#endif
