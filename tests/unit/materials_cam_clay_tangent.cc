// SPDX-License-Identifier: LGPL-2.1-or-later
// Modified Cam clay: tangent, blocks, turned axes, and what a point starts
// with.
#include <waker/base/errors.h>
#include <waker/materials/factory.h>
#include <waker/materials/undrained_soil.h>

#include "cam_clay_sample.h"
#include "mapping_lattice.h"
#include "user_errors.h"
#include <gtest/gtest.h>

namespace materials_cam_clay_tangent
{
  using namespace Waker;
  using namespace CamClaySample;

  namespace
  {
    /// Largest error of the tangent over its largest entry, and how far it is
    /// from symmetric.
    double
    tangent_error(const Sample                &start,
                  const SymmetricTensor<2, 3> &strain,
                  double                      &asymmetry)
    {
      const auto after = [&](const SymmetricTensor<2, 3> &change,
                             SymmetricTensor<4, 3>       *D) {
        Sample sample = start;
        sample.law->update(strain + change, sample.stress, sample.variables, D);
        return sample.stress;
      };
      SymmetricTensor<4, 3> D;
      after({}, &D);
      const double delta = 1e-7;
      double       error = 0., size = 0.;
      asymmetry = 0.;
      for (unsigned int b = 0; b < 6; ++b)
        {
          SymmetricTensor<2, 3> e;
          e.access_raw_entry(b) = delta;
          const auto difference =
            (after(e, nullptr) - after(-1. * e, nullptr)) /
            ((b < 3 ? 2. : 4.) * delta);
          for (unsigned int a = 0; a < 6; ++a)
            {
              error = std::max(error,
                               std::abs(difference.access_raw_entry(a) -
                                        D.access_raw_entry(6 * a + b)));
              size  = std::max(size, std::abs(D.access_raw_entry(6 * a + b)));
              asymmetry = std::max(asymmetry,
                                   std::abs(D.access_raw_entry(6 * a + b) -
                                            D.access_raw_entry(6 * b + a)));
            }
        }
      asymmetry /= size;
      return error / size;
    }
  } // namespace


  TEST(ModifiedCamClay, tangent_is_the_derivative)
  {
    const auto      law = clay();
    Lattice::Random random(11);
    struct
    {
      double p, pc, stress, strain;
    } const cases[] = {{50., 200., 5., 1e-3},  // elastic
                       {0.3, 20., 0.05, 1e-5}, // below the least pressure
                       {90., 100., 20., 5e-3}, // wet
                       {30., 200., 40., 2e-2}, // dry
                       {100., 100., 5., 1e-1}, // a step far too long
                       {2., 1., 1., 1e-2}};    // p_c at its least
    for (const auto &c : cases)
      {
        double       most      = 0.;
        unsigned int n_yielded = 0;
        for (unsigned int i = 0; i < 60; ++i)
          {
            Sample start(law, c.p, c.pc);
            start.stress += deviator(random.stress<3>(c.stress));
            const auto strain = random.stress<3>(c.strain);
            double     asymmetry;
            EXPECT_LT(tangent_error(start, strain, asymmetry), 2e-5)
              << c.p << " " << c.pc << " " << i;
            most          = std::max(most, asymmetry);
            Sample sample = start;
            sample.strain(strain);
            n_yielded += sample.variables[2] > 0.;
          }
        if (c.pc == 100. || c.pc == 1.)
          {
            EXPECT_GT(n_yielded, 20u);
            EXPECT_GT(most, 1e-3); // else it would not see a transposed one
          }
      }
    // At the tip of the ellipse, in compression and in tension.
    for (const double strain : {-0.01, 0.05})
      {
        double asymmetry;
        EXPECT_LT(tangent_error(Sample(law, 100., 100.),
                                diagonal(strain, strain),
                                asymmetry),
                  1e-5);
      }
    EXPECT_FALSE(law.has_symmetric_tangent());
  }


  TEST(ModifiedCamClay, blocks_are_points)
  {
    const auto             law = clay();
    constexpr unsigned int N = Material::block_size, n = 13;
    Lattice::Random        random(2);
    Material::Block        block = {}, of_tangent = {};
    double                 variables[3][N] = {}, again[3][N] = {};
    block.variables      = variables;
    of_tangent.variables = again;
    std::vector<Sample>                samples;
    std::vector<SymmetricTensor<4, 3>> D(n);
    double                             lost[n], energy[N];
    for (unsigned int l = 0; l < n; ++l)
      {
        Sample sample(law, 80., 60. + 20. * l);
        sample.stress += random.stress<3>(20.);
        const auto strain = random.stress<3>(1e-2);
        for (unsigned int a = 0; a < 6; ++a)
          {
            block.strain_increment[a][l] = strain.access_raw_entry(a);
            block.stress[a][l]           = sample.stress.access_raw_entry(a);
          }
        for (unsigned int v = 0; v < 3; ++v)
          variables[v][l] = again[v][l] = sample.variables[v];
        std::copy_n(&block.stress[0][0], 6 * N, &of_tangent.stress[0][0]);
        std::copy_n(&block.strain_increment[0][0],
                    6 * N,
                    &of_tangent.strain_increment[0][0]);
        lost[l] = law.update(strain, sample.stress, sample.variables, &D[l]);
        samples.push_back(sample);
      }
    law.update_block(n, block);
    constexpr unsigned int components[] = {0, 1, 3};
    double                 tangent[9][N];
    law.tangent_block(n, of_tangent, 3, components, tangent);
    law.elastic_energy(block, energy);
    for (unsigned int l = 0; l < n; ++l)
      {
        for (unsigned int a = 0; a < 6; ++a)
          EXPECT_EQ(block.stress[a][l], samples[l].stress.access_raw_entry(a));
        for (unsigned int v = 0; v < 3; ++v)
          EXPECT_EQ(variables[v][l], samples[l].variables[v]);
        EXPECT_EQ(block.dissipation[l], lost[l]);
        EXPECT_GT(energy[l], 0.);
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 3; ++b)
            EXPECT_EQ(tangent[3 * a + b][l],
                      D[l].access_raw_entry(6 * components[a] + components[b]));
      }
  }


  TEST(ModifiedCamClay, turned_axes_give_the_turned_stress)
  {
    const auto      law = clay();
    Lattice::Random random(8);
    Tensor<2, 3>    turn; // about (1, 1, 1), and about z
    turn[0][1] = turn[1][2] = turn[2][0] = 1.;
    Tensor<2, 3> z;
    z[0][0] = z[1][1] = std::cos(0.7);
    z[0][1]           = -std::sin(0.7);
    z[1][0]           = std::sin(0.7);
    z[2][2]           = 1.;
    turn              = z * turn;
    const auto turned = [&](const SymmetricTensor<2, 3> &t) {
      return symmetrize(turn * Tensor<2, 3>(t) * transpose(turn));
    };
    for (unsigned int i = 0; i < 50; ++i)
      {
        Sample one(law, 90., 100.), other(law, 90., 100.);
        one.stress += random.stress<3>(20.);
        other.stress      = turned(one.stress);
        const auto strain = random.stress<3>(1e-2);
        one.strain(strain);
        other.strain(turned(strain));
        EXPECT_LT((turned(one.stress) - other.stress).norm(), 1e-9);
        EXPECT_NEAR(one.pc(), other.pc(), 1e-9);
      }
  }


  // Undrained by the law's wrapper: the water carries what p' loses.
  TEST(ModifiedCamClay, undrained_soil_keeps_its_volume)
  {
    const UndrainedSoil law(std::make_unique<ModifiedCamClay>(clay()), 1e6);
    Sample              sample(law, 100., 100.);
    for (unsigned int i = 0; i < 400; ++i)
      sample.compress(1e-3, [](const Sample &s) { return s.p() - 100.; });
    const double p = 100. * std::pow(0.5, Lambda);
    EXPECT_NEAR(sample.q(), ratio() * p, 2e-3 * p);
    EXPECT_NEAR(sample.variables[3], 100. - p, 2e-3 * p);
    EXPECT_NEAR(sample.volume(), (100. - p) / 1e6, 1e-6);
  }


  TEST(ModifiedCamClay, soil_has_been_consolidated_by_what_it_bears)
  {
    const auto   law   = clay();
    const double M     = ratio();
    const auto   after = [&](const double p, const double q, const double pc) {
      Sample sample(law, p, pc);
      sample.stress += diagonal(-2. / 3. * q, q / 3.);
      law.consolidate(sample.stress, sample.variables);
      return sample.variables[1];
    };
    EXPECT_EQ(after(50., 10., 90.), 90.); // it has borne more
    EXPECT_NEAR(after(50., 30., 20.), 50. + 900. / (50. * M * M), 1e-10);
    EXPECT_NEAR(after(50., M * 50., 20.), 100., 1e-10);
    EXPECT_EQ(after(50., 80., 20.), 100.); // no pressure explains that
    EXPECT_EQ(after(0., 0., 0.2), least);
    EXPECT_EQ(after(-5., 0., 30.), 30.);
    // Then it is in balance as it is.
    Sample sample(law, 50., 20.);
    sample.stress += diagonal(-20., 10.);
    law.consolidate(sample.stress, sample.variables);
    const auto before = sample.stress;
    sample.strain({});
    EXPECT_LT((sample.stress - before).norm(), 1e-10);
    // Of undrained soil that is the effective stress.
    UndrainedSoil undrained(std::make_unique<ModifiedCamClay>(clay()), 1e5);
    double        v[4] = {phi, 20., 0., 10.};
    undrained.consolidate(diagonal(-60., -60.), v);
    EXPECT_NEAR(v[1], 50., 1e-12);
  }


  TEST(ModifiedCamClay, what_a_point_may_start_with)
  {
    const auto law = clay();
    EXPECT_FALSE(law.initial_problem({25., 100., 0.}));
    EXPECT_FALSE(law.initial_problem({25., 0., 0.}));
    EXPECT_EQ(law.initial_problem({0., 100., 0.})->first, 0u);
    EXPECT_EQ(law.initial_problem({90., 100., 0.})->first, 0u);
    EXPECT_EQ(law.initial_problem({25., -1., 0.})->first, 1u);
    EXPECT_EQ(law.initial_problem({25., std::nan(""), 0.})->first, 1u);
    EXPECT_EQ(law.initial_problem({25., 1e308, 0.})->first, 1u);
    double v[3] = {25., 100., 0.1};
    law.divide_strengths(1.5, v);
    const double degree = std::acos(-1.) / 180.;
    EXPECT_NEAR(std::tan(v[0] * degree), std::tan(25. * degree) / 1.5, 1e-14);
    EXPECT_EQ(v[1], 100.);
  }


  TEST(ModifiedCamClay, wrong_parameters_are_refused)
  {
    MaterialParameters good;
    good.name                        = "clay";
    good.model                       = MaterialModel::modified_cam_clay;
    good.elastic.youngs_modulus      = E;
    good.elastic.poissons_ratio      = nu;
    good.mohr_coulomb.friction_angle = "25";
    ASSERT_NO_THROW(good.check(2, 0.5));
    EXPECT_TRUE(good.is_drained() && good.has_friction());
    EXPECT_FALSE(good.has_constant_stiffness());
    const double nan = std::nan("");

    // Whatever the model.
    for (const MaterialModel model :
         {MaterialModel::modified_cam_clay, MaterialModel::mohr_coulomb})
      {
        const auto refused = [&](double ModifiedCamClayParameters::*entry,
                                 const std::string                 &name,
                                 const std::vector<double>         &values) {
          for (const double value : values)
            {
              MaterialParameters p = good;
              p.model              = model;
              p.cam_clay.*entry    = value;
              EXPECT_USER_ERROR(p.check(2, 0.5),
                                "Materials/clay/" + name,
                                "is ");
            }
        };
        using P = ModifiedCamClayParameters;
        refused(&P::lambda, "Lambda", {1e308, nan, -0.1, 11.});
        refused(&P::kappa, "Kappa", {0., -0.1, 0.2, 0.3, 1e308, nan, 1e-300});
        refused(&P::void_ratio, "Void ratio", {0., -1., 1e308, nan, 101.});
        refused(&P::ocr, "OCR", {0., 0.99, -1., 1e308, nan});
        refused(&P::least_pressure, "Least pressure", {0., -1., 1e308, nan});
        for (const std::string text : {"-1", "1e308", "2e6"})
          {
            MaterialParameters p        = good;
            p.model                     = model;
            p.cam_clay.preconsolidation = text;
            EXPECT_USER_ERROR(p.check(2, 0.5),
                              "Materials/clay/Preconsolidation pressure",
                              "is ");
          }
        MaterialParameters p        = good;
        p.model                     = model;
        p.cam_clay.preconsolidation = "50 + cohesion";
        EXPECT_USER_ERROR(p.check(2, 0.5),
                          "Materials/clay/Preconsolidation pressure",
                          "cannot be read");
      }
    for (const std::string text : {"0", "-5", "90", "1e308", "0.01"})
      {
        MaterialParameters p          = good;
        p.mohr_coulomb.friction_angle = text;
        EXPECT_USER_ERROR(p.check(2, 0.5),
                          "Materials/clay/Friction angle",
                          "degrees");
      }
    for (const double pop : {-1., 1e308, nan})
      {
        MaterialParameters p     = good;
        p.von_mises.strength.pop = pop;
        EXPECT_USER_ERROR(p.check(2, 0.5), "Materials/clay/POP", "is ");
      }
    MaterialParameters p        = good;
    p.cam_clay.kappa            = 0.199;
    p.cam_clay.preconsolidation = "100";
    EXPECT_USER_ERROR(p.check(2, 0.5),
                      "Materials/clay/Preconsolidation pressure",
                      "snap-back");
  }
} // namespace materials_cam_clay_tangent
