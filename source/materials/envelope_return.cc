// SPDX-License-Identifier: LGPL-2.1-or-later
#include "envelope_return.h"

#include <waker/base/errors.h>
#include <waker/base/numbers.h>

#include "small_system.h"
#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    // The largest difference first.
    constexpr unsigned int pair[3][2] = {{0, 2}, {0, 1}, {1, 2}};


    Principal
    difference(const unsigned int k, const double sine)
    {
      Principal n   = {{0., 0., 0.}};
      n[pair[k][0]] = 1. + sine;
      n[pair[k][1]] = -(1. - sine);
      return n;
    }
  } // namespace


  EnvelopeReturn::EnvelopeReturn(
    const double                            shear_modulus,
    const double                            lame,
    const std::vector<MohrCoulombStrength> &surfaces)
    : G(shear_modulus)
    , lambda(lame)
    , n_surfaces(surfaces.size())
    , size(0.)
  {
    for (const MohrCoulombStrength &s : surfaces)
      {
        for (unsigned int k = 0; k < 3; ++k)
          planes.push_back({difference(k, s.sin_phi),
                            difference(k, s.sin_psi),
                            2. * s.cohesion * s.cos_phi});
        size = std::max(size, 2. * s.cohesion);
      }
    for (unsigned int k = 0; k < 3; ++k)
      {
        Principal n = {{0., 0., 0.}};
        n[k]        = 1.;
        planes.push_back({n, n, surfaces[0].tension});
      }
  }


  Principal
  EnvelopeReturn::elastic(const Principal &e) const
  {
    const double add = lambda * (e[0] + e[1] + e[2]);
    return {{2. * G * e[0] + add, 2. * G * e[1] + add, 2. * G * e[2] + add}};
  }


  bool
  EnvelopeReturn::holds(const Principal                        &trial,
                        const std::vector<MohrCoulombStrength> &surfaces)
  {
    for (const MohrCoulombStrength &s : surfaces)
      if (!(dot(difference(0, s.sin_phi), trial) <=
            2. * s.cohesion * s.cos_phi))
        return false;
    return trial[0] <= surfaces[0].tension;
  }


  bool
  EnvelopeReturn::try_set(const Principal    &trial,
                          const unsigned int  n,
                          const unsigned int *set,
                          Result             &result) const
  {
    const double tolerance =
      1e-11 * (std::abs(trial[0]) + std::abs(trial[2]) + size);
    double    A[3][3], x[3][1];
    Principal along[3];
    for (unsigned int i = 0; i < n; ++i)
      along[i] = elastic(planes[set[i]].flow);
    for (unsigned int i = 0; i < n; ++i)
      {
        const YieldPlane &plane = planes[set[i]];
        x[i][0]                 = dot(plane.normal, trial) - plane.offset;
        if (!std::isfinite(x[i][0]))
          return false;
        for (unsigned int j = 0; j < n; ++j)
          A[i][j] = dot(plane.normal, along[j]);
      }
    if (!solve(n, A, x))
      return false;
    Principal s = trial, e = {{0., 0., 0.}};
    for (unsigned int i = 0; i < n; ++i)
      {
        if (!(x[i][0] >= -tolerance / G))
          return false;
        for (unsigned int d = 0; d < 3; ++d)
          {
            s[d] -= x[i][0] * along[i][d];
            e[d] += x[i][0] * planes[set[i]].flow[d];
          }
      }
    for (const YieldPlane &plane : planes)
      if (!(dot(plane.normal, s) - plane.offset <= 4. * tolerance))
        return false;
    // Nor may the order of the stresses have changed.
    if (s[0] < s[1] - 4. * tolerance || s[1] < s[2] - 4. * tolerance)
      return false;
    result.stress         = s;
    result.plastic_strain = e;
    result.n_active       = n;
    std::copy_n(set, n, result.active);
    return true;
  }


  EnvelopeReturn::Result
  EnvelopeReturn::operator()(const Principal &trial) const
  {
    Result             result;
    const unsigned int n_planes = planes.size();
    // Mostly it is the largest difference alone, on a line or where two meet.
    for (unsigned int k = 0; k < n_surfaces; ++k)
      {
        const unsigned int set[2] = {3 * k, 3 * k + 3};
        if (try_set(trial, 1, set, result) ||
            (k + 1 < n_surfaces && try_set(trial, 2, set, result)))
          return result;
      }
    for (unsigned int a = 0; a < n_planes; ++a)
      if (try_set(trial, 1, &a, result))
        return result;
    for (unsigned int a = 0; a < n_planes; ++a)
      for (unsigned int b = a + 1; b < n_planes; ++b)
        {
          const unsigned int set[2] = {a, b};
          if (try_set(trial, 2, set, result))
            return result;
        }
    for (unsigned int a = 0; a < n_planes; ++a)
      for (unsigned int b = a + 1; b < n_planes; ++b)
        for (unsigned int c = b + 1; c < n_planes; ++c)
          {
            const unsigned int set[3] = {a, b, c};
            if (try_set(trial, 3, set, result))
              return result;
          }
    // Not a number: Newton sees it.
    if (std::isfinite(trial[0] + trial[1] + trial[2]))
      throw NumericalFailure("Shear strength table: no return from the "
                             "principal stresses " +
                             in_digits(trial[0]) + ", " + in_digits(trial[1]) +
                             ", " + in_digits(trial[2]) + " kPa");
    result.stress         = trial;
    result.plastic_strain = {{0., 0., 0.}};
    return result;
  }


  void
  EnvelopeReturn::slope(const Result &result, double (&slope)[3][3]) const
  {
    // normal_i . ds = 0, ds = dtrial - sum_j dm_j D flow_j.
    const unsigned int n = result.n_active;
    double             A[3][3], x[3][3];
    Principal          along[3];
    for (unsigned int i = 0; i < n; ++i)
      along[i] = elastic(planes[result.active[i]].flow);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          x[i][j] = planes[result.active[i]].normal[j];
          if (j < n)
            A[i][j] = dot(planes[result.active[i]].normal, along[j]);
        }
    const bool solved = solve(n, A, x);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        {
          slope[i][d] = i == d ? 1. : 0.;
          if (solved)
            for (unsigned int j = 0; j < n; ++j)
              slope[i][d] -= along[j][i] * x[j][d];
        }
  }
} // namespace Waker
