// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_logarithmic_strain_h
#define waker_mechanics_logarithmic_strain_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

namespace Waker
{
  using namespace dealii;

  /**
   * A step of a point in logarithmic (Hencky) strain, isotropic:
   *   b = dF exp(2 e) dF^T,  trial = 1/2 ln b,  dF = I + H,
   * with e the elastic strain at the start of the step and H the gradient of
   * its displacement increment (plane strain in 2D). The material acts on
   * `trial` as in small strain, and gives the Kirchhoff stress. The law is
   * hyperelastic where it is elastic: what happens in a step does not depend on
   * its length (Coombs & Augarde 2020, AMPLE; Simo 1992).
   *
   * Strains of any size keep their relative accuracy: b - 1 is what is
   * computed, not b.
   */
  template <int dim>
  class LogarithmicStep
  {
  public:
    LogarithmicStep() = default;

    /// @param elastic_strain e, from the Kirchhoff stress at the start
    LogarithmicStep(const Tensor<2, dim>        &H,
                    const SymmetricTensor<2, 3> &elastic_strain);

    /// 1/2 ln b; not a number if dF turns the point inside out.
    const SymmetricTensor<2, 3> &
    trial_strain() const
    {
      return trial;
    }

    /// det dF: the ratio of the volumes at the end and the start.
    double
    volume_ratio() const
    {
      return ratio;
    }

    /// First Piola-Kirchhoff stress relative to the start of the step, per
    /// volume without stress (kPa): tau dF^-T. Times that volume and grad S_ip
    /// at the start of the step it is the internal force in the deformed
    /// place.
    Tensor<2, dim>
    first_piola(const SymmetricTensor<2, 3> &kirchhoff) const;

    /**
     * The derivative of first_piola() with respect to H.
     *
     * @param D d kirchhoff_a / d trial_b (kPa), trial_b as a tensor's entry,
     *        taken once; a, b = xx, yy, xy in 2D and xx, yy, zz, xy, xz, yz in
     *        3D
     * @param scale multiplies the result (the point's volume without stress)
     * @param A out: A[dim i + j][dim k + l] = scale d P_ij / d H_kl
     */
    void
    derivative(const double (&D)[dim * (dim + 1) / 2][dim * (dim + 1) / 2],
               const SymmetricTensor<2, 3> &kirchhoff,
               const double                 scale,
               double (&A)[dim * dim][dim * dim]) const;

  private:
    double                ratio;
    Tensor<2, dim>        inverse; // dF^-1
    Tensor<2, dim>        Q;       // eigenvectors of b as columns
    double                c[dim];  // eigenvalues of b, less 1
    SymmetricTensor<2, 3> trial;
  };


  /// Elastic strain of an isotropic material under this stress.
  inline SymmetricTensor<2, 3>
  elastic_strain(const SymmetricTensor<2, 3> &stress,
                 const double                 bulk_modulus,
                 const double                 shear_modulus)
  {
    const double          p      = trace(stress) / 3.;
    SymmetricTensor<2, 3> strain = stress / (2. * shear_modulus);
    for (unsigned int d = 0; d < 3; ++d)
      strain[d][d] += p / (3. * bulk_modulus) - p / (2. * shear_modulus);
    return strain;
  }
} // namespace Waker

#endif
