// SPDX-License-Identifier: LGPL-2.1-or-later
// Principal stresses and their directions, in the plane and in space.
#include <waker/materials/principal_stress.h>

#include "mapping_lattice.h"
#include <cmath>
#include <gtest/gtest.h>

namespace materials_principal
{
  using namespace Waker;

  namespace
  {
    void
    check(const SymmetricTensor<2, 3> &stress)
    {
      const PrincipalStress p     = principal_stress(stress);
      const double          limit = 1e-13 * (stress.norm() + 1e-300);
      ASSERT_GE(p.value[0], p.value[1] - limit);
      ASSERT_GE(p.value[1], p.value[2] - limit);
      ASSERT_LT((with_values(p.value, p.direction) - stress).norm(),
                10. * limit)
        << stress;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          ASSERT_NEAR(p.direction[i] * p.direction[j], i == j, 1e-13) << stress;
    }
  } // namespace


  TEST(Materials, principal_stresses_make_the_stress_again)
  {
    // General ones; nearly diagonal, nearly with two or three equal values; of
    // any size; with z as a principal direction.
    Lattice::Random random(307);
    for (unsigned int n = 0; n < 20000; ++n)
      {
        SymmetricTensor<2, 3> stress = random.stress<3>(10.);
        const double          small  = std::pow(10., -random(0., 16.));
        if (n % 4 == 1)
          stress = small * stress - 40. * unit_symmetric_tensor<3>();
        else if (n % 4 == 2)
          for (unsigned int a = 3; a < 6; ++a)
            stress.access_raw_entry(a) *= small;
        if (n % 3 == 0)
          stress[0][2] = stress[1][2] = 0.;
        if (n % 5 == 0)
          stress[1][1] = stress[0][0];
        if (n % 7 == 0)
          stress *= std::pow(10., random(-30., 30.));
        check(stress);
      }
    check(SymmetricTensor<2, 3>());
    check(unit_symmetric_tensor<3>());
  }


  TEST(Materials, principal_stresses_of_no_number_are_none)
  {
    for (const bool in_space : {false, true})
      {
        SymmetricTensor<2, 3> stress;
        stress[0][1] = std::nan("");
        if (in_space)
          stress[0][2] = 1.;
        EXPECT_FALSE(std::isfinite(principal_stress(stress).value[0]));
      }
  }


  TEST(Materials, the_derivative_of_an_isotropic_function)
  {
    // Of the square of a tensor: d (A A) = dA A + A dA, also where principal
    // values are equal.
    Lattice::Random random(311);
    for (unsigned int n = 0; n < 60; ++n)
      {
        SymmetricTensor<2, 3> A = random.stress<3>(3.);
        if (n % 2 == 0)
          A[0][2] = A[1][2] = 0.;
        if (n % 3 == 0)
          {
            A[0][1] = 0.;
            A[1][1] = A[0][0];
          }
        const PrincipalStress p = principal_stress(A);
        std::array<double, 3> square;
        double                slope[3][3] = {};
        for (unsigned int i = 0; i < 3; ++i)
          {
            square[i]   = p.value[i] * p.value[i];
            slope[i][i] = 2. * p.value[i];
          }
        const auto D      = isotropic_derivative(p, square, slope);
        const auto change = random.stress<3>(1.);
        const auto expected =
          2. * symmetrize(Tensor<2, 3>(change) * Tensor<2, 3>(A));
        EXPECT_LT((D * change - expected).norm(), 1e-7 * expected.norm()) << n;
        // The same by the elastic strain of the argument.
        const auto after = isotropic_derivative(p, square, slope, 6., 5.);
        const auto of_strain =
          D * (6. * change + 5. * trace(change) * unit_symmetric_tensor<3>());
        EXPECT_LT((after * change - of_strain).norm(), 1e-13 * after.norm())
          << n;
      }
  }
} // namespace materials_principal
