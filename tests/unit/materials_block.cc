// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/von_mises_softening.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>

namespace materials_block
{
  // update_block() against update(), point by point.

  using namespace Waker;

  namespace
  {
    constexpr unsigned int N  = Material::block_size;
    constexpr double       no = std::numeric_limits<double>::signaling_NaN();


    /// Random states in all regimes; those beyond n_points are zero.
    void
    check_block(const Material    &material,
                const unsigned int n_points,
                Lattice::Random   &random)
    {
      const unsigned int    n_variables     = material.variables().size();
      Material::Block       block           = {};
      double                variables[3][N] = {};
      SymmetricTensor<2, 3> stress[N];
      double                expected_variables[3][N] = {}, energy[N] = {};
      block.variables = variables;
      for (double &value : block.dissipation)
        value = no;
      for (unsigned int l = 0; l < n_points; ++l)
        {
          const auto strain =
            random.stress<3>(l % 3 == 0 ? 0.003 : (l % 3 == 1 ? 0.03 : 0.2));
          stress[l] = random.stress<3>(4.) - 30. * unit_symmetric_tensor<3>();
          const double start[3] = {random(5., 13.),
                                   l % 4 == 0 ? 0. : (l % 7 == 5 ? 9. : 5.),
                                   random(0., 0.1)};
          for (unsigned int v = 0; v < n_variables; ++v)
            variables[v][l] = l % 5 == 0 && v == 0 ? 5. : start[v];
          double own[3] = {variables[0][l], variables[1][l], variables[2][l]};
          for (unsigned int a = 0; a < 6; ++a)
            {
              block.strain_increment[a][l] = strain.access_raw_entry(a);
              block.stress[a][l]           = stress[l].access_raw_entry(a);
            }
          energy[l] = material.update(strain, stress[l], own, nullptr);
          for (unsigned int v = 0; v < n_variables; ++v)
            expected_variables[v][l] = own[v];
        }
      material.update_block(n_points, block);
      for (unsigned int l = 0; l < n_points; ++l)
        {
          for (unsigned int a = 0; a < 6; ++a)
            ASSERT_NEAR(block.stress[a][l],
                        stress[l].access_raw_entry(a),
                        1e-11);
          for (unsigned int v = 0; v < n_variables; ++v)
            ASSERT_NEAR(variables[v][l], expected_variables[v][l], 1e-12);
          ASSERT_NEAR(block.dissipation[l], energy[l], 1e-12);
          ASSERT_GE(block.dissipation[l], 0.);
        }
    }
  } // namespace


  TEST(Materials, a_block_is_updated_as_its_points)
  {
    Lattice::Random         random(131);
    const VonMisesSoftening clay(1.5, 1000., 0.45, 13., 5., -50.);
    const VonMisesSoftening half(
      1.5, 1000., 0.45, 13., 5., -50., VonMisesSoftening::Invariant::half);
    const VonMisesSoftening perfect(1.5, 1000., 0.3, 13., 13., 0.);
    const LinearElastic     rubber(1.5, 1000., 0.45);
    for (unsigned int n = 1; n <= N; ++n)
      for (unsigned int trial = 0; trial < 20; ++trial)
        {
          check_block(clay, n, random);
          check_block(half, n, random);
          check_block(perfect, n, random);
          check_block(rubber, n, random);
        }
  }


  TEST(Materials, a_point_weaker_than_its_residual_strength_keeps_its_own)
  {
    // A random field may give a point less than its residual strength.
    const VonMisesSoftening clay(1.5, 1000., 0.45, 13., 5., -50.);
    const VonMisesSoftening perfect(1.5, 1000., 0.45, 3., 3., 0.);
    Lattice::Random         random(133);
    for (unsigned int n = 0; n < 50; ++n)
      {
        const auto strain = random.stress<3>(0.05);
        const auto start =
          random.stress<3>(1.) - 30. * unit_symmetric_tensor<3>();
        auto   weak = start, expected = start;
        double of_weak[3] = {3., 5., 0.}, of_perfect[3] = {3., 3., 0.};
        SymmetricTensor<4, 3> tangent, expected_tangent;
        const double energy = clay.update(strain, weak, of_weak, &tangent);
        EXPECT_NEAR(
          energy,
          perfect.update(strain, expected, of_perfect, &expected_tangent),
          1e-13);
        EXPECT_GT(energy, 0.);
        EXPECT_EQ(of_weak[0], 3.);
        EXPECT_EQ(of_weak[1], 5.);
        EXPECT_NEAR(of_weak[2], of_perfect[2], 1e-15);
        EXPECT_LT((weak - expected).norm(), 1e-12);
        EXPECT_LT((tangent - expected_tangent).norm(), 1e-9);
      }
  }


  TEST(Materials, yield_at_zero_residual_strength_is_no_division_by_zero)
  {
    const VonMisesSoftening clay(1.5, 1000., 0.45, 13., 0., -50.);
    SymmetricTensor<2, 3>   strain, stress;
    double                  variables[3] = {13., 0., 0.};
    strain[0][1]                         = 1.;
    SymmetricTensor<4, 3> tangent;
    clay.update(strain, stress, variables, &tangent);
    EXPECT_EQ(variables[0], 0.);
    EXPECT_LT(stress.norm(), 1e-10);
    EXPECT_TRUE(std::isfinite(tangent.norm()));
    // And from there on, without and with strain.
    for (const double step : {0., 0.01})
      {
        strain[0][1] = step;
        EXPECT_EQ(clay.update(strain, stress, variables, &tangent), 0.);
        EXPECT_LT(stress.norm(), 1e-10);
        EXPECT_TRUE(std::isfinite(tangent.norm()));
      }
  }
} // namespace materials_block
