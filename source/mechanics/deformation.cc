// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/deformation.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// Diagonal of sqrt(F^T F).
    Tensor<1, 2>
    stretches(const Tensor<2, 2> &F)
    {
      // U = (C + sqrt(det C)) / sqrt(tr C + 2 sqrt(det C))
      const Tensor<2, 2> C    = transpose(F) * F;
      const double       J    = std::abs(determinant(F));
      const double       norm = std::sqrt(trace(C) + 2. * J);
      Tensor<1, 2>       U;
      for (unsigned int d = 0; d < 2; ++d)
        U[d] = (C[d][d] + J) / norm;
      return U;
    }


    Tensor<1, 3>
    stretches(const Tensor<2, 3> &F)
    {
      const Tensor<2, 3> C = transpose(F) * F;
      Eigen::Matrix3d    matrix;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          matrix(i, j) = C[i][j];
      const Eigen::Matrix3d root =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix).operatorSqrt();
      Tensor<1, 3> U;
      for (unsigned int d = 0; d < 3; ++d)
        U[d] = root(d, d);
      return U;
    }
  } // namespace


  template <int dim>
  void
  prepare_domains(const SupportDomains domains, MaterialPoints<dim> &points)
  {
    if (domains == SupportDomains::constant)
      return;
    points.initial_half_size = points.half_size;
    points.deformation.assign(points.n_points(), unit_symmetric_tensor<dim>());
  }


  template <int dim>
  std::size_t
  move_domains(const SupportDomains domains,
               const double         cell_size,
               MaterialPoints<dim> &points)
  {
    if (domains == SupportDomains::constant)
      return 0;
    const double longest = 0.5 * cell_size;
    std::size_t  n_held  = 0;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const Tensor<1, dim> U    = stretches(points.deformation[p]);
        bool                 held = false;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double l         = points.initial_half_size[p][d] * U[d];
            held                   = held || l > longest;
            points.half_size[p][d] = std::min(l, longest);
          }
        n_held += held;
      }
    return n_held;
  }


  template void
  prepare_domains(const SupportDomains, MaterialPoints<2> &);
  template void
  prepare_domains(const SupportDomains, MaterialPoints<3> &);
  template std::size_t
  move_domains(const SupportDomains, const double, MaterialPoints<2> &);
  template std::size_t
  move_domains(const SupportDomains, const double, MaterialPoints<3> &);
} // namespace Waker
