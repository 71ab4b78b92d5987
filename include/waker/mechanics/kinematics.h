// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_kinematics_h
#define waker_mechanics_kinematics_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

namespace Waker
{
  using namespace dealii;

  /**
   * The motion of a point in one step, from the gradient H of its displacement
   * increment with respect to the start of the step.
   *
   * Objective (Hughes & Winget 1980): strain and spin are taken at mid-step,
   *   G = H (I + H/2)^-1,  strain = sym G,  W = skew G,
   *   Q = (I - W/2)^-1 (I + W/2),
   * and the stress at the start is turned to Q s Q^T. A rigid rotation gives
   * no strain, whatever its angle. Otherwise G = H and Q = I (eq. 2.33 of
   * Remmerswaal 2023).
   */
  template <int dim>
  class Kinematics
  {
  public:
    Kinematics(const Tensor<2, dim> &H, const bool objective);

    /// Strain increment, 3x3 (plane strain in 2D).
    SymmetricTensor<2, 3>
    strain() const;

    /// Q s Q^T
    SymmetricTensor<2, 3>
    turn(const SymmetricTensor<2, 3> &stress) const;

    /// Number of different stress components in dim dimensions.
    static constexpr unsigned int n_stresses = dim * (dim + 1) / 2;

    /**
     * The derivative of the stress at the end of the step with respect to H:
     * material, mid-step strain and rotation together.
     *
     * With Z = (I - W/2)^-1 dW (I + W/2)^-1, d(Q s Q^T) = Z t - t Z for
     * t = Q s Q^T, and a law that acts on an elastic trial stress sees it as
     * the strain (Z t - t Z) / 2G: the commutator has no trace.
     *
     * @param tangent algorithmic tangent of the material (kPa)
     * @param turned t, the turned stress at the start (kPa)
     * @param shear_modulus G of the elastic trial (kPa)
     * @param scale multiplies the result (the point's volume)
     * @param A out: A[a][dim c + d] = scale * d stress_a / d H_cd, with
     *        a = xx, yy, xy in 2D and xx, yy, zz, xy, xz, yz in 3D
     */
    void
    stress_derivative(const SymmetricTensor<4, 3> &tangent,
                      const SymmetricTensor<2, 3> &turned,
                      const double                 shear_modulus,
                      const double                 scale,
                      double (*A)[dim * dim]) const;

  private:
    bool           objective;
    Tensor<2, dim> G; // at mid-step
    Tensor<2, dim> R; // (I + H/2)^-1: dG = R dH R
  };

  /**
   * Q s Q^T in the plane, for the spin W = [[0, w], [-w, 0]] of a step, so
   * that Q = [[c, s], [-s, c]]. On numbers, for loops over many points.
   */
  inline void
  turn_in_plane(const double w, double &xx, double &yy, double &xy)
  {
    const double quarter = 0.25 * w * w;
    const double inverse = 1. / (1. + quarter);
    const double c       = (1. - quarter) * inverse;
    const double s       = w * inverse;
    const double new_xx  = c * c * xx + 2. * c * s * xy + s * s * yy;
    const double new_yy  = s * s * xx - 2. * c * s * xy + c * c * yy;
    xy                   = c * s * (yy - xx) + (c * c - s * s) * xy;
    xx                   = new_xx;
    yy                   = new_yy;
  }


  /**
   * G = H (I + share H/2)^-1 in the plane, in place of H: share = 1 at
   * mid-step, 0 leaves H. On numbers, for loops over many points.
   */
  inline void
  to_mid_step(const double share,
              double      &xx,
              double      &xy,
              double      &yx,
              double      &yy)
  {
    const double half = 0.5 * share;
    const double a = 1. + half * xx, b = half * xy;
    const double c = half * yx, d = 1. + half * yy;
    const double inverse = 1. / (a * d - b * c);
    const double new_xx  = (xx * d - xy * c) * inverse;
    const double new_xy  = (xy * a - xx * b) * inverse;
    const double new_yx  = (yx * d - yy * c) * inverse;
    yy                   = (yy * a - yx * b) * inverse;
    xx                   = new_xx;
    xy                   = new_xy;
    yx                   = new_yx;
  }


  // In line: they run once per point and evaluation.

  template <int dim>
  inline Kinematics<dim>::Kinematics(const Tensor<2, dim> &H,
                                     const bool            objective)
    : objective(objective)
  {
    if (!objective)
      {
        G = H;
        return;
      }
    Tensor<2, dim> M = 0.5 * H;
    for (unsigned int d = 0; d < dim; ++d)
      M[d][d] += 1.;
    R = invert(M);
    G = H * R;
  }


  template <int dim>
  inline SymmetricTensor<2, 3>
  Kinematics<dim>::strain() const
  {
    SymmetricTensor<2, 3> e;
    for (unsigned int i = 0; i < dim; ++i)
      {
        e[i][i] = G[i][i];
        for (unsigned int j = i + 1; j < dim; ++j)
          e[i][j] = 0.5 * (G[i][j] + G[j][i]);
      }
    return e;
  }


  template <>
  inline SymmetricTensor<2, 3>
  Kinematics<2>::turn(const SymmetricTensor<2, 3> &stress) const
  {
    if (!objective)
      return stress;
    SymmetricTensor<2, 3> turned = stress;
    turn_in_plane(0.5 * (G[0][1] - G[1][0]),
                  turned.access_raw_entry(0),
                  turned.access_raw_entry(1),
                  turned.access_raw_entry(3));
    return turned;
  }


  template <>
  SymmetricTensor<2, 3>
  Kinematics<3>::turn(const SymmetricTensor<2, 3> &stress) const;

  template <>
  void
  Kinematics<2>::stress_derivative(const SymmetricTensor<4, 3> &,
                                   const SymmetricTensor<2, 3> &,
                                   const double,
                                   const double,
                                   double (*)[4]) const;

  template <>
  void
  Kinematics<3>::stress_derivative(const SymmetricTensor<4, 3> &,
                                   const SymmetricTensor<2, 3> &,
                                   const double,
                                   const double,
                                   double (*)[9]) const;
} // namespace Waker

#endif
