// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/von_mises_softening.h>

#include <cmath>

namespace Waker
{
  namespace
  {
    const double sqrt_3 = std::sqrt(3.);
  }


  VonMisesSoftening::VonMisesSoftening(const double    density,
                                       const double    youngs_modulus,
                                       const double    poissons_ratio,
                                       const double    initial_strength,
                                       const double    residual_strength,
                                       const double    softening_modulus,
                                       const Invariant invariant)
    : LinearElastic(density, youngs_modulus, poissons_ratio)
    , initial_strength(initial_strength)
    , residual_strength(residual_strength)
    , plastic_strain_factor(invariant == Invariant::equivalent ? 1.
                                                               : sqrt_3 / 2.)
    , softening(softening_modulus * plastic_strain_factor)
  {
    Assert(3. * G + sqrt_3 * softening > 0.,
           ExcMessage("the softening modulus snaps back"));
  }


  std::vector<MaterialVariable>
  VonMisesSoftening::variables() const
  {
    return {{"undrained shear strength", "kPa", initial_strength, false},
            {"residual strength", "kPa", residual_strength, true},
            {"plastic strain", "-", 0., false}};
  }


  double
  VonMisesSoftening::update(const SymmetricTensor<2, 3> &strain_increment,
                            SymmetricTensor<2, 3>       &stress,
                            double                      *variables,
                            SymmetricTensor<4, 3>       *tangent) const
  {
    double      &strength       = variables[0];
    const double residual       = variables[1];
    double      &plastic_strain = variables[2];

    add_elastic_stress(strain_increment, stress); // the trial stress
    const double                pressure = trace(stress) / 3.;
    const SymmetricTensor<2, 3> s        = deviator(stress);
    const double                q = std::sqrt(1.5) * s.norm(); // sqrt(3 J_2)

    if (q <= sqrt_3 * strength)
      {
        if (tangent != nullptr)
          *tangent = elastic_tangent;
        return 0.;
      }

    // Radial return, closed form: the strength after the step is linear in the
    // multiplier until it reaches its residual value.
    double hardening    = strength > residual ? sqrt_3 * softening : 0.; // dq
    double multiplier   = (q - sqrt_3 * strength) / (3. * G + hardening);
    double new_strength = strength + hardening / sqrt_3 * multiplier;
    if (new_strength < residual)
      {
        new_strength = residual;
        hardening    = 0.;
        multiplier   = (q - sqrt_3 * residual) / (3. * G);
      }
    const double scale = sqrt_3 * new_strength / q;

    stress   = scale * s + pressure * unit_symmetric_tensor<3>();
    strength = new_strength;
    plastic_strain += plastic_strain_factor * multiplier;

    if (tangent != nullptr)
      {
        // K 1x1 + 2G (b1 I_dev - b2 n x n): numerics of a radial return with
        // linear hardening (Simo & Hughes 1998, box 3.2).
        const SymmetricTensor<2, 3> n = s / s.norm();
        const double beta2 = scale - hardening / (3. * G + hardening);
        *tangent =
          scale * elastic_tangent - (2. * G * beta2) * outer_product(n, n);
        const double extra_bulk = (1. - scale) * K;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            (*tangent)[i][i][j][j] += extra_bulk;
      }
    return sqrt_3 * new_strength * multiplier;
  }
} // namespace Waker
