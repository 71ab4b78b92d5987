// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/principal_stress.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Waker
{
  namespace
  {
    /// z is a principal direction: two in the plane, by their half angle.
    PrincipalStress
    of_plane(const SymmetricTensor<2, 3> &stress)
    {
      const double half   = 0.5 * (stress[0][0] - stress[1][1]);
      const double middle = 0.5 * (stress[0][0] + stress[1][1]);
      const double radius =
        std::sqrt(half * half + stress[0][1] * stress[0][1]);
      // cos and sin of the angle of the larger one, the greater of them first.
      double c = 1., s = 0.;
      if (radius > 0.)
        {
          const double cos_double = half / radius;
          const double sin_double = stress[0][1] / radius;
          if (cos_double >= 0.)
            {
              c = std::sqrt(0.5 * (1. + cos_double));
              s = 0.5 * sin_double / c;
            }
          else
            {
              s = std::sqrt(0.5 * (1. - cos_double));
              c = 0.5 * sin_double / s;
            }
        }
      PrincipalStress result;
      result.value        = {{middle + radius, middle - radius, stress[2][2]}};
      result.direction[0] = Tensor<1, 3>({c, s, 0.});
      result.direction[1] = Tensor<1, 3>({-s, c, 0.});
      result.direction[2] = Tensor<1, 3>({0., 0., 1.});
      // The third to its place.
      for (unsigned int i = 2; i > 0; --i)
        if (result.value[i] > result.value[i - 1])
          {
            std::swap(result.value[i], result.value[i - 1]);
            std::swap(result.direction[i], result.direction[i - 1]);
          }
      return result;
    }
  } // namespace


  PrincipalStress
  principal_stress(const SymmetricTensor<2, 3> &stress)
  {
    if (stress[0][2] == 0. && stress[1][2] == 0.)
      return of_plane(stress);
    PrincipalStress result;
    if (!std::isfinite(stress.norm()))
      {
        // Newton has left the road, and will see it.
        for (unsigned int i = 0; i < 3; ++i)
          {
            result.value[i]        = std::numeric_limits<double>::quiet_NaN();
            result.direction[i][i] = 1.;
          }
        return result;
      }
    // deal.II's Jacobi method does not converge for some stresses that are
    // nearly diagonal; this one always has (tests/unit/materials_principal.cc).
    const auto pairs =
      eigenvectors(stress,
                   SymmetricTensorEigenvectorMethod::ql_implicit_shifts);
    for (unsigned int i = 0; i < 3; ++i)
      {
        result.value[i]     = pairs[i].first; // deal.II: descending
        result.direction[i] = pairs[i].second;
      }
    return result;
  }


  SymmetricTensor<2, 3>
  with_values(const std::array<double, 3>       &value,
              const std::array<Tensor<1, 3>, 3> &direction)
  {
    SymmetricTensor<2, 3> stress;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = a; b < 3; ++b)
          stress[a][b] += value[i] * direction[i][a] * direction[i][b];
    return stress;
  }


  SymmetricTensor<4, 3>
  isotropic_derivative(const PrincipalStress       &argument,
                       const std::array<double, 3> &value,
                       const double (&slope)[3][3],
                       const double two_G,
                       const double lame)
  {
    const auto &a = argument.value;
    const auto &n = argument.direction;
    // By components, in deal.II's order: xx, yy, zz, xy, xz, yz. This is what
    // a point that yields spends its time with.
    constexpr unsigned int first[6]  = {0, 1, 2, 0, 0, 1};
    constexpr unsigned int second[6] = {0, 1, 2, 1, 2, 2};
    double                 own[3][6];
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int c = 0; c < 6; ++c)
        own[i][c] = n[i][first[c]] * n[i][second[c]];

    // Where z is a principal direction, what has z in it stands apart.
    const unsigned int z       = std::abs(n[0][2]) == 1.   ? 0
                                 : std::abs(n[1][2]) == 1. ? 1
                                 : std::abs(n[2][2]) == 1. ? 2
                                                           : 3;
    double             D[6][6] = {};
    const auto add = [&D, z](const double(&left)[6], const double(&right)[6]) {
      if (z < 3)
        for (unsigned int c = 0; c < 4; ++c)
          for (unsigned int d = 0; d < 4; ++d)
            D[c][d] += left[c] * right[d];
      else
        for (unsigned int c = 0; c < 6; ++c)
          for (unsigned int d = 0; d < 6; ++d)
            D[c][d] += left[c] * right[d];
    };
    for (unsigned int i = 0; i < 3; ++i)
      {
        double       row[6];
        const double of_pressure =
          lame * (slope[i][0] + slope[i][1] + slope[i][2]);
        for (unsigned int c = 0; c < 6; ++c)
          row[c] = two_G * (slope[i][0] * own[0][c] + slope[i][1] * own[1][c] +
                            slope[i][2] * own[2][c]) +
                   (c < 3 ? of_pressure : 0.);
        add(own[i], row);
      }
    // Values this near to each other have no difference to divide by.
    const double equal =
      1e-8 * std::max({std::abs(a[0]), std::abs(a[2]), 1e-300});
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i + 1; j < 3; ++j)
        {
          const double difference = a[i] - a[j];
          const double shear =
            std::abs(difference) > equal
              ? (value[i] - value[j]) / difference
              : 0.5 * (slope[i][i] - slope[i][j] + slope[j][j] - slope[j][i]);
          const double factor = 2. * two_G * shear;
          double       mixed[6], scaled[6];
          for (unsigned int c = 0; c < 6; ++c)
            {
              mixed[c]  = 0.5 * (n[i][first[c]] * n[j][second[c]] +
                                n[i][second[c]] * n[j][first[c]]);
              scaled[c] = factor * mixed[c];
            }
          if (i != z && j != z)
            add(mixed, scaled);
          else
            for (unsigned int c = 4; c < 6; ++c)
              for (unsigned int d = 4; d < 6; ++d)
                D[c][d] += mixed[c] * scaled[d];
        }
    SymmetricTensor<4, 3> result;
    for (unsigned int c = 0; c < 6; ++c)
      for (unsigned int d = 0; d < 6; ++d)
        result.access_raw_entry(6 * c + d) = D[c][d];
    return result;
  }
} // namespace Waker
