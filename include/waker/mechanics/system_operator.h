// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_system_operator_h
#define waker_mechanics_system_operator_h

#include <deal.II/lac/diagonal_matrix.h>

#include <waker/mechanics/gmres.h>
#include <waker/nodes/fixities.h>
#include <waker/nodes/operator.h>

#include <vector>

namespace Waker
{
  /// Springs that hold dofs: the penalty form of a support.
  struct Springs
  {
    std::vector<unsigned int> dofs;
    std::vector<double>       stiffness; // kN/m
  };

  /// The springs of the fixities' penalty dofs, on a grid with cells of h.
  /// @param modulus the stiffest K + 4G/3 (kPa)
  template <int dim>
  Springs
  make_springs(const Fixities<dim> &fixities,
               const double         modulus,
               const double         h);

  /**
   * K* = r K + k M + penalty springs on the equations that are not removed
   * (eq. 2.24 of Remmerswaal 2023, with the residual ramp r).
   */
  class SystemOperator : public Operator
  {
  public:
    /**
     * @param stiffness K; must outlive this object, as all arguments
     * @param ramp r
     * @param inertia k: 4 / dt^2 for Newmark, 0 in a static step
     * @param mass lumped, Mg, one per node (dim dofs each)
     * @param removed the dofs whose equations are removed
     */
    SystemOperator(const Operator                  &stiffness,
                   const double                     ramp,
                   const double                     inertia,
                   const std::vector<double>       &mass,
                   const std::vector<unsigned int> &removed,
                   const Springs                   &springs);

    void
    vmult(NodalVector &dst, const NodalVector &src) const override;

    void
    add_diagonal(NodalVector &diagonal) const override;

    bool
    is_symmetric() const override
    {
      return stiffness->is_symmetric();
    }

  private:
    const Operator                  *stiffness;
    double                           ramp;
    double                           inertia;
    const std::vector<double>       *mass;
    const std::vector<unsigned int> *removed;
    const Springs                   *springs;
    mutable NodalVector              stiffness_diagonal; // work space
  };


  /**
   * Solve A x = b from x = 0 with Jacobi's preconditioner: by conjugate
   * gradients if A says it is symmetric (GMRES if that breaks down in
   * softening), else by GMRES. `x` holds the best iterate even without
   * convergence.
   */
  class LinearSolver
  {
  public:
    explicit LinearSolver(const unsigned int n_dofs);

    /// Take the preconditioner from this operator's diagonal.
    void
    prepare(const Operator &A);

    /// @param tolerance relative reduction of the residual, a force: its norm
    ///        is Newton's but for the weights
    LinearReport
    solve(const Operator    &A,
          NodalVector       &x,
          const NodalVector &b,
          const double       tolerance,
          const unsigned int max_iterations);

  private:
    DiagonalMatrix<NodalVector> jacobi;
    Gmres                       gmres;
  };
} // namespace Waker

#endif
