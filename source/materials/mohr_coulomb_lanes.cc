// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mohr_coulomb_lanes.h"

#include <waker/materials/principal_stress.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    // By components, in deal.II's order: xx, yy, zz, xy, xz, yz.
    constexpr unsigned int first[6]  = {0, 1, 2, 0, 0, 1};
    constexpr unsigned int second[6] = {0, 1, 2, 1, 2, 2};

    // Pairs of principal values.
    constexpr unsigned int pair[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  } // namespace


  void
  MohrCoulombLanes::add(const double (&elastic_stress)[6][size],
                        const unsigned int         point,
                        const MohrCoulombStrength &own_strength,
                        const double               shear_modulus,
                        const double               own_lame)
  {
    for (unsigned int c = 0; c < 6; ++c)
      stress[c][n] = elastic_stress[c][point];
    strength[n] = own_strength;
    sin_phi[n]  = own_strength.sin_phi;
    sin_psi[n]  = own_strength.sin_psi;
    tension[n]  = own_strength.tension;
    offset[n]   = 2. * own_strength.cohesion * own_strength.cos_phi;
    two_G[n]    = 2. * shear_modulus;
    lame[n]     = own_lame;
    ++n;
  }


  void
  MohrCoulombLanes::find_principal_stresses()
  {
    // As principal_stress() does it where z is a principal direction.
#pragma GCC ivdep
    for (unsigned int l = 0; l < n; ++l)
      {
        const double half   = 0.5 * (stress[0][l] - stress[1][l]);
        const double middle = 0.5 * (stress[0][l] + stress[1][l]);
        const double shear = stress[3][l], z = stress[2][l];
        const double radius     = std::sqrt(half * half + shear * shear);
        const bool   round      = !(radius > 0.);
        const double per_radius = 1. / (round ? 1. : radius);
        const double cos_double = round ? 1. : half * per_radius;
        const double sin_double = shear * per_radius;
        // cos and sin of the angle of the larger one, the greater of them
        // first.
        const double great = std::sqrt(0.5 * (1. + std::abs(cos_double)));
        const double small = 0.5 * sin_double / great;
        const double c     = cos_double >= 0. ? great : small;
        const double s     = cos_double >= 0. ? small : great;
        const double high = middle + radius, low = middle - radius;
        // The third to its place.
        const bool second_or_first = z > low, is_first = z > high;
        trial[0][l]        = is_first ? z : high;
        trial[1][l]        = is_first ? high : (second_or_first ? z : low);
        trial[2][l]        = second_or_first ? low : z;
        direction[0][0][l] = is_first ? 0. : c;
        direction[0][1][l] = is_first ? 0. : s;
        direction[0][2][l] = is_first ? 1. : 0.;
        direction[1][0][l] = is_first ? c : (second_or_first ? 0. : -s);
        direction[1][1][l] = is_first ? s : (second_or_first ? 0. : c);
        direction[1][2][l] = second_or_first && !is_first ? 1. : 0.;
        direction[2][0][l] = second_or_first ? -s : 0.;
        direction[2][1][l] = second_or_first ? c : 0.;
        direction[2][2][l] = second_or_first ? 0. : 1.;
      }
    for (unsigned int l = 0; l < n; ++l)
      if (stress[4][l] != 0. || stress[5][l] != 0.)
        {
          SymmetricTensor<2, 3> own;
          for (unsigned int c = 0; c < 6; ++c)
            own.access_raw_entry(c) = stress[c][l];
          const PrincipalStress all = principal_stress(own);
          for (unsigned int i = 0; i < 3; ++i)
            {
              trial[i][l] = all.value[i];
              for (unsigned int d = 0; d < 3; ++d)
                direction[i][d][l] = all.direction[i][d];
            }
        }
  }


  void
  MohrCoulombLanes::get_stress(const unsigned int l, double (&result)[6]) const
  {
    if (yields[l] == 0.)
      for (unsigned int c = 0; c < 6; ++c)
        result[c] = stress[c][l];
    else
      for (unsigned int c = 0; c < 6; ++c)
        {
          result[c] = 0.;
          for (unsigned int i = 0; i < 3; ++i)
            result[c] += value[i][l] * direction[i][first[c]][l] *
                         direction[i][second[c]][l];
        }
  }


  void
  MohrCoulombLanes::tangent(const unsigned int  n_components,
                            const unsigned int *components,
                            double (*D)[size]) const
  {
    // As isotropic_derivative(); rows and columns as they are asked for.
    double own[3][6][size], row[3][6][size], mixed[3][6][size], factor[3][size];
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int a = 0; a < n_components; ++a)
        {
          const double *const u = direction[i][first[components[a]]];
          const double *const v = direction[i][second[components[a]]];
          for (unsigned int l = 0; l < n; ++l)
            own[i][a][l] = u[l] * v[l];
        }
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int a = 0; a < n_components; ++a)
        {
          const double of_pressure = components[a] < 3 ? 1. : 0.;
#pragma GCC ivdep
          for (unsigned int l = 0; l < n; ++l)
            row[i][a][l] = two_G[l] * (slope[i][0][l] * own[0][a][l] +
                                       slope[i][1][l] * own[1][a][l] +
                                       slope[i][2][l] * own[2][a][l]) +
                           of_pressure * lame[l] *
                             (slope[i][0][l] + slope[i][1][l] + slope[i][2][l]);
        }
    for (unsigned int p = 0; p < 3; ++p)
      {
        const unsigned int i = pair[p][0], j = pair[p][1];
#pragma GCC ivdep
        for (unsigned int l = 0; l < n; ++l)
          {
            // Values this near to each other have no difference to divide by.
            const double equal =
              1e-8 *
              std::max(std::max(std::abs(trial[0][l]), std::abs(trial[2][l])),
                       1e-300);
            const double difference = trial[i][l] - trial[j][l];
            const bool   differ     = std::abs(difference) > equal;
            const double quotient =
              (value[i][l] - value[j][l]) / (differ ? difference : 1.);
            const double limit = 0.5 * (slope[i][i][l] - slope[i][j][l] +
                                        slope[j][j][l] - slope[j][i][l]);
            factor[p][l]       = 2. * two_G[l] * (differ ? quotient : limit);
          }
        for (unsigned int a = 0; a < n_components; ++a)
          {
            const unsigned int  c = first[components[a]];
            const unsigned int  d = second[components[a]];
            const double *const u = direction[i][c], *const v = direction[j][d];
            const double *const w = direction[i][d], *const x = direction[j][c];
            for (unsigned int l = 0; l < n; ++l)
              mixed[p][a][l] = 0.5 * (u[l] * v[l] + w[l] * x[l]);
          }
      }
    for (unsigned int a = 0; a < n_components; ++a)
      for (unsigned int b = 0; b < n_components; ++b)
        {
          double *const entry = D[n_components * a + b];
#pragma GCC ivdep
          for (unsigned int l = 0; l < n; ++l)
            entry[l] = own[0][a][l] * row[0][b][l] +
                       own[1][a][l] * row[1][b][l] +
                       own[2][a][l] * row[2][b][l] +
                       factor[0][l] * mixed[0][a][l] * mixed[0][b][l] +
                       factor[1][l] * mixed[1][a][l] * mixed[1][b][l] +
                       factor[2][l] * mixed[2][a][l] * mixed[2][b][l];
        }
  }
} // namespace Waker
