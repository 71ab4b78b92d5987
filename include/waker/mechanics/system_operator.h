// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_system_operator_h
#define waker_mechanics_system_operator_h

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/solver_control.h>

#include <waker/mechanics/gmres.h>
#include <waker/mechanics/preconditioner.h>
#include <waker/nodes/operator.h>
#include <waker/nodes/reached_nodes.h>
#include <waker/nodes/resistance.h>

#include <memory>
#include <vector>

namespace Waker
{
  /**
   * K* = r K + k M + K_sup on the equations that are not removed (eq. 2.24 of
   * Remmerswaal 2023, with the residual ramp r): K the resistances of and on
   * the body, K_sup those of supports.
   */
  template <int dim>
  class SystemOperator : public Operator
  {
  public:
    /**
     * @param resistances linearised; must outlive this object, as all arguments
     * @param ramp r
     * @param inertia k: 4 / dt^2 for Newmark, 0 in a static step
     * @param mass lumped, Mg, one per node (dim dofs each)
     * @param reached the nodes that it reaches
     * @param removed the dofs whose equations are removed
     */
    SystemOperator(const Resistances<dim>          &resistances,
                   const double                     ramp,
                   const double                     inertia,
                   const std::vector<double>       &mass,
                   const ReachedNodes              &reached,
                   const std::vector<unsigned int> &removed);

    void
    vmult(NodalVector &dst, const NodalVector &src) const override;

    void
    add_diagonal(NodalVector &diagonal) const override;

    /// Of a static step: with the whole of its resistances, without inertia.
    void
    add_entries(MatrixEntries &entries) const override;

    bool
    is_symmetric() const override;

  private:
    bool
    has_supports() const;

    /// dst += K src of the supports
    void
    add_supports(NodalVector &dst, const NodalVector &src) const;

    const Resistances<dim>          *resistances;
    double                           ramp;
    double                           inertia;
    const std::vector<double>       *mass;
    const ReachedNodes              *reached;
    const std::vector<unsigned int> *removed;
    // Work space; the last two on several ranks only.
    mutable NodalVector stiffness_diagonal, everywhere, of_supports;
  };


  /**
   * A + s |diag A|, taken for symmetric: a static stiffness that conjugate
   * gradients may try, though it is only nearly so.
   */
  class StaticOperator : public Operator
  {
  public:
    /// @param A must outlive this object
    /// @param like a vector of its size
    /// @param shift s; it does not count in add_diagonal()
    StaticOperator(const Operator    &A,
                   const NodalVector &like,
                   const double       shift);

    void
    vmult(NodalVector &dst, const NodalVector &src) const override;

    void
    add_diagonal(NodalVector &diagonal) const override
    {
      A.add_diagonal(diagonal);
    }

    void
    add_entries(MatrixEntries &entries) const override
    {
      A.add_entries(entries); // the shift is small
    }

    bool
    is_symmetric() const override
    {
      return true;
    }

  private:
    const Operator &A;
    NodalVector     shift; // s |diag A|, empty if there is none
  };


  /**
   * Solve A x = b from x = 0 with Jacobi's preconditioner: by conjugate
   * gradients if A says it is symmetric (GMRES if that breaks down in
   * softening), else by GMRES. `x` holds the best iterate even without
   * convergence.
   *
   * If there is a stronger preconditioner, it is set up when a system is
   * expected to take more iterations with the diagonal than the set-up costs,
   * by its number of equations and the tolerance; or when so many have been
   * taken, in all systems since prepare(). It serves that system to its end,
   * and all others until the next prepare(). So they take little more than
   * twice the time of the better of the two, whatever the body is. If it cannot
   * be set up, the diagonal goes on.
   *
   * On several ranks vectors are those of a rank's window, 0 at the nodes of
   * others.
   */
  class LinearSolver
  {
  public:
    /// @param ranks that share the nodes
    /// @param strong the stronger preconditioner, if any
    LinearSolver(const unsigned int              n_dofs,
                 const NodeExchange             &ranks,
                 std::unique_ptr<Preconditioner> strong = nullptr);

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
    /// Conjugate gradients from x; not converged, too, if A turns out not to be
    /// definite.
    template <typename M>
    LinearReport
    conjugate_gradients(const Operator    &A,
                        NodalVector       &x,
                        const NodalVector &b,
                        const M           &preconditioner,
                        SolverControl     &control) const;

    /// The part of solve() that takes A for symmetric.
    LinearReport
    solve_symmetric(const Operator    &A,
                    NodalVector       &x,
                    const NodalVector &b,
                    const double       tolerance,
                    const unsigned int max_iterations);

    /// Where the stronger preconditioner is.
    enum class Strong
    {
      later,
      ready,
      failed
    };

    DiagonalMatrix<NodalVector>     jacobi;
    Gmres                           gmres;
    const NodeExchange             *ranks;
    std::unique_ptr<Preconditioner> strong; // or none
    Strong                          state       = Strong::failed;
    unsigned int                    n_diagonal  = 0;  // iterations so far
    double                          n_equations = 0.; // of all ranks
  };
} // namespace Waker

#endif
