// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/von_mises_softening.h>

#include "softening_history.h"
#include <algorithm>
#include <cmath>
#include <sstream>

namespace Waker
{
  namespace
  {
    const double sqrt_3 = std::sqrt(3.);
  }


  VonMisesSoftening::VonMisesSoftening(
    const double                         density,
    const double                         youngs_modulus,
    const double                         poissons_ratio,
    const InitialValue                  &initial_strength,
    const InitialValue                  &residual_strength,
    const double                         softening_modulus,
    const Invariant                      invariant,
    const std::optional<InitialValue>   &overconsolidation_ratio,
    const SofteningMeasure              &measure,
    const std::vector<MaterialVariable> &coefficients)
    : LinearElastic(density, youngs_modulus, poissons_ratio)
    , initial_strength(initial_strength)
    , residual_strength(residual_strength)
    , plastic_strain_factor(invariant == Invariant::equivalent ? 1.
                                                               : sqrt_3 / 2.)
    , softening(measure.is_local()
                  ? measure.own * softening_modulus * plastic_strain_factor
                  : 0.)
    , overconsolidation_ratio(overconsolidation_ratio)
    , measure(measure)
    , softening_modulus(softening_modulus)
    , strength_coefficients(coefficients)
  {
    Assert(3. * G + sqrt_3 * measure.of_uniform_strain() * softening_modulus *
                      plastic_strain_factor >
             0.,
           ExcMessage("the softening modulus snaps back"));
  }


  std::vector<MaterialVariable>
  VonMisesSoftening::variables() const
  {
    using Role                         = MaterialVariable::Role;
    std::vector<MaterialVariable> list = {
      {"undrained shear strength",
       "kPa",
       initial_strength,
       Role::strength,
       "initial_strength"},
      {"residual strength",
       "kPa",
       residual_strength,
       Role::residual_strength,
       "",
       "undrained shear strength"},
      {"plastic strain", "-", 0., Role::history}};
    if (overconsolidation_ratio)
      list.push_back({"overconsolidation ratio",
                      "-",
                      *overconsolidation_ratio,
                      Role::history});
    if (!measure.is_local())
      append_softening_history(list);
    add_stiffness_ratio(list);
    return list;
  }


  bool
  VonMisesSoftening::can_soften(const double *variables) const
  {
    return softening_modulus < 0. && variables[0] > variables[1];
  }


  void
  VonMisesSoftening::soften(const double increment, double *variables) const
  {
    const double growth =
      grow_softening_strain(increment,
                            variables + (overconsolidation_ratio ? 4 : 3));
    const double residual = std::min(variables[1], variables[0]);
    variables[0] =
      std::max(residual, variables[0] + softening_modulus * growth);
  }


  double
  VonMisesSoftening::least_stiffness_ratio() const
  {
    return -sqrt_3 * measure.of_uniform_strain() * softening_modulus *
           plastic_strain_factor / (3. * G);
  }


  std::optional<std::pair<unsigned int, std::string>>
  VonMisesSoftening::initial_problem(const std::vector<double> &variables) const
  {
    const double initial = variables[0], residual = variables[1];
    if (!(initial > 0. && std::isfinite(initial)))
      return {{0, "a finite number above 0 (kPa) at every point"}};
    if (!(residual >= 0. && residual <= initial))
      {
        std::ostringstream text;
        text << "from 0 to the initial strength at every point, here "
             << initial << " kPa";
        return {{1, text.str()}};
      }
    // Of soil that has never borne less than now it is 1, but for round-off.
    if (overconsolidation_ratio && !(variables[3] >= 1. - 1e-9))
      return {{3,
               "at least 1 at every point: no less daily stress, or more POP, "
               "than the stress of now"}};
    return Material::initial_problem(variables);
  }


  double
  VonMisesSoftening::update(const SymmetricTensor<2, 3> &strain_increment,
                            SymmetricTensor<2, 3>       &stress,
                            double                      *variables,
                            SymmetricTensor<4, 3>       *tangent) const
  {
    double &strength = variables[0];
    // A weak point may be given less strength than its residual one: it stays.
    const double residual       = std::min(variables[1], variables[0]);
    double      &plastic_strain = variables[2];
    const double ratio          = stiffness_ratio(variables);
    const double K = ratio * this->K, G = ratio * this->G;

    // The trial stress, component by component: this is the hottest function
    // of the program, and tensor expressions cost it a factor of two.
    const double volumetric = strain_increment.access_raw_entry(0) +
                              strain_increment.access_raw_entry(1) +
                              strain_increment.access_raw_entry(2);
    const double mean_add = (K - 2. / 3. * G) * volumetric;
    double       s[6]; // xx, yy, zz, xy, xz, yz
    for (unsigned int a = 0; a < 6; ++a)
      s[a] = stress.access_raw_entry(a) +
             2. * G * strain_increment.access_raw_entry(a) +
             (a < 3 ? mean_add : 0.);
    const double pressure = (s[0] + s[1] + s[2]) / 3.;
    for (unsigned int a = 0; a < 3; ++a)
      s[a] -= pressure;
    const double squared = s[0] * s[0] + s[1] * s[1] + s[2] * s[2] +
                           2. * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);

    // q^2 = 3/2 s:s against 3 c^2.
    if (squared <= 2. * strength * strength)
      {
        for (unsigned int a = 0; a < 6; ++a)
          stress.access_raw_entry(a) = s[a] + (a < 3 ? pressure : 0.);
        if (tangent != nullptr)
          *tangent = ratio * elastic_tangent;
        return 0.;
      }

    // Radial return, closed form: the strength after the step is linear in the
    // multiplier until it reaches its residual value.
    const double q            = std::sqrt(1.5 * squared); // sqrt(3 J_2)
    double       hardening    = strength > residual ? sqrt_3 * softening : 0.;
    double       multiplier   = (q - sqrt_3 * strength) / (3. * G + hardening);
    double       new_strength = strength + hardening / sqrt_3 * multiplier;
    if (new_strength < residual)
      {
        new_strength = residual;
        hardening    = 0.;
        multiplier   = (q - sqrt_3 * residual) / (3. * G);
      }
    const double scale = sqrt_3 * new_strength / q;

    for (unsigned int a = 0; a < 6; ++a)
      stress.access_raw_entry(a) = scale * s[a] + (a < 3 ? pressure : 0.);
    strength = new_strength;
    plastic_strain += plastic_strain_factor * multiplier;

    if (tangent != nullptr)
      {
        // K 1x1 + 2G (b1 I_dev - b2 n x n): radial return with linear
        // hardening (Simo & Hughes 1998, box 3.2).
        const double beta2      = scale - hardening / (3. * G + hardening);
        const double factor     = 2. * G * beta2 / squared; // n n = s s / s:s
        const double extra_bulk = (1. - scale) * K;
        for (unsigned int a = 0; a < 6; ++a)
          for (unsigned int b = 0; b < 6; ++b)
            tangent->access_raw_entry(6 * a + b) =
              scale * ratio * elastic_tangent.access_raw_entry(6 * a + b) -
              factor * s[a] * s[b] + (a < 3 && b < 3 ? extra_bulk : 0.);
      }
    return sqrt_3 * new_strength * multiplier;
  }
} // namespace Waker
