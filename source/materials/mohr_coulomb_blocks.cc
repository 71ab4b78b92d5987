// SPDX-License-Identifier: LGPL-2.1-or-later
// Mohr-Coulomb of 16 points at a time: what is far from yield costs little.
#include <waker/materials/mohr_coulomb.h>

#include "mohr_coulomb_lanes.h"
#include <algorithm>
#include <cmath>

namespace Waker
{
  template <bool varies>
  void
  MohrCoulomb::find_trial(const Block &block,
                          double (&trial)[6][block_size],
                          double (&half)[block_size],
                          double (&middle)[block_size],
                          double (&largest)[block_size]) const
  {
    // Half the difference and half the sum of the largest and the smallest
    // principal stress, and the largest. In the plane they are known; in space
    // they are at most q / sqrt(3), p + q / 6 and p + 2 q / 3, q = sqrt(3 J_2).
    const double lame = K - 2. / 3. * G, two_G = 2. * G, third = 1. / 3.,
                 sixth                 = 1. / 6.;
    const double per_sqrt_3            = 1. / std::sqrt(3.);
    const double(*const e)[block_size] = block.strain_increment;
    const double(*const s)[block_size] = block.stress;
    const double *const ratio =
      varies ? block.variables[n_own_variables()] : nullptr;
#pragma GCC ivdep
    for (unsigned int l = 0; l < block_size; ++l)
      {
        const double r   = varies ? ratio[l] : 1.;
        const double add = r * lame * (e[0][l] + e[1][l] + e[2][l]);
        const double xx  = s[0][l] + r * two_G * e[0][l] + add;
        const double yy  = s[1][l] + r * two_G * e[1][l] + add;
        const double zz  = s[2][l] + r * two_G * e[2][l] + add;
        const double xy  = s[3][l] + r * two_G * e[3][l];
        const double xz  = s[4][l] + r * two_G * e[4][l];
        const double yz  = s[5][l] + r * two_G * e[5][l];
        const double m   = (xx + yy + zz) * third;
        const double a = xx - m, b = yy - m, c = zz - m;
        const double q = std::sqrt(
          1.5 * (a * a + b * b + c * c + 2. * (xy * xy + xz * xz + yz * yz)));
        const double centre = 0.5 * (xx + yy);
        const double radius = std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
        const double high   = std::max(centre + radius, zz);
        const double low    = std::min(centre - radius, zz);
        const bool   in_plane = xz == 0. && yz == 0.;
        half[l]               = in_plane ? 0.5 * (high - low) : q * per_sqrt_3;
        middle[l]             = in_plane ? 0.5 * (high + low) : m + q * sixth;
        largest[l]            = in_plane ? high : m + 2. * third * q;
        trial[0][l]           = xx;
        trial[1][l]           = yy;
        trial[2][l]           = zz;
        trial[3][l]           = xy;
        trial[4][l]           = xz;
        trial[5][l]           = yz;
      }
  }


  void
  MohrCoulomb::find_elastic(const unsigned int n_points,
                            const Block       &block,
                            double (&trial)[6][block_size],
                            bool (&is_elastic)[block_size],
                            MohrCoulombStrength (&strengths)[block_size]) const
  {
    double half[block_size], middle[block_size], largest[block_size];
    if (stiffness_varies)
      find_trial<true>(block, trial, half, middle, largest);
    else
      find_trial<false>(block, trial, half, middle, largest);

    // Sine and cosine cost as much as all of that; neighbours often have the
    // same strengths. Without softening the plastic strain is none of them.
    const unsigned int  plastic   = number_of_plastic_strain();
    const unsigned int  strain    = number_of_softening_strain();
    const unsigned int  n_matters = softens() ? strain + 1 : plastic;
    double              variables[most_variables] = {};
    MohrCoulombStrength strength                  = {};
    for (unsigned int l = 0; l < n_points; ++l)
      {
        bool is_new = l == 0;
        for (unsigned int v = 0; v < n_matters; ++v)
          {
            is_new       = is_new || variables[v] != block.variables[v][l];
            variables[v] = block.variables[v][l];
          }
        if (is_new)
          strength = strength_at(block.variables[strain][l], variables);
        strengths[l]  = strength;
        is_elastic[l] = half[l] + strength.sin_phi * middle[l] <
                          strength.cohesion * strength.cos_phi &&
                        largest[l] < strength.tension;
      }
  }


  template <typename Use>
  void
  MohrCoulomb::each_yielding(const unsigned int n_points,
                             const Block       &block,
                             const bool (&is_elastic)[block_size],
                             const Use &use) const
  {
    double                variables[most_variables];
    SymmetricTensor<2, 3> strain, stress;
    for (unsigned int l = 0; l < n_points; ++l)
      if (!is_elastic[l])
        {
          for (unsigned int v = 0; v < n_variables(); ++v)
            variables[v] = block.variables[v][l];
          for (unsigned int a = 0; a < 6; ++a)
            {
              strain.access_raw_entry(a) = block.strain_increment[a][l];
              stress.access_raw_entry(a) = block.stress[a][l];
            }
          use(l, strain, stress, variables);
        }
  }


  unsigned int
  MohrCoulomb::fill_lanes(const unsigned int n_points,
                          const Block       &block,
                          const double (&trial)[6][block_size],
                          const bool (&is_elastic)[block_size],
                          const MohrCoulombStrength (&strengths)[block_size],
                          unsigned int (&point)[block_size],
                          MohrCoulombLanes &lanes) const
  {
    const double lame = K - 2. / 3. * G;
    unsigned int n    = 0;
    for (unsigned int l = 0; l < n_points; ++l)
      if (!is_elastic[l])
        {
          const double ratio =
            stiffness_varies ? block.variables[n_own_variables()][l] : 1.;
          lanes.add(trial, l, strengths[l], ratio * G, ratio * lame);
          point[n++] = l;
        }
    return n;
  }


  void
  MohrCoulomb::update_block(const unsigned int n_points, Block &block) const
  {
    // Of those that are surely elastic nothing else need be known.
    double              trial[6][block_size];
    bool                is_elastic[block_size];
    MohrCoulombStrength strengths[block_size];
    find_elastic(n_points, block, trial, is_elastic, strengths);
    const unsigned int plastic = number_of_plastic_strain();
    for (unsigned int l = 0; l < n_points; ++l)
      if (is_elastic[l])
        {
          for (unsigned int a = 0; a < 6; ++a)
            block.stress[a][l] = trial[a][l];
          block.dissipation[l] = 0.;
        }
    if (softens_in_step())
      {
        each_yielding(n_points,
                      block,
                      is_elastic,
                      [&](const unsigned int           l,
                          const SymmetricTensor<2, 3> &strain,
                          SymmetricTensor<2, 3>       &stress,
                          double *const                variables) {
                        block.dissipation[l] = update(
                          strain, strengths[l], stress, variables, nullptr);
                        for (unsigned int a = 0; a < 6; ++a)
                          block.stress[a][l] = stress.access_raw_entry(a);
                        block.variables[plastic][l] = variables[plastic];
                      });
        return;
      }
    MohrCoulombLanes   lanes;
    unsigned int       point[block_size];
    const unsigned int n =
      fill_lanes(n_points, block, trial, is_elastic, strengths, point, lanes);
    if (n == 0)
      return;
    lanes.find_return(false);
    double stress[6];
    for (unsigned int i = 0; i < n; ++i)
      {
        const unsigned int l = point[i];
        lanes.get_stress(i, stress);
        for (unsigned int a = 0; a < 6; ++a)
          block.stress[a][l] = stress[a];
        block.dissipation[l] = lanes.dissipation(i);
        block.variables[plastic][l] += lanes.plastic_strain(i);
      }
  }


  void
  MohrCoulomb::tangent_block(const unsigned int  n_points,
                             Block              &block,
                             const unsigned int  n_components,
                             const unsigned int *components,
                             double (*tangent)[block_size]) const
  {
    double              trial[6][block_size];
    bool                is_elastic[block_size];
    MohrCoulombStrength strengths[block_size];
    find_elastic(n_points, block, trial, is_elastic, strengths);
    for (unsigned int a = 0; a < n_components; ++a)
      for (unsigned int b = 0; b < n_components; ++b)
        std::fill_n(tangent[n_components * a + b],
                    block_size,
                    elastic_tangent.access_raw_entry(6 * components[a] +
                                                     components[b]));
    if (stiffness_varies)
      for (unsigned int a = 0; a < n_components * n_components; ++a)
        for (unsigned int l = 0; l < n_points; ++l)
          tangent[a][l] *= block.variables[n_own_variables()][l];
    if (softens_in_step())
      {
        SymmetricTensor<4, 3> D;
        each_yielding(n_points,
                      block,
                      is_elastic,
                      [&](const unsigned int           l,
                          const SymmetricTensor<2, 3> &strain,
                          SymmetricTensor<2, 3>       &stress,
                          double *const                variables) {
                        update(strain, strengths[l], stress, variables, &D);
                        for (unsigned int a = 0; a < n_components; ++a)
                          for (unsigned int b = 0; b < n_components; ++b)
                            tangent[n_components * a + b][l] =
                              D.access_raw_entry(6 * components[a] +
                                                 components[b]);
                      });
        return;
      }
    MohrCoulombLanes   lanes;
    unsigned int       point[block_size];
    const unsigned int n =
      fill_lanes(n_points, block, trial, is_elastic, strengths, point, lanes);
    if (n == 0)
      return;
    lanes.find_return(true);
    double D[36][block_size];
    lanes.tangent(n_components, components, D);
    for (unsigned int a = 0; a < n_components * n_components; ++a)
      for (unsigned int i = 0; i < n; ++i)
        tangent[a][point[i]] = D[a][i];
  }
} // namespace Waker
