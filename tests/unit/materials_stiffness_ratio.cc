// SPDX-License-Identifier: LGPL-2.1-or-later
// Points with a stiffness ratio r against a law whose modulus is r times as
// large: stress, variables, dissipation, tangent, alone and in blocks.
#include <waker/materials/factory.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>
#include <memory>

namespace materials_stiffness_ratio
{
  using namespace Waker;

  namespace
  {
    constexpr unsigned int N = Material::block_size;

    MaterialParameters
    parameters(const MaterialModel model)
    {
      MaterialParameters p;
      p.model                          = model;
      p.elastic.youngs_modulus         = 1000.;
      p.elastic.poissons_ratio         = 0.3;
      p.von_mises.initial_strength     = "13";
      p.von_mises.softening_modulus    = -40.;
      p.mohr_coulomb.cohesion          = "8";
      p.mohr_coulomb.friction_angle    = "28";
      p.mohr_coulomb.residual_cohesion = "2";
      p.mohr_coulomb.dilatancy_angle   = "5";
      p.mohr_coulomb.softening_strain  = 0.3;
      return p;
    }


    std::vector<double>
    start(const Material &law)
    {
      std::vector<double> values;
      for (const MaterialVariable &variable : law.variables())
        values.push_back(variable.name == "residual friction angle" ? 28.
                         : variable.name == "residual dilatancy angle"
                           ? 5.
                           : variable.initial_value.number);
      return values;
    }
  } // namespace


  TEST(Materials, a_stiffness_ratio_is_a_modulus)
  {
    unsigned int n_plastic = 0;
    for (const MaterialModel model : {MaterialModel::linear_elastic,
                                      MaterialModel::von_mises_softening,
                                      MaterialModel::mohr_coulomb})
      for (const bool softens : {false, true})
        {
          MaterialParameters p = parameters(model);
          if (!softens)
            {
              p.von_mises.softening_modulus   = 0.;
              p.mohr_coulomb.softening_strain = 0.;
            }
          const auto own   = make_material(p, 10., 1.);
          p.elastic.varies = true;
          const auto law   = make_material(p, 10., 1.);
          EXPECT_FALSE(own->stiffness_variable());
          const unsigned int n = law->variables().size();
          ASSERT_EQ(n, own->variables().size() + 1);
          ASSERT_TRUE(law->stiffness_variable());
          EXPECT_EQ(*law->stiffness_variable(), n - 1);
          EXPECT_EQ(law->variables()[n - 1].name, "stiffness ratio");

          Lattice::Random       random(7);
          Material::Block       block            = {};
          double                variables[16][N] = {};
          SymmetricTensor<2, 3> ends[N];
          SymmetricTensor<4, 3> tangents[N];
          std::vector<double>   left[N];
          double                lost[N];
          block.variables            = variables;
          Material::Block of_tangent = {};
          double          copy[16][N];
          for (unsigned int l = 0; l < N; ++l)
            {
              const double r           = 0.5 + 0.1 * l;
              p.elastic.youngs_modulus = 1000. * r;
              p.elastic.varies         = false;
              const auto stiff         = make_material(p, 10., 1.);
              const auto strain        = random.stress<3>(l % 3 == 0   ? 0.002
                                                          : l % 3 == 1 ? 0.02
                                                                       : 0.1);
              const auto before =
                random.stress<3>(3.) - 20. * unit_symmetric_tensor<3>();
              std::vector<double>   a = start(*own), b = start(*law);
              SymmetricTensor<2, 3> one = before, two = before;
              SymmetricTensor<4, 3> C, D;
              b.back()              = r;
              const double lost_one = stiff->update(strain, one, a.data(), &C);
              for (unsigned int v = 0; v < n; ++v)
                variables[v][l] = b[v];
              for (unsigned int k = 0; k < 6; ++k)
                {
                  block.strain_increment[k][l] = strain.access_raw_entry(k);
                  block.stress[k][l]           = before.access_raw_entry(k);
                }
              lost[l] = law->update(strain, two, b.data(), &D);
              // Sums in another order: round-off.
              EXPECT_NEAR((one - two).norm(), 0., 1e-10);
              EXPECT_NEAR(lost_one, lost[l], 1e-10);
              for (unsigned int v = 0; v + 1 < n; ++v)
                EXPECT_NEAR(a[v], b[v], 1e-11);
              EXPECT_EQ(b.back(), r);
              EXPECT_NEAR((C - D).norm(), 0., 1e-7);
              n_plastic += lost_one > 0.;
              ends[l]     = two;
              tangents[l] = D;
              left[l]     = b;
            }
          of_tangent = block;
          std::copy_n(&variables[0][0], 16 * N, &copy[0][0]);
          of_tangent.variables = copy;
          law->update_block(N, block);
          double             entries[36][N];
          const unsigned int components[6] = {0, 1, 2, 3, 4, 5};
          law->tangent_block(N, of_tangent, 6, components, entries);
          for (unsigned int l = 0; l < N; ++l)
            {
              for (unsigned int k = 0; k < 6; ++k)
                EXPECT_NEAR(block.stress[k][l],
                            ends[l].access_raw_entry(k),
                            1e-10);
              EXPECT_NEAR(block.dissipation[l], lost[l], 1e-10);
              for (unsigned int v = 0; v < n; ++v)
                EXPECT_NEAR(variables[v][l], left[l][v], 1e-11);
              for (unsigned int i = 0; i < 36; ++i)
                EXPECT_NEAR(entries[i][l],
                            tangents[l].access_raw_entry(i),
                            1e-7);
            }
        }
    EXPECT_GT(n_plastic, 20u);
  }


  TEST(Materials, softer_soil_may_snap_back)
  {
    MaterialParameters p   = parameters(MaterialModel::von_mises_softening);
    const auto         law = make_material(p, 10., 1.);
    // 3 G r + sqrt(3) H_s = 0.
    EXPECT_NEAR(law->least_stiffness_ratio(),
                40. * std::sqrt(3.) / (3. * law->shear_modulus()),
                1e-14);
    p.von_mises.softening_modulus = 0.;
    EXPECT_EQ(make_material(p, 10., 1.)->least_stiffness_ratio(), 0.);
    EXPECT_EQ(make_material(parameters(MaterialModel::mohr_coulomb), 10., 1.)
                ->least_stiffness_ratio(),
              0.);
  }
} // namespace materials_stiffness_ratio
