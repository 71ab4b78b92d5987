// SPDX-License-Identifier: LGPL-2.1-or-later
// Von Mises softening of 16 points at a time, without branches.
#include <waker/materials/von_mises_softening.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    const double root_3 = std::sqrt(3.);
  }


  void
  VonMisesSoftening::update_block(const unsigned int, Block &block) const
  {
    if (stiffness_varies)
      update_lanes<true>(block);
    else
      update_lanes<false>(block);
  }


  template <bool varies>
  void
  VonMisesSoftening::update_lanes(Block &block) const
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
    const double *const ratio =
      varies ? block.variables[n_own_variables()] : nullptr;

    const double lambda = K - 2. / 3. * G, two_G = 2. * G, three_G = 3. * G;
    const double slope = root_3 * softening, factor = plastic_strain_factor;
    // Divisions are what such a loop costs: it has one, and one root.
    const double third = 1. / 3., softening_per_multiplier = slope / root_3;
    const double per_elastic   = 1. / three_G,
                 per_softening = 1. / (three_G + slope);
#pragma GCC ivdep
    for (unsigned int l = 0; l < block_size; ++l)
      {
        // Unused entries have the ratio 0, and are ignored.
        const double r       = varies ? ratio[l] : 1.;
        const double add     = r * lambda * (e0[l] + e1[l] + e2[l]);
        const double xx      = s0[l] + r * two_G * e0[l] + add;
        const double yy      = s1[l] + r * two_G * e1[l] + add;
        const double zz      = s2[l] + r * two_G * e2[l] + add;
        const double xy      = s3[l] + r * two_G * e3[l];
        const double xz      = s4[l] + r * two_G * e4[l];
        const double yz      = s5[l] + r * two_G * e5[l];
        const double elastic = varies ? 1. / (r * three_G) : per_elastic;
        const double falling =
          varies ? 1. / (r * three_G + slope) : per_softening;
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
          (q - root_3 * c_old) * (softens ? falling : elastic);
        const double c_new =
          c_old + (softens ? softening_per_multiplier : 0.) * first;
        const bool   at_residual = c_new < c_r;
        const double c           = at_residual ? c_r : c_new;
        const double multiplier =
          at_residual ? (q - root_3 * c_r) * elastic : first;
        const double scale = yields ? root_3 * c / q : 1.;

        s0[l]          = scale * (xx - p) + p;
        s1[l]          = scale * (yy - p) + p;
        s2[l]          = scale * (zz - p) + p;
        s3[l]          = scale * xy;
        s4[l]          = scale * xz;
        s5[l]          = scale * yz;
        strength[l]    = yields ? c : c_old;
        plastic[l]     = plastic[l] + (yields ? factor * multiplier : 0.);
        dissipation[l] = yields ? root_3 * c * multiplier : 0.;
      }
  }


  void
  VonMisesSoftening::tangent_block(const unsigned int,
                                   Block              &block,
                                   const unsigned int  n_components,
                                   const unsigned int *components,
                                   double (*tangent)[block_size]) const
  {
    if (stiffness_varies)
      tangent_lanes<true>(block, n_components, components, tangent);
    else
      tangent_lanes<false>(block, n_components, components, tangent);
  }


  template <bool varies>
  void
  VonMisesSoftening::tangent_lanes(Block              &block,
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
    const double *const ratio =
      varies ? block.variables[n_own_variables()] : nullptr;
    const double lambda = K - 2. / 3. * G, two_G = 2. * G, three_G = 3. * G;
    const double slope = root_3 * softening;
    const double third = 1. / 3., softening_per_multiplier = slope / root_3;
    const double per_elastic   = 1. / three_G,
                 per_softening = 1. / (three_G + slope);
#pragma GCC ivdep
    for (unsigned int l = 0; l < block_size; ++l)
      {
        const double r       = varies ? ratio[l] : 1.;
        const double add     = r * lambda * (e[0][l] + e[1][l] + e[2][l]);
        const double xx      = s[0][l] + r * two_G * e[0][l] + add;
        const double yy      = s[1][l] + r * two_G * e[1][l] + add;
        const double zz      = s[2][l] + r * two_G * e[2][l] + add;
        const double xy      = s[3][l] + r * two_G * e[3][l];
        const double xz      = s[4][l] + r * two_G * e[4][l];
        const double yz      = s[5][l] + r * two_G * e[5][l];
        const double elastic = varies ? 1. / (r * three_G) : per_elastic;
        const double falling =
          varies ? 1. / (r * three_G + slope) : per_softening;
        const double p = (xx + yy + zz) * third;

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
          (q - root_3 * c_old) * (softens ? falling : elastic);
        const double c_new =
          c_old + (softens ? softening_per_multiplier : 0.) * first;
        const bool   at_residual = c_new < c_r;
        const double c           = at_residual ? c_r : c_new;
        const double hardening = softens && !at_residual ? slope * falling : 0.;
        const double scale     = root_3 * c * per_q;
        share[l]               = yields ? scale : 1.;
        // n x n = s x s / s:s, with q^2 = 3/2 s:s.
        factor[l] =
          yields ? r * two_G * (scale - hardening) * 1.5 * per_q * per_q : 0.;
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
            D[l] = (share[l] * C + (1. - share[l]) * bulk) *
                     (varies ? ratio[l] : 1.) -
                   factor[l] * s_i[l] * s_j[l];
        }
  }
} // namespace Waker
