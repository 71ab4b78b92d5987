// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/mechanics/static_factorisation.h>

#include <array>

namespace Waker
{
  StaticFactorisation::StaticFactorisation(
    const ConsistentTangent<2>       &tangent,
    const std::vector<unsigned char> &removed,
    const Springs                    &springs,
    const std::vector<double>        &mass,
    const double                      shift,
    const Walls<2>                   *walls)
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
        double                 A[3][4], g[9][2];
        tangent.point_tangent(p, A);
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

    if (walls != nullptr)
      walls->for_each_block(
        [&](const unsigned int i, const unsigned int j, const Tensor<2, 2> &K) {
          const BackgroundGrid<2> &grid = weights.background_grid();
          const auto               from = grid.node_index(i);
          const auto               to   = grid.node_index(j);
          Block                   &block =
            blocks[i][(to[1] - from[1] + 2) * 5 + to[0] - from[0] + 2];
          for (unsigned int c = 0; c < 2; ++c)
            for (unsigned int d = 0; d < 2; ++d)
              block[2 * c + d] += K[c][d];
        });

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
                  value *= 1. + shift;
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
  StaticFactorisation::solve(NodalVector &x, const NodalVector &b) const
  {
    Eigen::VectorXd rhs(dofs.size());
    for (unsigned int e = 0; e < dofs.size(); ++e)
      rhs[e] = b.begin()[dofs[e]];
    const Eigen::VectorXd solution = ldlt.solve(rhs);
    x                              = 0.;
    for (unsigned int e = 0; e < dofs.size(); ++e)
      x.begin()[dofs[e]] = solution[e];
  }
} // namespace Waker
