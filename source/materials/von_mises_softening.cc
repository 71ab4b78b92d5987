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
    const double                       density,
    const double                       youngs_modulus,
    const double                       poissons_ratio,
    const InitialValue                &initial_strength,
    const InitialValue                &residual_strength,
    const double                       softening_modulus,
    const Invariant                    invariant,
    const std::optional<InitialValue> &overconsolidation_ratio,
    const SofteningMeasure            &measure)
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
          *tangent = elastic_tangent;
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
              scale * elastic_tangent.access_raw_entry(6 * a + b) -
              factor * s[a] * s[b] + (a < 3 && b < 3 ? extra_bulk : 0.);
      }
    return sqrt_3 * new_strength * multiplier;
  }


  void
  VonMisesSoftening::update_block(const unsigned int, Block &block) const
  {
    // As update(), without branches. Unused entries are computed and ignored:
    // a loop of fixed length is a few vector instructions.
    const double *const e0          = block.strain_increment[0];
    const double *const e1          = block.strain_increment[1];
    const double *const e2          = block.strain_increment[2];
    const double *const e3          = block.strain_increment[3];
    const double *const e4          = block.strain_increment[4];
    const double *const e5          = block.strain_increment[5];
    double *const       s0          = block.stress[0];
    double *const       s1          = block.stress[1];
    double *const       s2          = block.stress[2];
    double *const       s3          = block.stress[3];
    double *const       s4          = block.stress[4];
    double *const       s5          = block.stress[5];
    double *const       strength    = block.variables[0];
    const double *const residual    = block.variables[1];
    double *const       plastic     = block.variables[2];
    double *const       dissipation = block.dissipation;

    const double lambda = K - 2. / 3. * G, two_G = 2. * G, three_G = 3. * G;
    const double slope = sqrt_3 * softening, factor = plastic_strain_factor;
    // Divisions are what such a loop costs: it has one, and one root.
    const double third = 1. / 3., softening_per_multiplier = slope / sqrt_3;
    const double per_elastic   = 1. / three_G,
                 per_softening = 1. / (three_G + slope);
#pragma GCC ivdep
    for (unsigned int l = 0; l < block_size; ++l)
      {
        const double add     = lambda * (e0[l] + e1[l] + e2[l]);
        const double xx      = s0[l] + two_G * e0[l] + add;
        const double yy      = s1[l] + two_G * e1[l] + add;
        const double zz      = s2[l] + two_G * e2[l] + add;
        const double xy      = s3[l] + two_G * e3[l];
        const double xz      = s4[l] + two_G * e4[l];
        const double yz      = s5[l] + two_G * e5[l];
        const double p       = (xx + yy + zz) * third;
        const double squared = (xx - p) * (xx - p) + (yy - p) * (yy - p) +
                               (zz - p) * (zz - p) +
                               2. * (xy * xy + xz * xz + yz * yz);

        const double c_old  = strength[l];
        const double c_r    = std::min(residual[l], c_old);
        const bool   yields = squared > 2. * c_old * c_old;
        const double q      = std::sqrt(yields ? 1.5 * squared : 1.);

        const bool   softens = c_old > c_r;
        const double first =
          (q - sqrt_3 * c_old) * (softens ? per_softening : per_elastic);
        const double c_new =
          c_old + (softens ? softening_per_multiplier : 0.) * first;
        const bool   at_residual = c_new < c_r;
        const double c           = at_residual ? c_r : c_new;
        const double multiplier =
          at_residual ? (q - sqrt_3 * c_r) * per_elastic : first;
        const double scale = yields ? sqrt_3 * c / q : 1.;

        s0[l]          = scale * (xx - p) + p;
        s1[l]          = scale * (yy - p) + p;
        s2[l]          = scale * (zz - p) + p;
        s3[l]          = scale * xy;
        s4[l]          = scale * xz;
        s5[l]          = scale * yz;
        strength[l]    = yields ? c : c_old;
        plastic[l]     = plastic[l] + (yields ? factor * multiplier : 0.);
        dissipation[l] = yields ? sqrt_3 * c * multiplier : 0.;
      }
  }


  void
  VonMisesSoftening::tangent_block(const unsigned int,
                                   Block              &block,
                                   const unsigned int  n_components,
                                   const unsigned int *components,
                                   double (*tangent)[block_size]) const
  {
    // As update(), without branches: the deviator of the trial stress, and
    // the factors of the terms of the tangent.
    double(*const e)[block_size] = block.strain_increment;
    double(*const s)[block_size] = block.stress;
    const double *const strength = block.variables[0];
    const double *const residual = block.variables[1];
    double              share[block_size], factor[block_size];
    const double lambda = K - 2. / 3. * G, two_G = 2. * G, three_G = 3. * G;
    const double slope = sqrt_3 * softening;
    const double third = 1. / 3., softening_per_multiplier = slope / sqrt_3;
    const double per_elastic   = 1. / three_G,
                 per_softening = 1. / (three_G + slope);
#pragma GCC ivdep
    for (unsigned int l = 0; l < block_size; ++l)
      {
        const double add = lambda * (e[0][l] + e[1][l] + e[2][l]);
        const double xx  = s[0][l] + two_G * e[0][l] + add;
        const double yy  = s[1][l] + two_G * e[1][l] + add;
        const double zz  = s[2][l] + two_G * e[2][l] + add;
        const double xy  = s[3][l] + two_G * e[3][l];
        const double xz  = s[4][l] + two_G * e[4][l];
        const double yz  = s[5][l] + two_G * e[5][l];
        const double p   = (xx + yy + zz) * third;

        s[0][l]              = xx - p;
        s[1][l]              = yy - p;
        s[2][l]              = zz - p;
        s[3][l]              = xy;
        s[4][l]              = xz;
        s[5][l]              = yz;
        const double squared = (xx - p) * (xx - p) + (yy - p) * (yy - p) +
                               (zz - p) * (zz - p) +
                               2. * (xy * xy + xz * xz + yz * yz);

        const double c_old   = strength[l];
        const double c_r     = std::min(residual[l], c_old);
        const bool   yields  = squared > 2. * c_old * c_old;
        const double q       = std::sqrt(yields ? 1.5 * squared : 1.);
        const double per_q   = 1. / q;
        const bool   softens = c_old > c_r;
        const double first =
          (q - sqrt_3 * c_old) * (softens ? per_softening : per_elastic);
        const double c_new =
          c_old + (softens ? softening_per_multiplier : 0.) * first;
        const bool   at_residual = c_new < c_r;
        const double c           = at_residual ? c_r : c_new;
        const double hardening =
          softens && !at_residual ? slope * per_softening : 0.;
        const double scale = sqrt_3 * c * per_q;
        share[l]           = yields ? scale : 1.;
        // n x n = s x s / s:s, with q^2 = 3/2 s:s.
        factor[l] =
          yields ? two_G * (scale - hardening) * 1.5 * per_q * per_q : 0.;
      }

    for (unsigned int a = 0; a < n_components; ++a)
      for (unsigned int b = 0; b < n_components; ++b)
        {
          const unsigned int  i = components[a], j = components[b];
          const double        C = elastic_tangent.access_raw_entry(6 * i + j);
          const double        bulk = i < 3 && j < 3 ? K : 0.;
          const double *const s_i  = s[i];
          const double *const s_j  = s[j];
          double *const       D    = tangent[n_components * a + b];
#pragma GCC ivdep
          for (unsigned int l = 0; l < block_size; ++l)
            D[l] = share[l] * C + (1. - share[l]) * bulk -
                   factor[l] * s_i[l] * s_j[l];
        }
  }
} // namespace Waker
