// SPDX-License-Identifier: LGPL-2.1-or-later
// Undrained by effective parameters: what the water in the pores does.
#include <waker/base/errors.h>
#include <waker/materials/factory.h>
#include <waker/materials/mohr_coulomb.h>
#include <waker/materials/undrained_soil.h>
#include <waker/mechanics/time_scheme.h>

#include "mapping_lattice.h"
#include "user_errors.h"
#include <cmath>
#include <gtest/gtest.h>
#include <memory>

namespace materials_undrained_soil
{
  using namespace Waker;

  namespace
  {
    const double     degree = std::acos(-1.) / 180.;
    constexpr double E = 10000., nu = 0.3;
    constexpr double K_prime = E / (3. * (1. - 2. * nu));

    std::unique_ptr<Material>
    soil(const double psi = 0.)
    {
      return std::make_unique<MohrCoulomb>(
        1.8, E, nu, MohrCoulomb::Angles{{5.}, {30.}, {psi}}, 0.);
    }


    /// A point of it, and what it has gone through.
    struct Sample
    {
      explicit Sample(const double water, const double psi = 0.)
        : law(soil(psi), water)
        , variables{5., 30., psi, 0., 0.}
      {}

      double
      strain(const SymmetricTensor<2, 3> &increment)
      {
        return law.update(increment, stress, variables, nullptr);
      }

      double
      excess() const
      {
        return variables[4];
      }

      SymmetricTensor<2, 3>
      effective() const
      {
        return stress + excess() * unit_symmetric_tensor<3>();
      }

      UndrainedSoil         law;
      SymmetricTensor<2, 3> stress;
      double                variables[5];
    };


    SymmetricTensor<2, 3>
    diagonal(const double x, const double y, const double z)
    {
      SymmetricTensor<2, 3> t;
      t[0][0] = x;
      t[1][1] = y;
      t[2][2] = z;
      return t;
    }
  } // namespace


  // Skempton (1954): B = K_f / (K' + K_f) under all-round pressure.
  TEST(UndrainedSoil, water_takes_its_share_of_a_pressure)
  {
    for (const double water : {1e2, K_prime, 1e6})
      {
        Sample sample(water);
        sample.strain(-1e-5 * unit_symmetric_tensor<3>());
        const double pressure = -trace(sample.stress) / 3.;
        EXPECT_NEAR(sample.excess() / pressure,
                    water / (K_prime + water),
                    1e-12);
        EXPECT_NEAR(pressure, 3e-5 * (K_prime + water), 1e-12 * pressure);
      }
  }


  // Triaxial compression at a constant cell pressure of water like rock: the
  // effective mean stress stays p0 (psi = 0), so q = 6 (p0 sin phi + c cos phi)
  // / (3 - sin phi), and u is what the total stress has more: q / 3.
  TEST(UndrainedSoil, triaxial_compression_has_its_closed_form)
  {
    constexpr double p0 = 100.;
    const double     s = std::sin(30. * degree), c = std::cos(30. * degree);
    const double     q_end = 6. * (p0 * s + 5. * c) / (3. - s);
    Sample           sample(1e9);
    sample.stress = -p0 * unit_symmetric_tensor<3>();
    double q      = 0.;
    for (unsigned int i = 0; i < 400; ++i)
      {
        // The radial strain that keeps the radial stress: by the chord, as the
        // law is linear in it but for the kink.
        const double axial = -1e-4;
        double       low = 0.4 * -axial, high = 0.6 * -axial;
        for (unsigned int k = 0; k < 100; ++k)
          {
            const double radial = 0.5 * (low + high);
            Sample       tried(1e9);
            tried.stress = sample.stress;
            std::copy_n(sample.variables, 5, tried.variables);
            tried.strain(diagonal(radial, axial, radial));
            (tried.stress[0][0] < -p0 ? low : high) = radial;
          }
        sample.strain(diagonal(low, axial, low));
        q = sample.stress[0][0] - sample.stress[1][1];
        // Elastic: q = 3 G eps; and p' stays.
        const double elastic = 3. * sample.law.shear_modulus() * 1e-4 * (i + 1);
        EXPECT_NEAR(q, std::min(elastic, q_end), 1e-4 * q_end) << i;
        EXPECT_NEAR(-trace(sample.effective()) / 3., p0, 1e-3) << i;
        EXPECT_NEAR(sample.excess(), q / 3., 1e-3) << i;
      }
    EXPECT_NEAR(q, q_end, 1e-4 * q_end);
    EXPECT_GT(sample.variables[3], 1e-3); // it has yielded
  }


  // Simple shear in plane strain keeps the volume: s_u = c cos phi + s' sin phi
  // with s' of the start, from K0 stress too.
  TEST(UndrainedSoil, simple_shear_gives_the_undrained_strength)
  {
    for (const double K0 : {1., 0.5})
      {
        Sample sample(1e6);
        sample.stress        = diagonal(-K0 * 80., -80., -K0 * 80.);
        const double s_prime = 0.5 * (1. + K0) * 80.;
        const double expected =
          5. * std::cos(30. * degree) + s_prime * std::sin(30. * degree);
        double tau = 0.;
        for (unsigned int i = 0; i < 2000; ++i)
          {
            SymmetricTensor<2, 3> shear;
            shear[0][1] = 5e-5;
            EXPECT_GE(sample.strain(shear), 0.);
            const SymmetricTensor<2, 3> t = sample.effective();
            tau = std::hypot(0.5 * (t[0][0] - t[1][1]), t[0][1]);
            ASSERT_NEAR(-0.5 * (t[0][0] + t[1][1]), s_prime, 1e-8);
            ASSERT_LT(tau, expected * (1. + 1e-9));
          }
        EXPECT_NEAR(tau, expected, 1e-9 * expected);
        EXPECT_NEAR(sample.excess(), 0., 1e-9); // no volume, no pressure
      }
  }


  // With dilatancy the grains press themselves apart against the water, and
  // strength grows without limit: the negative control of the above, and what
  // the page warns of.
  TEST(UndrainedSoil, dilatant_soil_gets_stronger)
  {
    Sample sample(1e6, 10.);
    sample.stress = -80. * unit_symmetric_tensor<3>();
    SymmetricTensor<2, 3> shear;
    shear[0][1] = 5e-5;
    for (unsigned int i = 0; i < 2000; ++i)
      sample.strain(shear);
    EXPECT_NEAR(sample.excess(), 0., 1e-9); // no volume change in all
    const SymmetricTensor<2, 3> t = sample.effective();
    EXPECT_GT(-trace(t) / 3., 200.);
  }


  TEST(UndrainedSoil, the_tangent_is_the_derivative)
  {
    Lattice::Random    random(61);
    const double       delta     = 1e-7;
    unsigned int       n_plastic = 0;
    const unsigned int n         = 100;
    for (unsigned int i = 0; i < n; ++i)
      {
        Sample start(random(1e3, 1e5), i % 2 == 0 ? 0. : 10.);
        start.variables[4] = random(-20., 50.);
        start.stress       = random.stress<3>(20.);
        start.stress +=
          (-60. - start.variables[4]) * unit_symmetric_tensor<3>();
        const SymmetricTensor<2, 3> strain = random.stress<3>(0.01);
        const auto after = [&](const SymmetricTensor<2, 3> &change,
                               SymmetricTensor<4, 3>       *D) {
          SymmetricTensor<2, 3> stress = start.stress;
          double                variables[5];
          std::copy_n(start.variables, 5, variables);
          start.law.update(strain + change, stress, variables, D);
          if (D != nullptr)
            n_plastic += variables[3] > 0. ? 1 : 0;
          return stress;
        };
        SymmetricTensor<4, 3> D;
        after({}, &D);
        double size = 0., error = 0.;
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = k; l < 3; ++l)
            {
              SymmetricTensor<2, 3> e;
              e[k][l] = delta;
              const auto by_differences =
                (after(e, nullptr) - after(-1. * e, nullptr)) /
                (k == l ? 2. * delta : 4. * delta);
              for (unsigned int a = 0; a < 3; ++a)
                for (unsigned int b = a; b < 3; ++b)
                  {
                    size = std::max(size, std::abs(D[a][b][k][l]));
                    error =
                      std::max(error,
                               std::abs(by_differences[a][b] - D[a][b][k][l]));
                  }
            }
        EXPECT_LT(error, 1e-5 * size) << i;
      }
    EXPECT_GT(n_plastic, n / 2);
  }


  TEST(UndrainedSoil, a_block_is_its_points_one_by_one)
  {
    constexpr unsigned int N = Material::block_size, n = 13;
    Lattice::Random        random(5);
    const UndrainedSoil    law(soil(5.), 3e4);
    Material::Block        block           = {};
    double                 variables[5][N] = {};
    block.variables                        = variables;
    SymmetricTensor<2, 3> strain[n], stress[n], after[n];
    SymmetricTensor<4, 3> D[n];
    double                point[n][5], dissipation[n];
    for (unsigned int l = 0; l < n; ++l)
      {
        strain[l] = random.stress<3>(l % 3 == 0 ? 1e-4 : 0.01);
        stress[l] = random.stress<3>(10.) - 60. * unit_symmetric_tensor<3>();
        const double start[5] = {5., 30., 5., 0.01, random(-5., 30.)};
        std::copy_n(start, 5, point[l]);
        for (unsigned int a = 0; a < 6; ++a)
          {
            block.strain_increment[a][l] = strain[l].access_raw_entry(a);
            block.stress[a][l]           = stress[l].access_raw_entry(a);
          }
        for (unsigned int v = 0; v < 5; ++v)
          variables[v][l] = start[v];
        after[l]       = stress[l];
        dissipation[l] = law.update(strain[l], after[l], point[l], &D[l]);
      }
    const unsigned int components[6]  = {0, 1, 2, 3, 4, 5};
    double             tangent[36][N] = {};
    Material::Block    copy           = block;
    law.tangent_block(n, copy, 6, components, tangent);
    // The block's variables are those of its caller.
    for (unsigned int l = 0; l < n; ++l)
      for (unsigned int a = 0; a < 6; ++a)
        for (unsigned int b = 0; b < 6; ++b)
          ASSERT_NEAR(tangent[6 * a + b][l],
                      D[l].access_raw_entry(6 * a + b),
                      1e-6);
    law.update_block(n, block);
    double energy[N];
    law.elastic_energy(block, energy);
    for (unsigned int l = 0; l < n; ++l)
      {
        for (unsigned int a = 0; a < 6; ++a)
          ASSERT_NEAR(block.stress[a][l], after[l].access_raw_entry(a), 1e-9);
        for (unsigned int v = 0; v < 5; ++v)
          ASSERT_NEAR(variables[v][l], point[l][v], 1e-9);
        ASSERT_NEAR(block.dissipation[l], dissipation[l], 1e-9);
        // 3/2 G's share of the deviator, K' and K_f of their pressures.
        const auto   t = after[l] + point[l][4] * unit_symmetric_tensor<3>();
        const double p = trace(t) / 3., G = law.shear_modulus();
        const auto   s = deviator(t);
        EXPECT_NEAR(energy[l],
                    p * p / (2. * K_prime) + s * s / (4. * G) +
                      point[l][4] * point[l][4] / (2. * 3e4),
                    1e-9);
      }
  }


  // Work is energy and dissipation, to the square of the steps.
  TEST(UndrainedSoil, no_energy_is_lost)
  {
    const auto remainder = [](const unsigned int n_steps) {
      Sample sample(2e4, 5.);
      sample.stress                = -50. * unit_symmetric_tensor<3>();
      const double          before = 50. * 50. / (2. * K_prime);
      double                work = 0., dissipation = 0.;
      SymmetricTensor<2, 3> strain = diagonal(-0.002, -0.006, 0.001);
      strain[0][1]                 = 0.01;
      strain *= 1. / n_steps;
      for (unsigned int i = 0; i < n_steps; ++i)
        {
          const SymmetricTensor<2, 3> old = sample.stress;
          dissipation += sample.strain(strain);
          work += 0.5 * (old + sample.stress) * strain;
        }
      Material::Block block                              = {};
      double          variables[5][Material::block_size] = {};
      block.variables                                    = variables;
      for (unsigned int a = 0; a < 6; ++a)
        block.stress[a][0] = sample.stress.access_raw_entry(a);
      for (unsigned int v = 0; v < 5; ++v)
        variables[v][0] = sample.variables[v];
      double energy[Material::block_size];
      sample.law.elastic_energy(block, energy);
      EXPECT_GT(dissipation, 0.05);
      return (work - dissipation - (energy[0] - before)) / work;
    };
    const double coarse = remainder(50), fine = remainder(500);
    EXPECT_LT(std::abs(fine), 0.02);
    EXPECT_LT(std::abs(fine), 0.15 * std::abs(coarse));
  }


  TEST(UndrainedSoil, waves_run_in_its_water)
  {
    Materials materials;
    materials.push_back(std::make_unique<UndrainedSoil>(soil(), 5e5));
    const double G = materials[0]->shear_modulus();
    EXPECT_NEAR(wave_speed(materials),
                std::sqrt((K_prime + 5e5 + 4. / 3. * G) / 1.8),
                1e-10);
    EXPECT_EQ(materials[0]->bulk_modulus(), K_prime);
    EXPECT_TRUE(materials[0]->is_of_effective_stress());
    EXPECT_FALSE(materials[0]->has_symmetric_tangent());
  }


  TEST(UndrainedSoil, the_user_asks_for_it)
  {
    MaterialParameters p;
    p.name                   = "clay";
    p.model                  = MaterialModel::mohr_coulomb;
    p.elastic.youngs_modulus = E;
    p.elastic.poissons_ratio = nu;
    p.pore_fluid_stiffness   = 1e5;
    p.check(2, 0.5);
    const auto law = make_material(p, 9.81, 0.5);
    EXPECT_EQ(law->pore_fluid_stiffness(), 1e5);
    EXPECT_EQ(law->variables().back().name, "excess pore pressure");
    EXPECT_NEAR(p.undrained_poissons_ratio(), 0.482456, 1e-6);
    const std::string path = "Materials/clay/Pore fluid stiffness";
    for (const double stiffness : {-1., Waker::nan, 1e308, 1e8})
      {
        p.pore_fluid_stiffness = stiffness;
        EXPECT_USER_ERROR(p.check(2, 0.5), path, "is ");
      }
    p.pore_fluid_stiffness = 1e4;
    p.model                = MaterialModel::von_mises_softening;
    EXPECT_USER_ERROR(p.check(2, 0.5), path, "a law of total stress");
    p.pore_fluid_stiffness = 0.;
    EXPECT_NO_THROW(p.check(2, 0.5));
    p.model = MaterialModel::mohr_coulomb;
    EXPECT_EQ(make_material(p, 9.81, 0.5)->pore_fluid_stiffness(), 0.);
  }
} // namespace materials_undrained_soil
