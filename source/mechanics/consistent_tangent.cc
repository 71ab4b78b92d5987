// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/stencil.h>
#include <waker/mechanics/consistent_tangent.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    constexpr std::size_t N = Material::block_size;


    /// Row of the stress (c, d) in an A of n_rows.
    template <int dim, unsigned int n_rows = dim *(dim + 1) / 2>
    constexpr unsigned int
    row(const unsigned int c, const unsigned int d)
    {
      return n_rows == dim * dim ? dim * c + d
             : c == d            ? c
                                 : (dim == 2 ? 2 : c + d + 2);
    }


    /// f += sum over the points of (A : grad u) grad S_ip.
    template <int dim, unsigned int n_rows, typename Tangents>
    void
    multiply(const Weights<dim> &weights,
             const Tangents     &tangents,
             const double       *u,
             double             *f)
    {
      const Stencil<dim> stencil(weights.background_grid());
      double             H[dim * dim][N] = {}, s[n_rows][N];
      for (std::size_t begin = 0; begin < weights.size(); begin += N)
        {
          const std::size_t n_points = std::min(N, weights.size() - begin);
          for (unsigned int l = 0; l < n_points; ++l)
            {
              const Tensor<2, dim> gradient =
                stencil.gradient(weights[begin + l], u);
              for (unsigned int c = 0; c < dim; ++c)
                for (unsigned int d = 0; d < dim; ++d)
                  H[dim * c + d][l] = gradient[c][d];
            }

          // The change of V stress.
          const auto &A = tangents[begin / N].A;
          for (unsigned int a = 0; a < n_rows; ++a)
            for (unsigned int l = 0; l < N; ++l)
              {
                double sum = 0.;
                for (unsigned int k = 0; k < dim * dim; ++k)
                  sum += A[a][k][l] * H[k][l];
                s[a][l] = sum;
              }

          for (unsigned int l = 0; l < n_points; ++l)
            {
              Tensor<2, dim> P;
              for (unsigned int c = 0; c < dim; ++c)
                for (unsigned int d = 0; d < dim; ++d)
                  P[c][d] = s[row<dim, n_rows>(c, d)][l];
              stencil.scatter_gradient(weights[begin + l], P, f);
            }
        }
    }


    /// diagonal += that of the points of a block.
    template <int dim, unsigned int n_rows, typename Tangent>
    void
    add_block_diagonal(const Weights<dim> &weights,
                       const std::size_t   b,
                       const Tangent      &tangent,
                       double             *diagonal)
    {
      const Stencil<dim> stencil(weights.background_grid());
      const std::size_t  n_points = std::min(N, weights.size() - b * N);
      for (unsigned int l = 0; l < n_points; ++l)
        {
          // C[c]: what A does to one component alone.
          Tensor<2, dim> C[dim];
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              for (unsigned int e = 0; e < dim; ++e)
                C[c][d][e] = tangent.A[row<dim, n_rows>(c, d)][dim * c + e][l];
          stencil.scatter_quadratic(weights[b * N + l], C, diagonal);
        }
    }
  } // namespace


  template <int dim>
  ConsistentTangent<dim>::ConsistentTangent(const Weights<dim> &weights)
    : weights(&weights)
    , diagonal(weights.background_grid().n_dofs())
  {}


  template <int dim>
  void
  ConsistentTangent<dim>::reinit(const StressUpdate<dim>   &stress_update,
                                 const MaterialPoints<dim> &points)
  {
    // The diagonal goes along, while a block's tangents are at hand.
    const std::size_t n_blocks = (points.n_points() + N - 1) / N;
    diagonal                   = 0.;
    if (stress_update.is_logarithmic())
      {
        tangents.clear();
        full_tangents.resize(n_blocks);
        for (std::size_t b = 0; b < n_blocks; ++b)
          {
            stress_update.tangent(points, b, full_tangents[b]);
            add_block_diagonal<dim, dim * dim>(*weights,
                                               b,
                                               full_tangents[b],
                                               diagonal.begin());
          }
        return;
      }
    full_tangents.clear();
    tangents.resize(n_blocks);
    for (std::size_t b = 0; b < n_blocks; ++b)
      {
        stress_update.tangent(points, b, tangents[b]);
        add_block_diagonal<dim, dim *(dim + 1) / 2>(*weights,
                                                    b,
                                                    tangents[b],
                                                    diagonal.begin());
      }
  }


  template <int dim>
  void
  ConsistentTangent<dim>::point_tangent(
    const std::size_t p,
    double (&A)[dim * (dim + 1) / 2][dim * dim]) const
  {
    Assert(full_tangents.empty(), ExcInternalError());
    for (unsigned int a = 0; a < dim * (dim + 1) / 2; ++a)
      for (unsigned int k = 0; k < dim * dim; ++k)
        A[a][k] = tangents[p / N].A[a][k][p % N];
  }


  template <int dim>
  void
  ConsistentTangent<dim>::vmult(NodalVector &dst, const NodalVector &src) const
  {
    dst = 0.;
    if (!full_tangents.empty())
      multiply<dim, dim * dim>(*weights,
                               full_tangents,
                               src.begin(),
                               dst.begin());
    else
      multiply<dim, dim *(dim + 1) / 2>(*weights,
                                        tangents,
                                        src.begin(),
                                        dst.begin());
  }


  template <int dim>
  void
  ConsistentTangent<dim>::add_diagonal(NodalVector &result) const
  {
    result += diagonal;
  }


  template class ConsistentTangent<2>;
  template class ConsistentTangent<3>;
} // namespace Waker
