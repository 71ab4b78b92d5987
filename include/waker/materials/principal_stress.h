// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_materials_principal_stress_h
#define waker_materials_principal_stress_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>

namespace Waker
{
  using namespace dealii;

  /// Principal stresses, largest first (tension positive), and the unit
  /// vectors of their directions: sum_i value_i direction_i x direction_i.
  struct PrincipalStress
  {
    std::array<double, 3>       value;     // kPa
    std::array<Tensor<1, 3>, 3> direction; // orthonormal
  };

  /// In closed form where z is a principal direction, as in plane strain; else
  /// by deal.II.
  PrincipalStress
  principal_stress(const SymmetricTensor<2, 3> &stress);

  /// The stress with other principal values in the same directions.
  SymmetricTensor<2, 3>
  with_values(const std::array<double, 3>       &value,
              const std::array<Tensor<1, 3>, 3> &direction);

  /**
   * The derivative of a stress that is an isotropic function of another one:
   * with the same directions, and values that depend on the other's (de Souza
   * Neto et al. 2008, box A.6). Where values of the argument are equal, those
   * of the result are, too, and the quotient of differences becomes its limit.
   *
   * @param argument where the derivative is taken
   * @param value of the result
   * @param slope [i][j] = d value_i / d argument.value_j
   * @param two_G, lame the argument is itself the stress of an elastic strain,
   *        D = lame 1 x 1 + two_G I (kPa): then by that strain
   */
  SymmetricTensor<4, 3>
  isotropic_derivative(const PrincipalStress       &argument,
                       const std::array<double, 3> &value,
                       const double (&slope)[3][3],
                       const double two_G = 1.,
                       const double lame  = 0.);
} // namespace Waker

#endif
