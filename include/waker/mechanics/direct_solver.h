// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_direct_solver_h
#define waker_mechanics_direct_solver_h

#include <waker/grid/background_grid.h>
#include <waker/nodes/operator.h>

#include <memory>
#include <vector>

namespace Waker
{
  /**
   * A x = b by a sparse factorisation (LU, so A may be unsymmetric or
   * indefinite), for operators that couple nodes at most two apart in each
   * direction: the matrix is read from products with 5^dim dim vectors, in
   * each of which the unit entries are too far apart to meet.
   *
   * In a static step some motions of nodes that only one support domain touches
   * have no stiffness: `shift` times its diagonal is added to the matrix, and
   * Newton iterates the difference away.
   */
  template <int dim>
  class DirectSolver
  {
  public:
    /// @param grid must outlive this object
    explicit DirectSolver(const BackgroundGrid<dim> &grid);

    ~DirectSolver();

    /// Factorise A + shift diag A, of the equations with a diagonal that is not
    /// zero.
    /// @throws NumericalFailure if the matrix is singular
    void
    factorise(const Operator &A, const double shift);

    /// x of the last factorisation; zero where there is no equation.
    void
    solve(NodalVector &x, const NodalVector &b);

  private:
    struct Factors;

    const BackgroundGrid<dim> *grid;
    std::vector<int>           equation; // of each dof, or -1
    std::vector<unsigned int>  dofs;     // of each equation
    NodalVector                src, dst;
    std::unique_ptr<Factors>   factors;
  };
} // namespace Waker

#endif
