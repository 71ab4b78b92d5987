// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mohr_coulomb_return.h"

#include <waker/base/errors.h>
#include <waker/base/numbers.h>

#include "small_system.h"
#include <algorithm>
#include <cmath>
#include <utility>

namespace Waker
{
  namespace
  {
    using Strength = MohrCoulombStrength;

    // The planes by their numbers: of two stresses, the largest difference
    // first, then of one.
    constexpr unsigned int n_planes         = 6;
    constexpr unsigned int n_pairs          = 3;
    constexpr unsigned int pair[n_pairs][2] = {{0, 2}, {0, 1}, {1, 2}};

    /// Which planes may hold the stress together, the usual ones first. More
    /// than three meet in corners; any three of them that can hold it do.
    constexpr unsigned int n_sets          = 41;
    constexpr int          sets[n_sets][3] = {
               {0, -1, -1}, {3, -1, -1}, {0, 1, -1}, {0, 2, -1},  {0, 3, -1},
               {3, 4, -1},  {3, 4, 5},   {0, 1, 3},  {0, 2, 3},   {0, 3, 4},
               {2, 3, 4},   {0, 2, 4},   {0, 1, 2},  {1, -1, -1}, {2, -1, -1},
               {4, -1, -1}, {5, -1, -1}, {1, 2, -1}, {0, 4, -1},  {0, 5, -1},
               {1, 3, -1},  {1, 4, -1},  {1, 5, -1}, {2, 3, -1},  {2, 4, -1},
               {2, 5, -1},  {3, 5, -1},  {4, 5, -1}, {0, 1, 4},   {0, 1, 5},
               {0, 2, 5},   {0, 3, 5},   {0, 4, 5},  {1, 2, 3},   {1, 2, 4},
               {1, 2, 5},   {1, 3, 4},   {1, 3, 5},  {1, 4, 5},   {2, 3, 5},
               {2, 4, 5}};


    /// The plane is normal . s = offset.
    Principal
    normal(const unsigned int k, const Strength &s)
    {
      Principal n = {{0., 0., 0.}};
      if (k < n_pairs)
        {
          n[pair[k][0]] = 1. + s.sin_phi;
          n[pair[k][1]] = -(1. - s.sin_phi);
        }
      else
        n[k - n_pairs] = 1.;
      return n;
    }


    double
    offset(const unsigned int k, const Strength &s)
    {
      return k < n_pairs ? 2. * s.cohesion * s.cos_phi : s.tension;
    }


    Principal
    flow(const unsigned int k, const Strength &s)
    {
      Strength potential = s;
      potential.sin_phi  = s.sin_psi;
      return normal(k, potential);
    }


    /// What round-off may be, kPa.
    double
    tolerance_of(const Principal &trial, const Strength &s)
    {
      return 1e-11 *
             (std::abs(trial[0]) + std::abs(trial[2]) + 2. * s.cohesion);
    }
  } // namespace


  double
  MohrCoulombReturn::strain_of_loss(const double sin_phi,
                                    const double sin_psi,
                                    const double loss) const
  {
    Strength s     = {};
    s.sin_phi      = sin_phi;
    s.sin_psi      = sin_psi;
    double largest = 0.;
    for (const unsigned int other : {0u, 1u, 2u}) // 0: the face alone
      {
        const unsigned int n         = other == 0 ? 1 : 2;
        const unsigned int planes[2] = {0, other};
        double             A[2][2], x[2][1];
        Principal          strain = {{0., 0., 0.}};
        for (unsigned int i = 0; i < n; ++i)
          {
            x[i][0] = loss;
            for (unsigned int j = 0; j < n; ++j)
              A[i][j] = dot(normal(planes[i], s), elastic(flow(planes[j], s)));
          }
        if (!solve(n, A, x))
          continue;
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int d = 0; d < 3; ++d)
            strain[d] += x[i][0] * flow(planes[i], s)[d];
        largest = std::max(largest, equivalent(strain));
      }
    return largest;
  }


  bool
  MohrCoulombReturn::holds(const Principal &trial, const Strength &strength)
  {
    return dot(normal(0, strength), trial) <= offset(0, strength) &&
           trial[0] <= strength.tension;
  }


  MohrCoulombReturn::Result
  MohrCoulombReturn::operator()(const Principal &trial,
                                const Strength  &strength) const
  {
    Result result;
    result.stress         = trial;
    result.plastic_strain = {{0., 0., 0.}};
    if (holds(trial, strength))
      return result;

    // Mostly the plane of the largest difference holds it.
    {
      const Principal a      = normal(0, strength);
      const Principal g      = flow(0, strength);
      const Principal along  = elastic(g);
      const double    excess = dot(a, trial) - offset(0, strength);
      const double    m      = excess / dot(a, along);
      const Principal s      = {{trial[0] - m * along[0],
                                 trial[1] - m * along[1],
                                 trial[2] - m * along[2]}};
      if (m >= 0. && s[0] >= s[1] && s[1] >= s[2] && s[0] <= strength.tension)
        {
          result.stress         = s;
          result.plastic_strain = {{m * g[0], m * g[1], m * g[2]}};
          result.n_active       = 1;
          result.active[0]      = 0;
          result.multiplier[0]  = m;
          return result;
        }
    }

    Principal normals[n_planes], flows[n_planes], stresses[n_planes];
    double    excess[n_planes];
    for (unsigned int k = 0; k < n_planes; ++k)
      {
        normals[k]  = normal(k, strength);
        flows[k]    = flow(k, strength);
        stresses[k] = elastic(flows[k]);
        excess[k]   = dot(normals[k], trial) - offset(k, strength);
      }
    const double tolerance = tolerance_of(trial, strength);
    for (const auto &set : sets)
      {
        unsigned int n = 0;
        double       A[3][3], x[3][1];
        while (n < 3 && set[n] >= 0)
          ++n;
        bool finite = true;
        for (unsigned int i = 0; i < n; ++i)
          {
            finite  = finite && std::isfinite(excess[set[i]]);
            x[i][0] = excess[set[i]];
            for (unsigned int j = 0; j < n; ++j)
              A[i][j] = dot(normals[set[i]], stresses[set[j]]);
          }
        if (!finite || !solve(n, A, x))
          continue;
        bool      possible = true;
        Principal s = trial, e = {{0., 0., 0.}};
        for (unsigned int i = 0; i < n; ++i)
          {
            possible = possible && x[i][0] >= -tolerance / G;
            for (unsigned int d = 0; d < 3; ++d)
              {
                s[d] -= x[i][0] * stresses[set[i]][d];
                e[d] += x[i][0] * flows[set[i]][d];
              }
          }
        for (unsigned int k = 0; k < n_planes && possible; ++k)
          possible = dot(normals[k], s) - offset(k, strength) <= 4. * tolerance;
        if (!possible)
          continue;
        result.stress         = s;
        result.plastic_strain = e;
        result.n_active       = n;
        for (unsigned int i = 0; i < n; ++i)
          {
            result.active[i]     = set[i];
            result.multiplier[i] = x[i][0];
          }
        return result;
      }

    // Not a number: Newton sees it. A return of finite stresses has always been
    // found (tests/unit/materials_mohr_coulomb.cc).
    if (std::isfinite(trial[0] + trial[1] + trial[2]))
      throw NumericalFailure("Mohr-Coulomb: no return from the principal "
                             "stresses " +
                             in_digits(trial[0]) + ", " + in_digits(trial[1]) +
                             ", " + in_digits(trial[2]) + " kPa");
    return result;
  }


  void
  MohrCoulombReturn::fixed_slope(const Result   &result,
                                 const Strength &strength,
                                 double (&slope)[3][3]) const
  {
    const unsigned int n = result.n_active;
    Principal          normals[3], stresses[3];
    double             A[3][3], x[3][3];
    for (unsigned int i = 0; i < n; ++i)
      {
        normals[i]  = normal(result.active[i], strength);
        stresses[i] = elastic(flow(result.active[i], strength));
        for (unsigned int d = 0; d < 3; ++d)
          x[i][d] = normals[i][d];
      }
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        A[i][j] = dot(normals[i], stresses[j]);
    const bool solved = solve(n, A, x);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        {
          slope[i][d] = i == d ? 1. : 0.;
          for (unsigned int j = 0; solved && j < n; ++j)
            slope[i][d] -= stresses[j][i] * x[j][d];
        }
  }


  void
  MohrCoulombReturn::slope(const Result   &result,
                           const Strength &strength,
                           const Strength &rate,
                           double (&slope)[3][3]) const
  {
    // The planes' equations and that of the plastic strain, k, together:
    //   normal_i(k) . s - offset_i(k) = 0,  s = trial - sum_j m_j D flow_j(k),
    //   k = k_start + sqrt(2/3) |dev sum_j m_j flow_j(k)|.
    const unsigned int n = result.n_active;
    if (rate.is_zero())
      {
        fixed_slope(result, strength, slope);
        return;
      }
    Principal    normals[3], stresses[3], change = {{0., 0., 0.}};
    double       J[4][4] = {}, x[4][3] = {};
    const double size = equivalent(result.plastic_strain);
    const double mean = (result.plastic_strain[0] + result.plastic_strain[1] +
                         result.plastic_strain[2]) /
                        3.;
    Principal direction = {{0., 0., 0.}}; // d k / d plastic strain
    if (size > 0.)
      for (unsigned int d = 0; d < 3; ++d)
        direction[d] = 2. / 3. * (result.plastic_strain[d] - mean) / size;

    for (unsigned int j = 0; j < n; ++j)
      {
        const unsigned int k = result.active[j];
        normals[j]           = normal(k, strength);
        const Principal g    = flow(k, strength);
        stresses[j]          = elastic(g);
        J[n][j]              = -dot(direction, g);
        // The flow's own change: only planes of two stresses have one.
        if (k < n_pairs)
          for (const unsigned int d : pair[k])
            change[d] += result.multiplier[j] * rate.sin_psi;
      }
    const Principal change_of_stress = elastic(change);
    J[n][n]                          = 1. - dot(direction, change);
    for (unsigned int i = 0; i < n; ++i)
      {
        const unsigned int k = result.active[i];
        for (unsigned int j = 0; j < n; ++j)
          J[i][j] = -dot(normals[i], stresses[j]);
        J[i][n] = -dot(normals[i], change_of_stress);
        if (k < n_pairs)
          {
            J[i][n] += rate.sin_phi * (result.stress[pair[k][0]] +
                                       result.stress[pair[k][1]]) -
                       2. * (rate.cohesion * strength.cos_phi +
                             strength.cohesion * rate.cos_phi);
          }
        else
          J[i][n] -= rate.tension;
        for (unsigned int d = 0; d < 3; ++d)
          x[i][d] = -normals[i][d];
      }
    const bool solved = solve(n + 1, J, x);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        {
          slope[i][d] = i == d ? 1. : 0.;
          if (solved)
            {
              for (unsigned int j = 0; j < n; ++j)
                slope[i][d] -= stresses[j][i] * x[j][d];
              slope[i][d] -= change_of_stress[i] * x[n][d];
            }
        }
  }
} // namespace Waker
