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
      const double radius = std::hypot(half, stress[0][1]);
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
                       const double (&slope)[3][3])
  {
    const auto           &a = argument.value;
    const auto           &n = argument.direction;
    SymmetricTensor<2, 3> own[3];
    for (unsigned int i = 0; i < 3; ++i)
      own[i] = symmetrize(outer_product(n[i], n[i]));

    SymmetricTensor<4, 3> D;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        D += slope[i][j] * outer_product(own[i], own[j]);
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
          const auto mixed = symmetrize(outer_product(n[i], n[j]));
          D += (2. * shear) * outer_product(mixed, mixed);
        }
    return D;
  }
} // namespace Waker
