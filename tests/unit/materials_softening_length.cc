// SPDX-License-Identifier: LGPL-2.1-or-later
// A softening length: in larger cells soil softens with less plastic strain.
#include <waker/materials/factory.h>

#include <gtest/gtest.h>

namespace materials_softening_length
{
  using namespace Waker;

  namespace
  {
    /// Shear stress after a simple shear in 200 steps to gamma = 0.3.
    double
    sheared(const Material &material)
    {
      std::vector<double> variables;
      for (const MaterialVariable &variable : material.variables())
        variables.push_back(variable.initial_value.number);
      SymmetricTensor<2, 3> stress = -20. * unit_symmetric_tensor<3>();
      SymmetricTensor<2, 3> step;
      step[0][1] = 0.5 * 0.3 / 200;
      for (unsigned int n = 0; n < 200; ++n)
        material.update(step, stress, variables.data(), nullptr);
      return stress[0][1];
    }


    double
    sheared(const MaterialParameters &parameters, const double cell_size)
    {
      parameters.check(2, cell_size);
      return sheared(*make_material(parameters, 9.81, cell_size));
    }
  } // namespace


  TEST(Materials, softening_that_belongs_to_a_length_scales_with_the_cells)
  {
    MaterialParameters clay;
    clay.name                        = "clay";
    clay.von_mises.softening_modulus = -20.;
    MaterialParameters sand;
    sand.name                           = "sand";
    sand.model                          = MaterialModel::mohr_coulomb;
    sand.elastic.youngs_modulus         = 5000.;
    sand.mohr_coulomb.cohesion          = "12";
    sand.mohr_coulomb.residual_cohesion = "4";
    sand.mohr_coulomb.residual_friction = "20";
    sand.mohr_coulomb.softening_strain  = 0.4;
    for (MaterialParameters *const soil : {&clay, &sand})
      {
        MaterialParameters twice            = *soil;
        twice.von_mises.softening_modulus   = -40.;
        twice.mohr_coulomb.softening_strain = 0.2;
        const double as_it_is               = sheared(*soil, 0.25),
                     steep                  = sheared(twice, 0.25);
        EXPECT_GT(as_it_is, steep + 0.5);
        // Without a length cells do not matter; with it, those of its size
        // soften as they are.
        EXPECT_EQ(sheared(*soil, 0.5), as_it_is);
        soil->softening_length = 0.25;
        EXPECT_EQ(sheared(*soil, 0.25), as_it_is);
        EXPECT_NEAR(sheared(*soil, 0.5), steep, 1e-12);
        EXPECT_GT(sheared(*soil, 0.125), as_it_is + 0.2);
      }
  }


  TEST(Materials, mohr_coulomb_snaps_back_where_it_says)
  {
    // In triaxial compression, on an edge, a point lets go with less strain
    // than on a face. Above the limit a strain that goes on finds all strengths
    // in between; below it the strength is gone at once.
    for (const double factor : {1.05, 0.9})
      {
        MaterialParameters sand;
        sand.model                          = MaterialModel::mohr_coulomb;
        sand.mohr_coulomb.cohesion          = "10";
        sand.mohr_coulomb.residual_cohesion = "2";
        sand.mohr_coulomb.softening_strain =
          factor * sand.mohr_coulomb.snap_back_strain(sand.elastic, 1., 0.);
        const auto          material = make_material(sand, 9.81, 0.25);
        std::vector<double> variables;
        for (const MaterialVariable &variable : material->variables())
          variables.push_back(variable.initial_value.number);
        SymmetricTensor<2, 3> stress = -200. * unit_symmetric_tensor<3>(), step;
        step[1][1]                   = -1e-5;
        step[0][0] = step[2][2] = 0.5e-5;
        double largest_jump     = 0.;
        for (unsigned int n = 0; n < 40000; ++n)
          {
            const double before = variables.back();
            material->update(step, stress, variables.data(), nullptr);
            largest_jump = std::max(largest_jump, variables.back() - before);
          }
        EXPECT_GT(variables.back(), sand.mohr_coulomb.softening_strain);
        const double share = largest_jump / sand.mohr_coulomb.softening_strain;
        if (factor > 1.)
          {
            EXPECT_LT(share, 0.1);
          }
        else
          {
            EXPECT_GT(share, 0.9);
          }
      }
  }
} // namespace materials_softening_length
