// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/fields/covariance_factor.h>
#include <waker/fields/subdivision_stage.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace Waker
{
  namespace
  {
    using Index = std::array<unsigned int, 3>;

    /// Neighbours of a parent reach from -1 to 1, their children from 0 to 5.
    constexpr unsigned int n_lags = 6;

    /// Which neighbours a cell has: bit 2 d for the lower one in direction d,
    /// bit 2 d + 1 for the upper one.
    unsigned int
    sides_of_parent(const Index       &parent,
                    const Index       &n_parents,
                    const unsigned int dim)
    {
      unsigned int sides = 0;
      for (unsigned int d = 0; d < dim; ++d)
        sides |= ((parent[d] > 0) | (parent[d] + 1 < n_parents[d]) << 1)
                 << 2 * d;
      return sides;
    }



    /// The position (0 or 1 per direction) of child number `child`.
    Index
    child_position(const unsigned int child)
    {
      return {{child & 1, child >> 1 & 1, child >> 2 & 1}};
    }



    /// X with R X = S for a symmetric R that may be singular in double
    /// precision: the least squares solution of least norm then. A larger limit
    /// than 1e-14 throws away what smooth fields need, without one rounding
    /// errors get in (3D, Gaussian: 20 % of the variance in either case).
    Eigen::MatrixXd
    solve_symmetric(const Eigen::MatrixXd &R, const Eigen::MatrixXd &S)
    {
      const Eigen::LLT<Eigen::MatrixXd> llt(R);
      if (llt.info() == Eigen::Success && llt.rcond() > 1e-14)
        return llt.solve(S);

      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(R);
      const Eigen::VectorXd &lambda = modes.eigenvalues();
      const Eigen::VectorXd  inverse =
        (lambda.array() > 1e-14 * lambda.maxCoeff())
          .select(lambda.cwiseInverse(), 0.);
      return modes.eigenvectors() * inverse.asDiagonal() *
             (modes.eigenvectors().transpose() * S);
    }
  } // namespace



  SubdivisionStage::SubdivisionStage(const Correlation           &correlation,
                                     const Index                 &n_parents,
                                     const std::array<double, 3> &child_size,
                                     const std::string           &path)
    : dim(correlation.dim())
    , n_parents(n_parents)
    , neighbourhoods(std::size_t(1) << 2 * dim)
  {
    Index lags{{1, 1, 1}};
    std::fill_n(lags.begin(), dim, n_lags);
    const std::vector<double> covariance = correlation.table(child_size, lags);

    // Only the neighbourhoods that occur: three positions per direction.
    const FieldLattice positions{3, {{3, 3, 3}}, {}, {}};
    for (std::size_t i = 0; i < positions.n(); ++i)
      {
        Index parent = positions.index(i);
        for (unsigned int d = 0; d < 3; ++d)
          parent[d] = std::min(parent[d] == 2 ? n_parents[d] - 1 : parent[d],
                               n_parents[d] - 1);
        const unsigned int sides = sides_of_parent(parent, n_parents, dim);
        if (neighbourhoods[sides].parents.empty())
          neighbourhoods[sides] = neighbourhood(covariance, sides, path);
      }
  }



  SubdivisionStage::Neighbourhood
  SubdivisionStage::neighbourhood(const std::vector<double> &covariance,
                                  const unsigned int         sides,
                                  const std::string         &path) const
  {
    Index lags{{1, 1, 1}}, first{{0, 0, 0}}, last{{0, 0, 0}}; // parent: 1
    for (unsigned int d = 0; d < dim; ++d)
      {
        lags[d]  = n_lags;
        first[d] = sides >> 2 * d & 1 ? 0 : 1;
        last[d]  = sides >> (2 * d + 1) & 1 ? 2 : 1;
      }
    const unsigned int n_children = 1u << dim;

    // The children of all parents of the neighbourhood, one parent after the
    // other: the averages of each block of 2^dim are the parents.
    Neighbourhood      result;
    std::vector<Index> cells;
    unsigned int       centre = 0; // number of the parent that is split
    for (unsigned int k = first[2]; k <= last[2]; ++k)
      for (unsigned int j = first[1]; j <= last[1]; ++j)
        for (unsigned int i = first[0]; i <= last[0]; ++i)
          {
            const Index    neighbour{{i, j, k}};
            std::ptrdiff_t offset = 0, stride = 1;
            for (unsigned int d = 0; d < dim; ++d)
              {
                offset += (std::ptrdiff_t(neighbour[d]) - 1) * stride;
                stride *= n_parents[d];
              }
            if (offset == 0)
              centre = result.parents.size();
            result.parents.push_back(offset);
            for (unsigned int child = 0; child < n_children; ++child)
              {
                Index cell = child_position(child);
                for (unsigned int d = 0; d < dim; ++d)
                  cell[d] += 2 * neighbour[d];
                cells.push_back(cell);
              }
          }
    const Eigen::Index n = result.parents.size();

    Eigen::MatrixXd among(cells.size(), cells.size());
    for (std::size_t a = 0; a < cells.size(); ++a)
      for (std::size_t b = 0; b < cells.size(); ++b)
        among(a, b) = covariance[lag_index(cells[a], cells[b], lags)];

    Eigen::MatrixXd average = Eigen::MatrixXd::Zero(n, cells.size());
    for (Eigen::Index p = 0; p < n; ++p)
      average.row(p).segment(p * n_children, n_children).array() =
        1. / n_children;

    // The last child is not drawn.
    const unsigned int    n_drawn = n_children - 1;
    const Eigen::MatrixXd R       = average * among * average.transpose();
    const Eigen::MatrixXd S =
      average * among.middleCols(centre * n_children, n_drawn);
    const Eigen::MatrixXd B =
      among.block(centre * n_children, centre * n_children, n_drawn, n_drawn);

    const Eigen::MatrixXd A        = solve_symmetric(R, S);
    Eigen::MatrixXd       residual = B - S.transpose() * A;
    residual                       = (residual + residual.transpose()) / 2;
    const Eigen::MatrixXd C        = covariance_factor(residual, path, B(0, 0));

    result.A.resize(n_drawn * n);
    Eigen::Map<Eigen::MatrixXd>(result.A.data(), n, n_drawn) = A;
    result.C.assign(n_drawn * n_drawn, 0.);
    for (Eigen::Index i = 0; i < C.rows(); ++i)
      for (Eigen::Index j = 0; j < C.cols(); ++j)
        result.C[i * n_drawn + j] = C(i, j);
    return result;
  }



  std::size_t
  SubdivisionStage::n_noise() const
  {
    return std::size_t(n_parents[0]) * n_parents[1] * n_parents[2] *
           ((1u << dim) - 1);
  }



  void
  SubdivisionStage::subdivide(const double *parents,
                              const double *noise,
                              double       *children) const
  {
    const unsigned int n_children = 1u << dim, n_drawn = n_children - 1;

    // Of the children of a parent, from the number of the first one.
    std::array<std::size_t, 3> stride{{1, 0, 0}}; // of the children
    for (unsigned int d = 1; d < dim; ++d)
      stride[d] = stride[d - 1] * 2 * n_parents[d - 1];
    std::array<std::size_t, 8> offset{};
    for (unsigned int child = 0; child < n_children; ++child)
      for (unsigned int d = 0; d < dim; ++d)
        offset[child] += stride[d] * child_position(child)[d];

    std::array<double, 27> around;
    std::size_t            cell = 0;
    for (unsigned int k = 0; k < n_parents[2]; ++k)
      for (unsigned int j = 0; j < n_parents[1]; ++j)
        for (unsigned int i = 0; i < n_parents[0]; ++i, ++cell)
          {
            const Neighbourhood &hood =
              neighbourhoods[sides_of_parent({{i, j, k}}, n_parents, dim)];
            const std::size_t n = hood.parents.size();
            for (std::size_t p = 0; p < n; ++p)
              around[p] = parents[cell + hood.parents[p]];

            double *const first =
              children + 2 * (i * stride[0] + j * stride[1] + k * stride[2]);
            double left = n_children * parents[cell];
            for (unsigned int child = 0; child < n_drawn; ++child)
              {
                const double *A     = hood.A.data() + child * n;
                const double *C     = hood.C.data() + child * n_drawn;
                double        value = 0.;
                for (std::size_t p = 0; p < n; ++p)
                  value += A[p] * around[p];
                for (unsigned int u = 0; u < n_drawn; ++u)
                  value += C[u] * noise[u];
                first[offset[child]] = value;
                left -= value;
              }
            first[offset[n_drawn]] = left; // upward averaging
            noise += n_drawn;
          }
  }
} // namespace Waker
