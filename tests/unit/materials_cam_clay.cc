// SPDX-License-Identifier: LGPL-2.1-or-later
// Modified Cam clay against the closed forms of its tests in the laboratory.
#include "cam_clay_sample.h"
#include "mapping_lattice.h"
#include <gtest/gtest.h>

namespace materials_cam_clay
{
  using namespace Waker;
  using namespace CamClaySample;


  // Whatever the steps: swelling line, virgin line, and back.
  TEST(ModifiedCamClay, isotropic_compression_and_swelling_are_straight_lines)
  {
    const auto law = clay();
    for (const unsigned int n : {1u, 7u})
      {
        Sample     sample(law, 50., 100.);
        const auto squeeze = [&](const double volume) {
          for (unsigned int i = 0; i < n; ++i)
            sample.strain(diagonal(-volume / n / 3., -volume / n / 3.));
        };
        squeeze(swelling * std::log(80. / 50.));
        EXPECT_NEAR(sample.p(), 80., 1e-11);
        EXPECT_EQ(sample.pc(), 100.);
        squeeze(swelling * std::log(100. / 80.) +
                compression * std::log(400. / 100.)); // over the corner
        EXPECT_NEAR(sample.p(), 400., 1e-9);
        EXPECT_NEAR(sample.pc(), 400., 1e-9);
        squeeze(-swelling * std::log(400. / 10.));
        EXPECT_NEAR(sample.p(), 10., 1e-10);
        EXPECT_NEAR(sample.pc(), 400., 1e-9);
        // v over v_0 of the three lines.
        EXPECT_NEAR(std::exp(trace(sample.strains)),
                    std::pow(10. / 50., -swelling) *
                      std::pow(4., -compression + swelling),
                    1e-12);
        EXPECT_LT(sample.variables[2], 1e-15); // no shear
      }
  }


  // p'/p'_0 = (M^2 / (M^2 + eta^2))^Lambda, and s_u = M p'_0 / 2 (R/2)^Lambda
  // at critical state (Schofield & Wroth 1968; Wood 1990, section 7.2): exactly
  // so, as no step has an error in its volume.
  TEST(ModifiedCamClay, undrained_compression_follows_its_path)
  {
    const auto   law = clay();
    const double M   = ratio();
    for (const double R : {1., 1.5, 2., 4., 10.})
      for (const double axial : {1e-4, 2e-3})
        {
          Sample       sample(law, 100., R * 100.);
          const double yield = M * 100. * std::sqrt(R - 1.); // of the ellipse
          double       eta_y = yield / 100.;
          for (double e = 0.; e < 0.6; e += axial)
            {
              const double dissipated =
                sample.strain(diagonal(-axial, 0.5 * axial));
              EXPECT_GE(dissipated, 0.);
              if (sample.variables[2] == 0.)
                {
                  EXPECT_NEAR(sample.p(), 100., 1e-9);
                  continue;
                }
              const double eta = sample.q() / sample.p();
              EXPECT_NEAR(
                sample.p() / 100.,
                std::pow((M * M + eta_y * eta_y) / (M * M + eta * eta), Lambda),
                1e-8);
              EXPECT_NEAR(sample.excess(), 0., 1e-11);
            }
          EXPECT_NEAR(sample.q() / 2.,
                      0.5 * M * 100. * std::pow(R / 2., Lambda),
                      1e-3 * sample.q())
            << R;
          EXPECT_NEAR(sample.volume(), 0., 1e-12);
        }
  }


  // At constant p' (Wood 1990): eps_v = theta ln(1 + eta^2/M^2), and
  // eps_q = theta/M (ln((M + eta)/(M - eta)) - 2 atan(eta/M)) + q/(3 G).
  TEST(ModifiedCamClay, compression_at_constant_pressure_ends_at_critical_state)
  {
    const auto   law = clay();
    const double M   = ratio();
    const auto   run = [&](const double axial, double &error) {
      Sample sample(law, 100., 100.);
      for (unsigned int i = 0; i < std::lround(0.12 / axial); ++i)
        {
          sample.compress(axial, [](const Sample &s) { return s.p() - 100.; });
          const double eta = sample.q() / 100.;
          EXPECT_NEAR(sample.volume(),
                      theta * std::log(1. + eta * eta / (M * M)),
                      1e-9);
        }
      const double eta = sample.q() / 100.;
      EXPECT_GT(eta, 0.8 * M);
      const double exact =
        theta / M *
          (std::log((M + eta) / (M - eta)) - 2. * std::atan(eta / M)) +
        sample.q() / (3. * law.shear_modulus());
      error = 2. / 3. * (sample.strains[0][0] - sample.strains[1][1]) - exact;
      EXPECT_NEAR(sample.variables[2],
                  exact - sample.q() / (3. * law.shear_modulus()) + error,
                  1e-9);
    };
    // The implicit return is of first order in the shear strain.
    double coarse, fine, finest;
    run(1e-3, coarse);
    run(5e-4, fine);
    run(2.5e-4, finest);
    EXPECT_LT(std::abs(finest), 5e-4);
    EXPECT_NEAR(coarse / fine, 2., 0.1);
    EXPECT_NEAR(fine / finest, 2., 0.1);

    Sample sample(law, 100., 100.);
    for (unsigned int i = 0; i < 300; ++i)
      sample.compress(5e-3, [](const Sample &s) { return s.p() - 100.; });
    EXPECT_NEAR(sample.q(), M * 100., 1e-3);
    EXPECT_NEAR(sample.volume(), theta * std::log(2.), 1e-6);
    EXPECT_NEAR(sample.pc(), 200., 1e-3);
  }


  // Drained: q = 3 (p' - p'_0) meets q = M p', from the wet side and the dry.
  TEST(ModifiedCamClay, drained_compression_ends_at_critical_state)
  {
    const auto   law = clay();
    const double M   = ratio();
    for (const double R : {1., 2., 8.})
      {
        Sample sample(law, 100., 100. * R);
        double most = 0.;
        for (unsigned int i = 0; i < 1500; ++i)
          {
            sample.compress(1e-3, [](const Sample &s) {
              return -s.stress[0][0] - 100.;
            });
            most = std::max(most, sample.q());
            EXPECT_NEAR(sample.volume(),
                        swelling * std::log(sample.p() / 100.) +
                          theta * std::log(sample.pc() / (100. * R)),
                        1e-9);
          }
        const double p = 300. / (3. - M);
        EXPECT_NEAR(sample.p(), p, 1e-2 * p) << R;
        EXPECT_NEAR(sample.q(), M * p, 1e-2 * M * p) << R;
        EXPECT_NEAR(sample.pc(), 2. * p, 2e-2 * p) << R;
        // The peak of the dry side is where the path meets the first ellipse.
        const double a    = 9. / (M * M) + 1.;
        const double b    = -1800. / (M * M) - 100. * R;
        const double c    = 90000. / (M * M);
        const double peak = (-b + std::sqrt(b * b - 4. * a * c)) / (2. * a);
        if (R > 4.)
          {
            EXPECT_NEAR(most, 3. * (peak - 100.), 0.01 * most);
            EXPECT_LT(sample.volume(), 0.); // it has dilated
          }
        else
          {
            EXPECT_GT(sample.volume(), 0.);
          }
      }
  }


  // One-dimensional compression of soil that is stiff in shear:
  // eta^2 + 3 Lambda eta - M^2 = 0 of 2/3 = 2 eta / (M^2 - eta^2) Lambda; and
  // the slope lambda*.
  TEST(ModifiedCamClay, k0_of_virgin_compression)
  {
    const auto   law = clay(1e7);
    const double M   = ratio();
    const double eta =
      0.5 * (std::sqrt(9. * Lambda * Lambda + 4. * M * M) - 3. * Lambda);
    Sample sample(law, 10., 10.);
    for (unsigned int i = 0; i < 6000; ++i)
      sample.strain(diagonal(-1e-4, 0.));
    EXPECT_NEAR(sample.q() / sample.p(), eta, 2e-3);
    const double before = sample.p();
    for (unsigned int i = 0; i < 1000; ++i)
      sample.strain(diagonal(-1e-4, 0.));
    EXPECT_NEAR(std::log(sample.p() / before), 0.1 / compression, 1e-3);
    const double k0 = sample.stress[0][0] / sample.stress[1][1];
    EXPECT_NEAR(k0, (3. - eta) / (3. + 2. * eta), 1e-3);
    // It is more than Jaky's, 0.577, as is known of the law.
    EXPECT_GT(k0, 1. - std::sin(phi * std::acos(-1.) / 180.));
  }


  // In plane strain without change of volume s_u = q / sqrt(3), and the angle
  // is the one that is meant.
  TEST(ModifiedCamClay, critical_state_of_plane_strain)
  {
    for (const FrictionHolds holds :
         {FrictionHolds::triaxial_compression, FrictionHolds::plane_strain})
      {
        const ModifiedCamClay law(1.6,
                                  {E, nu, compression, swelling, least, holds},
                                  phi,
                                  100.);
        Sample                sample(law, 100., 100.);
        for (unsigned int i = 0; i < 4000; ++i)
          {
            SymmetricTensor<2, 3> step;
            step[0][0] = 2e-4;
            step[1][1] = -2e-4;
            sample.strain(step);
          }
        const double M    = critical_state_ratio(phi, holds);
        const double half = 0.5 * (sample.stress[0][0] - sample.stress[1][1]);
        const double mean = -0.5 * (sample.stress[0][0] + sample.stress[1][1]);
        EXPECT_NEAR(half,
                    M / std::sqrt(3.) * 100. * std::pow(0.5, Lambda),
                    1e-3 * half);
        const double angle = std::asin(half / mean) * 180. / std::acos(-1.);
        EXPECT_NEAR(angle,
                    holds == FrictionHolds::plane_strain ? phi : 34.6,
                    0.1);
        EXPECT_NEAR(-sample.stress[2][2], mean, 1e-2 * mean);
      }
  }


  // Work is what is stored and what is lost, to the order of the rule that
  // sums it; a closed loop without yield gives all back.
  TEST(ModifiedCamClay, elastic_energy_closes_the_account)
  {
    const auto law    = clay();
    const auto stored = [&](const SymmetricTensor<2, 3> &stress) {
      Material::Block block = {};
      for (unsigned int a = 0; a < 6; ++a)
        block.stress[a][0] = stress.access_raw_entry(a);
      double energy[Material::block_size];
      law.elastic_energy(block, energy);
      return energy[0];
    };
    const auto path = [](const unsigned int leg) {
      SymmetricTensor<2, 3> e = diagonal(-0.02, 0.006);
      e[0][1]                 = 0.01;
      if (leg == 1)
        e = diagonal(0.01, -0.01);
      if (leg == 2)
        e = diagonal(0.03, 0.02); // until it is loose: p' below the least
      return e;
    };
    const auto remainder =
      [&](const unsigned int n, const double pc, double &lost) {
        Sample sample(law, 40., pc);
        double work = 0.;
        lost        = 0.;
        for (unsigned int leg = 0; leg < 3; ++leg)
          for (unsigned int i = 0; i < n; ++i)
            {
              const auto before = sample.stress;
              const auto step   = path(leg) / double(n);
              lost += sample.strain(step);
              work += 0.5 * ((before + sample.stress) * step);
            }
        return work - lost -
               (stored(sample.stress) - stored(diagonal(-40., -40.)));
      };
    double       lost;
    const double coarse = remainder(400, 60., lost);
    const double fine   = remainder(1600, 60., lost);
    EXPECT_GT(lost, 0.5);
    EXPECT_LT(std::abs(fine), 2e-3 * lost);
    EXPECT_LT(std::abs(fine), 0.3 * std::abs(coarse));
    const double elastic = remainder(400, 1e5, lost);
    EXPECT_EQ(lost, 0.);
    EXPECT_NEAR(remainder(1600, 1e5, lost) / elastic, 1. / 16., 0.02);
    // Control: that of constant moduli does not close.
    const double K = law.bulk_modulus();
    EXPECT_GT(std::abs(40. * 40. / (2. * K) - stored(diagonal(-40., -40.))),
              0.1);
  }


  // Near the surface: the stiffness of the least pressure, no tension, and a
  // preconsolidation pressure that is not lost.
  TEST(ModifiedCamClay, loose_soil_bears_nothing_and_is_not_lost)
  {
    const auto law = clay();
    Sample     sample(law, 0.2, 5.);
    sample.strain(diagonal(-1e-5, -1e-5));
    EXPECT_NEAR(sample.p(), 0.2 + 3e-5 * least / swelling, 1e-12);
    Lattice::Random random(3);
    for (unsigned int i = 0; i < 200; ++i)
      sample.strain(random.stress<3>(0.01) + diagonal(0.02, 0.02));
    EXPECT_NEAR(sample.p(), 0., 0.1);
    EXPECT_EQ(sample.pc(), least);
    for (unsigned int i = 0; i < 100; ++i)
      sample.strain(diagonal(-0.002, -0.002));
    EXPECT_GT(sample.p(), 10.); // pressed together it is soil again
  }


  TEST(ModifiedCamClay, any_step_ends_on_the_yield_surface)
  {
    const auto      law = clay();
    Lattice::Random random(5);
    unsigned int    n_yielded = 0;
    for (unsigned int i = 0; i < 20000; ++i)
      {
        Sample sample(law,
                      100. * random(0., 1.),
                      std::pow(10., 3. * random(0., 1.)));
        sample.stress += random.stress<3>(30. * random(0., 1.));
        const double size = std::pow(10., -5. + 4.5 * random(0., 1.));
        const double lost = sample.strain(random.stress<3>(size));
        EXPECT_GE(lost, 0.);
        EXPECT_LT(sample.excess(), 1e-9) << i;
        n_yielded += sample.variables[2] > 0.;
      }
    EXPECT_GT(n_yielded, 5000u);
  }
} // namespace materials_cam_clay
