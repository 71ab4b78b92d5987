// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/stencil.h>
#include <waker/mechanics/consistent_tangent.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    constexpr std::size_t N = Material::block_size;


    /// Row of the stress (c, d) in A.
    template <int dim>
    constexpr unsigned int
    row(const unsigned int c, const unsigned int d)
    {
      return c == d ? c : (dim == 2 ? 2 : c + d + 2);
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
    const Stencil<dim> stencil(weights->background_grid());
    diagonal = 0.;
    tangents.resize((points.n_points() + N - 1) / N);
    for (std::size_t b = 0; b < tangents.size(); ++b)
      {
        stress_update.tangent(points, b, tangents[b]);
        const auto       &A        = tangents[b].A;
        const std::size_t n_points = std::min(N, points.n_points() - b * N);
        for (unsigned int l = 0; l < n_points; ++l)
          {
            // C[c]: what A does to one component alone.
            Tensor<2, dim> C[dim];
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                for (unsigned int e = 0; e < dim; ++e)
                  C[c][d][e] = A[row<dim>(c, d)][dim * c + e][l];
            stencil.scatter_quadratic((*weights)[b * N + l],
                                      C,
                                      diagonal.begin());
          }
      }
  }


  template <int dim>
  void
  ConsistentTangent<dim>::point_tangent(
    const std::size_t p,
    double (&A)[dim * (dim + 1) / 2][dim * dim]) const
  {
    for (unsigned int a = 0; a < dim * (dim + 1) / 2; ++a)
      for (unsigned int k = 0; k < dim * dim; ++k)
        A[a][k] = tangents[p / N].A[a][k][p % N];
  }


  template <int dim>
  void
  ConsistentTangent<dim>::vmult(NodalVector &dst, const NodalVector &src) const
  {
    constexpr unsigned int n_stresses = dim * (dim + 1) / 2;
    const Stencil<dim>     stencil(weights->background_grid());
    const double *const    u = src.begin();
    dst                      = 0.;
    double *const f          = dst.begin();

    double H[dim * dim][N] = {}, s[n_stresses][N];
    for (std::size_t begin = 0; begin < weights->size(); begin += N)
      {
        const std::size_t n_points = std::min(N, weights->size() - begin);
        for (unsigned int l = 0; l < n_points; ++l)
          {
            const Tensor<2, dim> gradient =
              stencil.gradient((*weights)[begin + l], u);
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                H[dim * c + d][l] = gradient[c][d];
          }

        // The change of V stress.
        const auto &A = tangents[begin / N].A;
        for (unsigned int a = 0; a < n_stresses; ++a)
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
                P[c][d] = s[row<dim>(c, d)][l];
            stencil.scatter_gradient((*weights)[begin + l], P, f);
          }
      }
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
