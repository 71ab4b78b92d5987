// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/kinematics.h>

namespace Waker
{
  namespace
  {
    /// Indices of the independent stresses: a -> (i, j).
    template <int dim>
    struct StressIndices;

    template <>
    struct StressIndices<2>
    {
      static constexpr unsigned int i[3] = {0, 1, 0};
      static constexpr unsigned int j[3] = {0, 1, 1};
    };

    template <>
    struct StressIndices<3>
    {
      static constexpr unsigned int i[6] = {0, 1, 2, 0, 0, 1};
      static constexpr unsigned int j[6] = {0, 1, 2, 1, 2, 2};
    };


    /// (I - W/2)^-1 for the skew part W of G.
    Tensor<2, 3>
    half_spin_inverse(const Tensor<2, 3> &G)
    {
      Tensor<2, 3> A = unit_symmetric_tensor<3>();
      A -= 0.25 * (G - transpose(G));
      return invert(A);
    }
  } // namespace


  template <>
  SymmetricTensor<2, 3>
  Kinematics<3>::turn(const SymmetricTensor<2, 3> &stress) const
  {
    if (!objective)
      return stress;
    const Tensor<2, 3> A = half_spin_inverse(G);
    const Tensor<2, 3> Q = A * transpose(invert(A)); // (I + W/2) = (I - W/2)^T
    return symmetrize(Q * Tensor<2, 3>(stress) * transpose(Q));
  }


  template <>
  void
  Kinematics<2>::stress_derivative(const SymmetricTensor<4, 3> &tangent,
                                   const SymmetricTensor<2, 3> &turned,
                                   const double                 shear_modulus,
                                   const double                 scale,
                                   double (*A)[4]) const
  {
    // The material's tangent on the strains xx, yy and gamma_xy.
    using Indices = StressIndices<2>;
    double D[3][3];
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        D[a][b] =
          scale *
          tangent[Indices::i[a]][Indices::j[a]][Indices::i[b]][Indices::j[b]];

    if (!objective)
      {
        for (unsigned int a = 0; a < 3; ++a)
          {
            A[a][0] = D[a][0];
            A[a][3] = D[a][1];
            A[a][1] = A[a][2] = D[a][2];
          }
        return;
      }

    // Z = [[0, z], [-z, 0]] with z = dw / (1 + w^2/4), and Z t - t Z =
    // 2 z t_xy, -2 z t_xy, z (t_yy - t_xx) in xx, yy, xy.
    const double w      = 0.5 * (G[0][1] - G[1][0]);
    const double factor = 1. / ((1. + 0.25 * w * w) * 2. * shear_modulus);
    const double r_xx   = 2. * turned[0][1] * factor;
    const double r_xy   = (turned[1][1] - turned[0][0]) * factor;

    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int l = 0; l < 2; ++l)
        {
          // dG = R dH R for dH = e_k e_l.
          const double g01   = R[0][k] * R[l][1];
          const double g10   = R[1][k] * R[l][0];
          const double dw    = 0.5 * (g01 - g10);
          const double e_xx  = R[0][k] * R[l][0] + r_xx * dw;
          const double e_yy  = R[1][k] * R[l][1] - r_xx * dw;
          const double gamma = g01 + g10 + 2. * r_xy * dw;
          for (unsigned int a = 0; a < 3; ++a)
            A[a][2 * k + l] = D[a][0] * e_xx + D[a][1] * e_yy + D[a][2] * gamma;
        }
  }


  template <>
  void
  Kinematics<3>::stress_derivative(const SymmetricTensor<4, 3> &tangent,
                                   const SymmetricTensor<2, 3> &turned,
                                   const double                 shear_modulus,
                                   const double                 scale,
                                   double (*A)[9]) const
  {
    using Indices = StressIndices<3>;
    const Tensor<2, 3> t(turned);
    Tensor<2, 3>       spin_inverse;
    if (objective)
      spin_inverse = half_spin_inverse(G);

    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int l = 0; l < 3; ++l)
        {
          Tensor<2, 3> dG;
          if (objective)
            {
              for (unsigned int i = 0; i < 3; ++i)
                for (unsigned int j = 0; j < 3; ++j)
                  dG[i][j] = R[i][k] * R[l][j];
              const Tensor<2, 3> Z = spin_inverse *
                                     (0.5 * (dG - transpose(dG))) *
                                     transpose(spin_inverse);
              dG += (Z * t - t * Z) / (2. * shear_modulus);
            }
          else
            dG[k][l] = 1.;
          const SymmetricTensor<2, 3> stress =
            scale * (tangent * symmetrize(dG));
          for (unsigned int a = 0; a < 6; ++a)
            A[a][3 * k + l] = stress[Indices::i[a]][Indices::j[a]];
        }
  }


  template class Kinematics<2>;
  template class Kinematics<3>;
} // namespace Waker
