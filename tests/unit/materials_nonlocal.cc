// SPDX-License-Identifier: LGPL-2.1-or-later
// Laws that soften by their surroundings: strengths stay in a step, and follow
// the measure after it.
#include <waker/materials/factory.h>

#include "mapping_lattice.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace materials_nonlocal
{
  using namespace Waker;

  namespace
  {
    constexpr unsigned int N = Material::block_size;


    MaterialParameters
    clay()
    {
      MaterialParameters soil;
      soil.name            = "clay";
      soil.nonlocal.length = 0.5;
      return soil;
    }


    MaterialParameters
    sand()
    {
      MaterialParameters soil              = clay();
      soil.model                           = MaterialModel::mohr_coulomb;
      soil.elastic.youngs_modulus          = 5000.;
      soil.mohr_coulomb.cohesion           = "12";
      soil.mohr_coulomb.dilatancy_angle    = "5";
      soil.mohr_coulomb.tensile_strength   = "apex";
      soil.mohr_coulomb.residual_cohesion  = "4";
      soil.mohr_coulomb.residual_friction  = "20";
      soil.mohr_coulomb.residual_dilatancy = "0";
      soil.mohr_coulomb.softening_strain   = 0.1;
      return soil;
    }


    std::unique_ptr<Material>
    made(MaterialParameters soil, const Regularisation regularisation)
    {
      soil.regularisation = regularisation;
      soil.check(2, 0.25);
      return make_material(soil, 9.81, 0.25);
    }


    std::vector<double>
    initial(const Material &material)
    {
      std::vector<double> values;
      for (const MaterialVariable &variable : material.variables())
        values.push_back(variable.initial_value.number);
      return values;
    }


    unsigned int
    place(const Material &material, const std::string &name)
    {
      const auto all = material.variables();
      for (unsigned int v = 0; v < all.size(); ++v)
        if (all[v].name == name)
          return v;
      ADD_FAILURE() << name;
      return 0;
    }


    /// Shear stress after a shear to gamma, in a body that strains alike.
    double
    sheared(const Material &material, const unsigned int n_steps)
    {
      const SofteningMeasure measure = material.softening_measure();
      const unsigned int     plastic = place(material, "plastic strain");
      std::vector<double>    v       = initial(material);
      SymmetricTensor<2, 3>  stress  = -30. * unit_symmetric_tensor<3>(), step;
      step[0][1]                     = 0.5 * 0.15 / n_steps;
      for (unsigned int n = 0; n < n_steps; ++n)
        {
          const double before = v[plastic];
          const double dissipation =
            material.update(step, stress, v.data(), nullptr);
          EXPECT_GE(dissipation, 0.);
          if (!measure.is_local())
            material.soften(measure.of_uniform_strain() * (v[plastic] - before),
                            v.data());
        }
      return stress[0][1];
    }
  } // namespace


  TEST(Materials, nonlocal_softening_of_a_uniform_strain_is_local)
  {
    for (const MaterialParameters &soil : {clay(), sand()})
      {
        const auto local = made(soil, Regularisation::softening_length),
                   other = made(soil, Regularisation::nonlocal);
        EXPECT_TRUE(local->softening_measure().is_local());
        EXPECT_FALSE(other->softening_measure().is_local());
        EXPECT_EQ(other->softening_measure().own, -1.);
        EXPECT_EQ(other->softening_measure().of_uniform_strain(), 1.);
        // It lags by a step: the error is of first order. The reference has one
        // of second order of its own.
        const double exact  = sheared(*local, 25600);
        const double coarse = sheared(*other, 400) - exact,
                     fine   = sheared(*other, 800) - exact;
        EXPECT_GT(coarse, 1e-4);
        EXPECT_NEAR(coarse / fine, 2., 0.1) << name_of(soil.model);
      }
    // Soil that does not soften is local, whatever is asked for.
    MaterialParameters perfect          = clay();
    perfect.von_mises.softening_modulus = 0.;
    EXPECT_TRUE(
      made(perfect, Regularisation::nonlocal)->softening_measure().is_local());
  }


  TEST(Materials, lost_strength_does_not_come_back)
  {
    const auto          soil = made(clay(), Regularisation::nonlocal);
    std::vector<double> v    = initial(*soil);
    ASSERT_EQ(v.size(), 5u);
    const auto soften = [&](const double increment) {
      soil->soften(increment, v.data());
      return v[0];
    };
    EXPECT_DOUBLE_EQ(soften(0.04), 11.);
    EXPECT_DOUBLE_EQ(soften(-0.03), 11.);
    EXPECT_DOUBLE_EQ(soften(0.02), 11.); // below the most that it has been
    EXPECT_DOUBLE_EQ(soften(0.02), 10.5);
    EXPECT_NEAR(v[place(*soil, "nonlocal plastic strain")], 0.05, 1e-15);
    EXPECT_NEAR(v[place(*soil, "softening strain")], 0.05, 1e-15);
    EXPECT_TRUE(soil->can_soften(v.data()));
    EXPECT_EQ(soften(1.), 5.); // residual
    EXPECT_FALSE(soil->can_soften(v.data()));
    // A weak point may have less than its residual strength.
    v = {3., 5., 0., 0., 0.};
    EXPECT_FALSE(soil->can_soften(v.data()));
    EXPECT_EQ(soften(0.1), 3.);

    const auto          drained = made(sand(), Regularisation::nonlocal);
    std::vector<double> s       = initial(*drained);
    ASSERT_EQ(s.size(), 9u);
    EXPECT_TRUE(drained->can_soften(s.data()));
    drained->soften(0.1, s.data());
    EXPECT_FALSE(drained->can_soften(s.data()));
    EXPECT_EQ(s[0], 12.); // kept, with the strain that softens
  }


  TEST(Materials, tangents_of_nonlocal_softening_are_derivatives)
  {
    // The strengths of the step are those of its start: a tangent that softened
    // would differ by H_s.
    Lattice::Random random(91);
    unsigned int    n_yielding = 0;
    for (const MaterialParameters &parameters : {clay(), sand()})
      {
        const auto         soil    = made(parameters, Regularisation::nonlocal);
        const unsigned int plastic = place(*soil, "plastic strain");
        const unsigned int components[6]    = {0, 1, 2, 3, 4, 5};
        Material::Block    block            = {}, after;
        double             variables[16][N] = {}, new_variables[16][N];
        double             of_block[36][N];
        block.variables = variables;
        SymmetricTensor<4, 3> tangents[N];
        SymmetricTensor<2, 3> stresses[N];
        for (unsigned int l = 0; l < N; ++l)
          {
            const auto strain = random.stress<3>(l % 3 == 0 ? 3e-4 : 0.02);
            const auto start =
              random.stress<3>(2.) - 40. * unit_symmetric_tensor<3>();
            std::vector<double> v = initial(*soil);
            v[plastic]            = 0.2;
            soil->soften(random(0., 0.08), v.data());
            const auto end_of = [&](const SymmetricTensor<2, 3> &change,
                                    SymmetricTensor<4, 3> *tangent = nullptr) {
              std::vector<double>   w      = v;
              SymmetricTensor<2, 3> stress = start;
              soil->update(strain + change, stress, w.data(), tangent);
              n_yielding += tangent != nullptr && w[plastic] > v[plastic];
              for (unsigned int i = 0; i < w.size(); ++i)
                if (i != plastic)
                  {
                    EXPECT_EQ(w[i], v[i]);
                  }
              return stress;
            };
            stresses[l]        = end_of({}, &tangents[l]);
            const double delta = 1e-7;
            for (unsigned int a = 0; a < 6; ++a)
              {
                SymmetricTensor<2, 3> e;
                e.access_raw_entry(a) = delta;
                const auto rate       = (end_of(e) - end_of(-1. * e)) /
                                  (a < 3 ? 2. * delta : 4. * delta);
                for (unsigned int b = 0; b < 6; ++b)
                  EXPECT_NEAR(rate.access_raw_entry(b),
                              tangents[l].access_raw_entry(6 * b + a),
                              1e-5 * soil->shear_modulus());
              }
            for (unsigned int i = 0; i < v.size(); ++i)
              variables[i][l] = v[i];
            for (unsigned int a = 0; a < 6; ++a)
              {
                block.strain_increment[a][l] = strain.access_raw_entry(a);
                block.stress[a][l]           = start.access_raw_entry(a);
              }
          }
        after = block;
        std::copy(&variables[0][0],
                  &variables[0][0] + 16 * N,
                  &new_variables[0][0]);
        after.variables = new_variables;
        soil->update_block(N, after);
        soil->tangent_block(N, block, 6, components, of_block);
        for (unsigned int l = 0; l < N; ++l)
          for (unsigned int a = 0; a < 6; ++a)
            {
              EXPECT_NEAR(after.stress[a][l],
                          stresses[l].access_raw_entry(a),
                          1e-10);
              for (unsigned int b = 0; b < 6; ++b)
                EXPECT_NEAR(of_block[6 * a + b][l],
                            tangents[l].access_raw_entry(6 * a + b),
                            1e-8);
            }
      }
    EXPECT_GT(n_yielding, 12u);
    EXPECT_LT(n_yielding, 30u);
  }
} // namespace materials_nonlocal
