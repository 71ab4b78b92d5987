// SPDX-License-Identifier: LGPL-2.1-or-later
// Mohr-Coulomb against closed forms, and its return against what defines it.
#include <waker/materials/mohr_coulomb.h>
#include <waker/materials/principal_stress.h>

#include "mapping_lattice.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace materials_mohr_coulomb
{
  using namespace Waker;

  namespace
  {
    const double     degree   = std::acos(-1.) / 180.;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double E = 10000., nu = 0.3;


    MohrCoulomb
    sand(const double c,
         const double phi,
         const double psi,
         const double tension)
    {
      return MohrCoulomb(1.8, E, nu, {c, phi, psi}, tension);
    }


    /// A soil sample whose strains follow from the stresses that are held.
    struct Sample
    {
      Sample(const MohrCoulomb           &soil,
             const SymmetricTensor<2, 3> &stress,
             const double                 c,
             const double                 phi,
             const double                 psi)
        : soil(&soil)
        , stress(stress)
        , variables{c, phi, psi, 0.}
      {}

      /// A strain, whose normal components that `free` names are alike, and
      /// such that the normal stress there stays: Newton with the law's own
      /// tangent.
      void
      strain_by(SymmetricTensor<2, 3> increment, const std::vector<int> &free)
      {
        const int    first = free[0];
        const double held  = stress[first][first];
        for (unsigned int n = 0; n < 50; ++n)
          {
            SymmetricTensor<2, 3> after     = stress;
            double                values[4] = {variables[0],
                                               variables[1],
                                               variables[2],
                                               variables[3]};
            SymmetricTensor<4, 3> D;
            soil->update(increment, after, values, &D);
            const double error = held - after[first][first];
            if (std::abs(error) < 1e-9)
              {
                stress = after;
                strain += increment;
                std::copy_n(values, 4, variables);
                return;
              }
            double stiffness = 0.;
            for (const int d : free)
              stiffness += D[first][first][d][d];
            for (const int d : free)
              increment[d][d] += error / stiffness;
          }
        FAIL() << "the strains of the sample were not found";
      }

      const MohrCoulomb    *soil;
      SymmetricTensor<2, 3> stress, strain;
      double                variables[4];
    };


    SymmetricTensor<2, 3>
    diagonal(const double xx, const double yy, const double zz)
    {
      SymmetricTensor<2, 3> s;
      s[0][0] = xx;
      s[1][1] = yy;
      s[2][2] = zz;
      return s;
    }


    /// The largest of what must not be above 0 (kPa).
    double
    excess(const SymmetricTensor<2, 3> &stress,
           const double                 c,
           const double                 phi,
           const double                 tension)
    {
      // Descending; eigenvalues() has half the digits where two are equal.
      const auto pairs =
        eigenvectors(stress,
                     SymmetricTensorEigenvectorMethod::ql_implicit_shifts);
      const double s[3] = {pairs[0].first, pairs[1].first, pairs[2].first};
      const double f    = s[0] - s[2] + (s[0] + s[2]) * std::sin(phi * degree) -
                       2. * c * std::cos(phi * degree);
      return std::max(f, s[0] - tension);
    }
  } // namespace


  TEST(Materials, mohr_coulomb_in_triaxial_compression_and_extension)
  {
    // c = 5 kPa, phi = 30 degrees, a cell pressure of 100 kPa: 317.3 kPa
    // axially at failure. In extension the axial stress is the small one.
    const double s = std::sin(30. * degree), K = (1. + s) / (1. - s);
    for (const double psi : {0., 10., 30.})
      {
        const MohrCoulomb soil = sand(5., 30., psi, 0.);
        Sample compressed(soil, diagonal(-100., -100., -100.), 5, 30, psi);
        Sample extended(soil, diagonal(-100., -100., -100.), 5, 30, psi);
        double before = 0.;
        for (unsigned int n = 0; n < 100; ++n)
          {
            before = trace(compressed.strain);
            compressed.strain_by(diagonal(0., -0.001, 0.), {0, 2});
            extended.strain_by(diagonal(0., 0.001, 0.), {0, 2});
          }
        const double expected = K * 100. + 2. * 5. * std::sqrt(K);
        EXPECT_NEAR(expected, 317.3, 0.05);
        EXPECT_NEAR(compressed.stress[1][1], -expected, 1e-7);
        EXPECT_NEAR(compressed.stress[0][0], -100., 1e-8);
        EXPECT_NEAR(extended.stress[1][1],
                    -(100. - 2. * 5. * std::sqrt(K)) / K,
                    1e-7);
        // Dilation on the edge: d eps_v / d eps_a = -2 sin psi / (1 - sin psi).
        const double sin_psi = std::sin(psi * degree);
        EXPECT_NEAR((trace(compressed.strain) - before) / -0.001,
                    -2. * sin_psi / (1. - sin_psi),
                    1e-8);
        EXPECT_GT(compressed.variables[3], 0.05);
      }
  }


  TEST(Materials, mohr_coulomb_in_plane_strain_is_rankine)
  {
    // Active and passive earth pressure beside 100 kPa of vertical stress.
    for (const double phi : {0., 20., 35.})
      {
        const double      s = std::sin(phi * degree), K = (1. + s) / (1. - s);
        const double      c    = 8.;
        const MohrCoulomb soil = sand(c, phi, 0.5 * phi, infinity);
        Sample passive(soil, diagonal(-60., -100., -60.), c, phi, 0.5 * phi);
        Sample active = passive;
        for (unsigned int n = 0; n < 100; ++n)
          {
            passive.strain_by(diagonal(-0.002, 0., 0.), {1});
            active.strain_by(diagonal(0.002, 0., 0.), {1});
          }
        EXPECT_NEAR(passive.stress[0][0],
                    -(100. * K + 2. * c * std::sqrt(K)),
                    1e-6);
        EXPECT_NEAR(active.stress[0][0],
                    -(100. / K - 2. * c / std::sqrt(K)),
                    1e-6);
        EXPECT_EQ(passive.strain[2][2], 0.);
      }
  }


  TEST(Materials, mohr_coulomb_in_simple_shear)
  {
    // Without friction the shear stress ends at c (Tresca, unlike von Mises,
    // whatever lies between). With psi = phi and no change of volume it does
    // not end; with psi = 0 the normal stresses turn to Davis's reduced
    // strength, tau = sigma_n sin(phi).
    const MohrCoulomb     clay = sand(8., 0., 0., infinity);
    SymmetricTensor<2, 3> step, stress = diagonal(-20., -20., -23.);
    step[0][1]          = 0.0005;
    double variables[4] = {8., 0., 0., 0.};
    for (unsigned int n = 0; n < 100; ++n)
      clay.update(step, stress, variables, nullptr);
    EXPECT_NEAR(stress[0][1], 8., 1e-10);
    // sqrt(2/3 e:e) of a shear of 0.1, less what is elastic: gamma / sqrt(3).
    EXPECT_NEAR(variables[3],
                (0.1 - 8. / clay.shear_modulus()) / std::sqrt(3.),
                1e-12);
    EXPECT_NEAR(stress[2][2], -23., 1e-10);

    const MohrCoulomb flowing = sand(0., 30., 0., 0.);
    Sample            sample(flowing, diagonal(-50., -100., -50.), 0., 30., 0.);
    for (unsigned int n = 0; n < 4000; ++n)
      sample.strain_by(step, {1});
    EXPECT_NEAR(sample.stress[0][1], 100. * std::sin(30. * degree), 1e-3);
    EXPECT_NEAR(sample.stress[1][1], -100., 1e-8);
    // All change of volume is elastic.
    EXPECT_NEAR(trace(sample.strain),
                (trace(sample.stress) + 200.) / 3. / flowing.bulk_modulus(),
                1e-12);
  }


  TEST(Materials, mohr_coulomb_bears_no_more_tension_than_it_says)
  {
    const double apex = 5. / std::tan(30. * degree);
    for (const auto &[given, borne] : std::vector<std::pair<double, double>>{
           {0., 0.}, {3., 3.}, {20., apex}, {infinity, apex}})
      {
        const MohrCoulomb soil = sand(5., 30., 0., given);
        for (const double way : {1., 0.2, 0.})
          {
            SymmetricTensor<2, 3> stress;
            double                variables[4] = {5., 30., 0., 0.};
            soil.update(diagonal(0.01, way * 0.01, way * 0.01),
                        stress,
                        variables,
                        nullptr);
            EXPECT_LE(eigenvalues(stress)[0], borne + 1e-9) << given;
            // All three: the corner, alike in all directions.
            const double off =
              (stress - borne * unit_symmetric_tensor<3>()).norm();
            EXPECT_LT(way == 1. ? off : 0., 1e-9) << given;
            // Pulled in one direction it bears all that it can.
            if (given <= apex)
              {
                EXPECT_NEAR(eigenvalues(stress)[0], borne, 1e-7) << given;
              }
          }
      }
  }


  TEST(Materials, mohr_coulomb_returns_where_the_planes_are)
  {
    // Any trial stress: within the surface; in the elastic stress' directions;
    // work of the plastic strain is dissipated. With psi = phi it is the point
    // nearest to the trial stress, in elastic energy: from no other admissible
    // stress t is (trial - s) : C : (t - s) > 0.
    Lattice::Random random(211);
    unsigned int    n_plastic = 0, n_compared = 0;
    for (unsigned int n = 0; n < 4000; ++n)
      {
        const double c   = n % 5 == 0 ? 0. : random(0.5, 20.);
        const double phi = n % 7 == 0 ? (c > 0. ? 0. : 25.) : random(5., 45.);
        const double psi = n % 3 == 0 ? phi : n % 3 == 1 ? 0. : 0.3 * phi;
        const double tension   = n % 4 == 0   ? 0.
                                 : n % 4 == 1 ? random(0., 10.)
                                              : infinity;
        const MohrCoulomb soil = sand(c, phi, psi, tension);
        // Stress and strain with all components, or those of plane strain.
        auto start = random.stress<3>(30.), strain = random.stress<3>(0.02);
        if (n % 2 == 0)
          for (auto *const tensor : {&start, &strain})
            (*tensor)[0][2] = (*tensor)[1][2] = 0.;
        start += random(-80., 20.) * unit_symmetric_tensor<3>();

        const LinearElastic   elastic(1.8, E, nu);
        SymmetricTensor<2, 3> trial = start, stress = start;
        elastic.update(strain, trial, nullptr, nullptr);
        double       variables[4] = {c, phi, psi, 0.};
        const double dissipation =
          soil.update(strain, stress, variables, nullptr);
        const double size = trial.norm() + c;
        if (variables[3] == 0. && (stress - trial).norm() == 0.)
          {
            EXPECT_LE(excess(trial, c, phi, tension), 1e-9 * size) << n;
            continue;
          }
        ++n_plastic;
        EXPECT_LE(excess(stress, c, phi, tension), 1e-9 * size) << n;
        EXPECT_GE(dissipation, -1e-12 * size) << n;
        // Coaxial: the product of the two is symmetric.
        const Tensor<2, 3> product = Tensor<2, 3>(trial) * Tensor<2, 3>(stress);
        EXPECT_LT((product - transpose(product)).norm(), 1e-9 * size * size)
          << n;
        SymmetricTensor<2, 3> excess_strain; // C : (trial - stress)
        const auto            lost = trial - stress;
        excess_strain              = (1. + nu) / E * lost -
                        nu / E * trace(lost) * unit_symmetric_tensor<3>();
        EXPECT_NEAR(stress * excess_strain, dissipation, 1e-9 * size) << n;
        if (psi != phi)
          continue;
        for (unsigned int k = 0; k < 30; ++k)
          {
            // Towards the other side of the trial stress, and anywhere.
            auto other = k % 2 == 0 ? stress + random.stress<3>(0.1 * size)
                                    : random.stress<3>(size) -
                                        0.5 * size * unit_symmetric_tensor<3>();
            if (excess(other, c, phi, tension) > 0.)
              continue;
            ++n_compared;
            EXPECT_LE(excess_strain * (other - stress),
                      1e-9 * size * excess_strain.norm())
              << n;
          }
      }
    EXPECT_GT(n_plastic, 2000u);
    EXPECT_GT(n_compared, 2000u);
  }


  TEST(Materials, mohr_coulomb_softens_to_what_is_left)
  {
    // Triaxial compression at 50 kPa: from the peak to the residual strength,
    // linearly in the plastic strain.
    const auto axial = [](const double c, const double phi) {
      const double s = std::sin(phi * degree), K = (1. + s) / (1. - s);
      return -(K * 50. + 2. * c * std::sqrt(K));
    };
    const MohrCoulomb soil(1.8, E, nu, {10., 35., 8.}, 0., {2., 28., 0.}, 0.2);
    double            variables[7]  = {10., 35., 8., 2., 28., 0., 0.};
    SymmetricTensor<2, 3> stress    = diagonal(-50., -50., -50.);
    unsigned int          n_between = 0;
    for (unsigned int n = 0; n < 400; ++n)
      {
        // Lateral strains that hold the lateral stresses.
        SymmetricTensor<2, 3> increment = diagonal(0., -0.001, 0.), after;
        double                values[7];
        for (unsigned int i = 0; i < 60; ++i)
          {
            SymmetricTensor<4, 3> D;
            after = stress;
            std::copy_n(variables, 7, values);
            soil.update(increment, after, values, &D);
            const double error = -50. - after[0][0];
            if (std::abs(error) < 1e-10)
              break;
            const double lateral = error / (D[0][0][0][0] + D[0][0][2][2]);
            increment[0][0] += lateral;
            increment[2][2] += lateral;
          }
        ASSERT_NEAR(after[0][0], -50., 1e-9) << n;
        stress = after;
        std::copy_n(values, 7, variables);
        if (variables[6] == 0.)
          continue;
        const double share = std::min(variables[6] / 0.2, 1.);
        EXPECT_NEAR(stress[1][1],
                    axial(10. - 8. * share, 35. - 7. * share),
                    1e-7)
          << n;
        n_between += share < 1.;
      }
    EXPECT_GT(n_between, 100u);
    EXPECT_NEAR(stress[1][1], axial(2., 28.), 1e-8);
    // The strengths at the start are kept.
    EXPECT_EQ(variables[0], 10.);
    EXPECT_EQ(variables[4], 28.);
  }


  TEST(Materials, a_strength_reduction_divides_the_tangent_of_the_angle)
  {
    const MohrCoulomb soil         = sand(6., 30., 25., 0.);
    double            variables[4] = {6., 30., 25., 0.1};
    soil.divide_strengths(1.5, variables);
    EXPECT_NEAR(variables[0], 4., 1e-14);
    EXPECT_NEAR(std::tan(variables[1] * degree),
                std::tan(30. * degree) / 1.5,
                1e-14);
    EXPECT_EQ(variables[2], variables[1]); // 21 degrees: less than psi
    EXPECT_EQ(variables[3], 0.1);
  }


  TEST(Materials, what_mohr_coulomb_cannot_start_with)
  {
    const MohrCoulomb firm    = sand(5., 30., 0., 0.);
    const auto        problem = [&](const std::vector<double> &v) {
      const auto found = firm.initial_problem(v);
      return found ? int(found->first) : -1;
    };
    EXPECT_EQ(problem({5., 30., 0., 0.}), -1);
    EXPECT_EQ(problem({0., 30., 30., 0.}), -1);
    EXPECT_EQ(problem({5., 0., 0., 0.}), -1);
    EXPECT_EQ(problem({-1., 30., 0., 0.}), 0);
    EXPECT_EQ(problem({0., 0., 0., 0.}), 0);
    EXPECT_EQ(problem({5., 90., 0., 0.}), 1);
    EXPECT_EQ(problem({5., -1., 0., 0.}), 1);
    EXPECT_EQ(problem({5., 30., 31., 0.}), 2);
    EXPECT_EQ(problem({5., std::nan(""), 0., 0.}), 1);
    const MohrCoulomb soft(1.8, E, nu, {5., 30., 5.}, 0., {1., 20., 0.}, 0.1);
    EXPECT_FALSE(soft.initial_problem({5., 30., 5., 1., 20., 0., 0.}));
    EXPECT_EQ(soft.initial_problem({5., 30., 5., 6., 20., 0., 0.})->first, 3u);
    EXPECT_EQ(soft.initial_problem({5., 30., 5., 1., 31., 0., 0.})->first, 4u);
    EXPECT_EQ(soft.initial_problem({5., 30., 5., 1., 20., 21., 0.})->first, 5u);
  }
} // namespace materials_mohr_coulomb
