// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/von_mises_softening.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>

namespace materials_tangent_block
{
  // tangent_block() against the tangents of update(), point by point.

  using namespace Waker;

  namespace
  {
    constexpr unsigned int N = Material::block_size;


    /// Random states in all regimes, of `components` of stress and strain.
    void
    check_tangents(const Material                  &material,
                   const unsigned int               n_points,
                   const std::vector<unsigned int> &components,
                   Lattice::Random                 &random)
    {
      const unsigned int    n               = components.size();
      Material::Block       block           = {};
      double                variables[3][N] = {};
      double                tangent[36][N];
      SymmetricTensor<4, 3> expected[N];
      block.variables = variables;
      for (unsigned int l = 0; l < n_points; ++l)
        {
          const auto strain =
            random.stress<3>(l % 3 == 0 ? 0.003 : (l % 3 == 1 ? 0.03 : 0.2));
          auto stress = random.stress<3>(4.) - 30. * unit_symmetric_tensor<3>();
          double own[3] = {random(5., 13.),
                           l % 4 == 0 ? 0. : (l % 7 == 5 ? 9. : 5.),
                           0.1};
          for (unsigned int v = 0; v < 3; ++v)
            variables[v][l] = own[v];
          for (unsigned int a = 0; a < 6; ++a)
            {
              block.strain_increment[a][l] = strain.access_raw_entry(a);
              block.stress[a][l]           = stress.access_raw_entry(a);
            }
          material.update(strain, stress, own, &expected[l]);
        }
      material.tangent_block(n_points, block, n, components.data(), tangent);
      for (unsigned int l = 0; l < n_points; ++l)
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b < n; ++b)
            ASSERT_NEAR(tangent[n * a + b][l],
                        expected[l].access_raw_entry(6 * components[a] +
                                                     components[b]),
                        1e-10);
    }
  } // namespace


  TEST(Materials, tangents_of_a_block_are_those_of_its_points)
  {
    Lattice::Random         random(132);
    const VonMisesSoftening clay(1.5, 1000., 0.45, 13., 5., -50.);
    const VonMisesSoftening perfect(1.5, 1000., 0.3, 13., 13., 0.);
    const LinearElastic     rubber(1.5, 1000., 0.45); // by default: one by one
    for (unsigned int n = 1; n <= N; ++n)
      for (const std::vector<unsigned int> &components :
           {std::vector<unsigned int>{0, 1, 3}, {0, 1, 2, 3, 4, 5}})
        {
          check_tangents(clay, n, components, random);
          check_tangents(perfect, n, components, random);
          check_tangents(rubber, n, components, random);
        }
  }
} // namespace materials_tangent_block
