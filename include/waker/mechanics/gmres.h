// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_gmres_h
#define waker_mechanics_gmres_h

#include <waker/grid/node_exchange.h>
#include <waker/mechanics/preconditioner.h>

#include <vector>

namespace Waker
{
  /// What a linear solve did.
  struct LinearReport
  {
    unsigned int iterations = 0;
    bool         converged  = false;
    /// Iterations with the stronger preconditioner, of all.
    unsigned int strong_iterations = 0;
    /// Was it to be set up, and could not be?
    bool strong_failed = false;
  };

  /**
   * GMRES from x = 0, preconditioned from the right with a diagonal (Saad 2003,
   * algorithm 9.5), on the equations that exist: most nodes of the grid hold no
   * soil, with memory that is kept. Why not deal.II's: it needs the same
   * iterations and 1.3 to 1.9 times the time in 2D, 1.0 to 1.2 in 3D
   * (doc/verification/performance.md). On several ranks, whose vectors are 0 at
   * the nodes of others, an iteration has one sum over all ranks: Gram-Schmidt
   * is the classical one there, once more where digits have been lost.
   */
  class Gmres
  {
  public:
    /// @param ranks must outlive this object
    explicit Gmres(const NodeExchange &ranks)
      : ranks(&ranks)
    {}

    /// @param inverse_diagonal the preconditioner; 0 where there is no equation
    void
    prepare(const NodalVector &inverse_diagonal);

    /// Solve A x = b; x is the best iterate even without convergence, and 0
    /// where there is no equation.
    /// @param tolerance relative reduction of the residual
    /// @param strong to be used in place of the diagonal, if not null; acts on
    ///        the same equations
    LinearReport
    solve(const Operator             &A,
          NodalVector                &x,
          const NodalVector          &b,
          const double                tolerance,
          const unsigned int          max_iterations,
          const Preconditioner *const strong = nullptr);

  private:
    /// Iterations before a restart.
    static constexpr unsigned int restart = 38;

    /// to = M^-1 v, 0 where there is no equation
    void
    precondition(const std::vector<double>  &v,
                 const Preconditioner *const strong,
                 NodalVector                &to);

    /// w = A M^-1 v on the equations that exist.
    void
    product(const Operator             &A,
            const std::vector<double>  &v,
            const Preconditioner *const strong,
            std::vector<double>        &w);

    /// Take from w what it has of the first `n` basis vectors.
    /// @param h out: how much of each; unchanged are the others
    /// @return the length of what remains
    double
    orthogonalise(std::vector<double> &w, const unsigned int n, double *h);

    const NodeExchange              *ranks;
    std::vector<unsigned int>        dofs;
    std::vector<double>              preconditioner;
    std::vector<std::vector<double>> basis;
    std::vector<double>              solution;        // M x
    NodalVector                      src, dst, plain; // the last: strong only
  };
} // namespace Waker

#endif
