// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/stencil.h>
#include <waker/mechanics/consistent_tangent.h>

namespace Waker
{
  namespace
  {
    /// P = A : H, the change of V stress.
    inline Tensor<2, 2>
    apply(const StressUpdate<2>::PointTangent &t, const Tensor<2, 2> &H)
    {
      double s[3];
      for (unsigned int a = 0; a < 3; ++a)
        s[a] = t.A[a][0] * H[0][0] + t.A[a][1] * H[0][1] + t.A[a][2] * H[1][0] +
               t.A[a][3] * H[1][1];
      Tensor<2, 2> P;
      P[0][0] = s[0];
      P[1][1] = s[1];
      P[0][1] = P[1][0] = s[2];
      return P;
    }


    inline Tensor<2, 3>
    apply(const StressUpdate<3>::PointTangent &t, const Tensor<2, 3> &H)
    {
      double s[6];
      for (unsigned int a = 0; a < 6; ++a)
        {
          s[a] = 0.;
          for (unsigned int c = 0; c < 3; ++c)
            for (unsigned int d = 0; d < 3; ++d)
              s[a] += t.A[a][3 * c + d] * H[c][d];
        }
      Tensor<2, 3> P;
      P[0][0] = s[0];
      P[1][1] = s[1];
      P[2][2] = s[2];
      P[0][1] = P[1][0] = s[3];
      P[0][2] = P[2][0] = s[4];
      P[1][2] = P[2][1] = s[5];
      return P;
    }


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
  {}


  template <int dim>
  void
  ConsistentTangent<dim>::reinit(const StressUpdate<dim>   &stress_update,
                                 const MaterialPoints<dim> &points)
  {
    stress_update.tangents(points, tangents);
  }


  template <int dim>
  void
  ConsistentTangent<dim>::vmult(NodalVector &dst, const NodalVector &src) const
  {
    const Stencil<dim>  stencil(weights->background_grid());
    const double *const u = src.begin();
    dst                   = 0.;
    double *const f       = dst.begin();
    for (std::size_t p = 0; p < tangents.size(); ++p)
      stencil.scatter_gradient((*weights)[p],
                               apply(tangents[p],
                                     stencil.gradient((*weights)[p], u)),
                               f);
  }


  template <int dim>
  void
  ConsistentTangent<dim>::add_diagonal(NodalVector &diagonal) const
  {
    const Stencil<dim> stencil(weights->background_grid());
    double *const      f = diagonal.begin();
    for (std::size_t p = 0; p < tangents.size(); ++p)
      {
        // C[c]: what A does to one component alone.
        const auto    &A = tangents[p].A;
        Tensor<2, dim> C[dim];
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int e = 0; e < dim; ++e)
              C[c][d][e] = A[row<dim>(c, d)][dim * c + e];
        stencil.scatter_quadratic((*weights)[p], C, f);
      }
  }


  template class ConsistentTangent<2>;
  template class ConsistentTangent<3>;
} // namespace Waker
