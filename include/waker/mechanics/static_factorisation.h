// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_static_factorisation_h
#define waker_mechanics_static_factorisation_h

#include <waker/boundary/wall.h>
#include <waker/mechanics/consistent_tangent.h>
#include <waker/mechanics/system_operator.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

namespace Waker
{
  /**
   * K + shift diag K of the equations that are there, factorised. Two nodes
   * are coupled if they are at most two apart in each direction: 5 x 5 blocks
   * per node.
   */
  class StaticFactorisation
  {
  public:
    /**
     * @param tangent linearised, its point tangents symmetric (elastic)
     * @param mass of the nodes: those without are left out
     * @param shift relative to the diagonal
     * @param walls off the grid, in contact; null: none
     * @throws NumericalFailure if the matrix is singular
     */
    StaticFactorisation(const ConsistentTangent<2>       &tangent,
                        const std::vector<unsigned char> &removed,
                        const Springs                    &springs,
                        const std::vector<double>        &mass,
                        const double                      shift,
                        const Walls<2>                   *walls = nullptr);

    /// x = (K + shift diag K)^-1 b; zero where there is no equation.
    void
    solve(NodalVector &x, const NodalVector &b) const;

  private:
    std::vector<int>          equation; // of each dof, or -1
    std::vector<unsigned int> dofs;     // of each equation
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> ldlt;
  };
} // namespace Waker

#endif
