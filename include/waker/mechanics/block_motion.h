// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_block_motion_h
#define waker_mechanics_block_motion_h

#include <waker/materials/material.h>

namespace Waker
{
  /// Stress of the point l of a block, by components (kPa).
  inline SymmetricTensor<2, 3>
  block_stress(const double (*stresses)[Material::block_size],
               const unsigned int l)
  {
    SymmetricTensor<2, 3> stress;
    for (unsigned int a = 0; a < 6; ++a)
      stress.access_raw_entry(a) = stresses[a][l];
    return stress;
  }


  /**
   * Kinematics (mechanics/kinematics.h) for the points of a block, point last:
   * in 2D loops of fixed length on plain numbers, which the compiler makes a
   * few vector instructions of.
   */
  template <int dim>
  struct BlockMotion
  {
    static constexpr unsigned int N          = Material::block_size;
    static constexpr unsigned int n_stresses = dim * (dim + 1) / 2;

    /// The independent stresses in dim dimensions, as entries of a symmetric
    /// 3x3 tensor.
    static constexpr unsigned int components[6] =
      {0, 1, dim == 2 ? 3 : 2, 3, 4, 5};

    /// Gradients of the displacement increment, [dim i + j]; unused entries
    /// are zero.
    double H[dim * dim][N];
    bool   objective_rate;

    /// The strain increments of the block, and its stresses turned with it.
    void
    move(Material::Block &block) const;

    /**
     * Kinematics::stress_derivative().
     *
     * @param D material tangents, [n_stresses a + b] (kPa)
     * @param turned stresses at the start, turned (kPa)
     * @param scale of the result: the points' volumes
     * @param A out: [a][dim c + d] = scale d stress_a / d H_cd
     */
    void
    stress_derivative(const double (*D)[N],
                      const double (*turned)[N],
                      const double  shear_modulus,
                      const double *scale,
                      double (*A)[dim * dim][N]) const;

    /// All normal stresses: in 2D xx, yy, zz, xy.
    static constexpr unsigned int n_full_stresses = dim == 2 ? 4 : 6;

    /// The same for these, with D[n_full_stresses a + b].
    void
    full_stress_derivative(const double (*D)[N],
                           const double (*turned)[N],
                           const double  shear_modulus,
                           const double *scale,
                           double (*A)[dim * dim][N]) const;
  };
} // namespace Waker

#endif
