// SPDX-License-Identifier: LGPL-2.1-or-later
// Mohr-Coulomb's tangent against central differences of the stress, all 36
// components, and blocks of points against single ones.
#include <waker/materials/mohr_coulomb.h>

#include "mapping_lattice.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace materials_mohr_coulomb_tangent
{
  using namespace Waker;

  namespace
  {
    constexpr double       infinity = std::numeric_limits<double>::infinity();
    constexpr unsigned int N        = Material::block_size;


    struct Input
    {
      SymmetricTensor<2, 3> stress, strain;
      std::vector<double>   variables;
    };


    SymmetricTensor<2, 3>
    stress_after(const Material              &material,
                 const Input                 &input,
                 const SymmetricTensor<2, 3> &change,
                 SymmetricTensor<4, 3>       *tangent = nullptr)
    {
      std::vector<double>   variables = input.variables;
      SymmetricTensor<2, 3> stress    = input.stress;
      material.update(input.strain + change, stress, variables.data(), tangent);
      return stress;
    }


    SymmetricTensor<4, 3>
    differences(const Material &material,
                const Input    &input,
                const double    delta)
    {
      SymmetricTensor<4, 3> D;
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int l = k; l < 3; ++l)
          {
            SymmetricTensor<2, 3> e;
            e[k][l]         = delta; // for k != l also the entry (l, k)
            const auto rate = (stress_after(material, input, e) -
                               stress_after(material, input, -1. * e)) /
                              (k == l ? 2. * delta : 4. * delta);
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int j = i; j < 3; ++j)
                D[i][j][k][l] = rate[i][j];
          }
      return D;
    }


    double
    asymmetry(const SymmetricTensor<4, 3> &D)
    {
      double most = 0.;
      for (unsigned int a = 0; a < 6; ++a)
        for (unsigned int b = 0; b < 6; ++b)
          most = std::max(most,
                          std::abs(D.access_raw_entry(6 * a + b) -
                                   D.access_raw_entry(6 * b + a)));
      return most;
    }


    struct Soil
    {
      const char         *name;
      MohrCoulomb         law;
      std::vector<double> variables;
      bool                is_symmetric;
    };


    std::vector<Soil>
    soils()
    {
      const double E = 5000., nu = 0.3;
      return {
        {"perfect, no dilatancy",
         MohrCoulomb(1.8, E, nu, {5., 30., 0.}, 1.),
         {5., 30., 0., 0.},
         false},
        {"associated",
         MohrCoulomb(1.8, E, nu, {5., 30., 30.}, infinity),
         {5., 30., 30., 0.},
         true},
        {"no friction",
         MohrCoulomb(1.8, E, nu, {12., 0., 0.}, infinity),
         {12., 0., 0., 0.},
         true},
        {"softening",
         MohrCoulomb(1.8, E, nu, {8., 35., 10.}, infinity, {2., 25., 0.}, 0.3),
         {8., 35., 10., 2., 25., 0., 0.05},
         false},
        {"softening, associated at its end",
         MohrCoulomb(1.8, E, nu, {8., 35., 20.}, 0.5, {2., 15., 15.}, 0.1),
         {8., 35., 20., 2., 15., 15., 0.02},
         false}};
    }
  } // namespace


  TEST(Materials, mohr_coulomb_tangent_is_the_derivative)
  {
    for (const Soil &soil : soils())
      {
        Lattice::Random random(223);
        unsigned int    n_plastic = 0, n_compared = 0, n_unsymmetric = 0;
        for (unsigned int n = 0; n < 600; ++n)
          {
            Input input{random.stress<3>(10.),
                        random.stress<3>(0.01),
                        soil.variables};
            if (n % 2 == 0) // as in plane strain
              for (auto *const tensor : {&input.stress, &input.strain})
                (*tensor)[0][2] = (*tensor)[1][2] = 0.;
            input.stress += random(-60., 5.) * unit_symmetric_tensor<3>();
            SymmetricTensor<4, 3> D;
            const auto            end   = stress_after(soil.law, input, {}, &D);
            SymmetricTensor<2, 3> trial = input.stress;
            LinearElastic(1.8, 5000., 0.3)
              .update(input.strain, trial, nullptr, nullptr);
            n_plastic += (end - trial).norm() > 1e-8;

            // Where another plane begins to hold within the differences' reach
            // there is no derivative: two of different reach tell.
            const auto wide   = differences(soil.law, input, 1e-6);
            const auto narrow = differences(soil.law, input, 1e-7);
            if ((wide - narrow).norm() > 1e-6 * D.norm())
              continue;
            ++n_compared;
            EXPECT_LT((D - wide).norm(), 1e-6 * D.norm())
              << soil.name << ' ' << n;
            n_unsymmetric += asymmetry(D) > 1e-3 * D.norm();
          }
        EXPECT_GT(n_plastic, 300u) << soil.name;
        EXPECT_GT(n_compared, 540u) << soil.name;
        // A transposed tangent would be seen.
        if (soil.is_symmetric)
          EXPECT_EQ(n_unsymmetric, 0u) << soil.name;
        else
          EXPECT_GT(n_unsymmetric, 200u) << soil.name;
      }
  }


  TEST(Materials, mohr_coulomb_in_blocks_is_as_point_by_point)
  {
    Lattice::Random random(227);
    unsigned int    n_plastic = 0, n_elastic = 0;
    for (const Soil &soil : soils())
      for (unsigned int n = 1; n <= N; ++n)
        {
          const unsigned int    n_variables     = soil.variables.size();
          Material::Block       block           = {};
          double                variables[7][N] = {};
          double                expected[7][N]  = {}, energy[N];
          SymmetricTensor<2, 3> stress[N];
          SymmetricTensor<4, 3> tangents[N];
          block.variables = variables;
          for (unsigned int l = 0; l < n; ++l)
            {
              const auto strain = random.stress<3>(l % 3 == 0 ? 0.0005 : 0.01);
              stress[l]         = random.stress<3>(4.) -
                          random(0., 40.) * unit_symmetric_tensor<3>();
              std::vector<double> own = soil.variables;
              own[0] *= random(0.5, 1.5);
              for (unsigned int v = 0; v < n_variables; ++v)
                variables[v][l] = own[v];
              for (unsigned int a = 0; a < 6; ++a)
                {
                  block.strain_increment[a][l] = strain.access_raw_entry(a);
                  block.stress[a][l]           = stress[l].access_raw_entry(a);
                }
              energy[l] =
                soil.law.update(strain, stress[l], own.data(), &tangents[l]);
              (own.back() > soil.variables.back() ? n_plastic : n_elastic)++;
              for (unsigned int v = 0; v < n_variables; ++v)
                expected[v][l] = own[v];
            }
          Material::Block for_tangent = block;
          double          copy[7][N];
          std::copy_n(&variables[0][0], 7 * N, &copy[0][0]);
          for_tangent.variables = copy;

          soil.law.update_block(n, block);
          for (unsigned int l = 0; l < n; ++l)
            {
              for (unsigned int a = 0; a < 6; ++a)
                ASSERT_NEAR(block.stress[a][l],
                            stress[l].access_raw_entry(a),
                            1e-10);
              for (unsigned int v = 0; v < n_variables; ++v)
                ASSERT_NEAR(variables[v][l], expected[v][l], 1e-13);
              ASSERT_NEAR(block.dissipation[l], energy[l], 1e-11);
            }

          const unsigned int components[3] = {0, 1, 3};
          double             tangent[9][N];
          soil.law.tangent_block(n, for_tangent, 3, components, tangent);
          for (unsigned int l = 0; l < n; ++l)
            for (unsigned int a = 0; a < 3; ++a)
              for (unsigned int b = 0; b < 3; ++b)
                ASSERT_NEAR(tangent[3 * a + b][l],
                            tangents[l].access_raw_entry(6 * components[a] +
                                                         components[b]),
                            1e-8);
        }
    EXPECT_GT(n_plastic, 200u);
    EXPECT_GT(n_elastic, 100u);
  }
} // namespace materials_mohr_coulomb_tangent
