// SPDX-License-Identifier: LGPL-2.1-or-later
// Strength by the normal stress of the moment: tables tau(sigma').
#include <waker/base/errors.h>
#include <waker/materials/factory.h>
#include <waker/materials/principal_stress.h>
#include <waker/materials/shear_strength_table.h>

#include "mapping_lattice.h"
#include "user_errors.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace materials_shear_strength_table
{
  using namespace Waker;

  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    const std::vector<ShearStrengthTable::Entry> entries = {{0., 3.},
                                                            {10., 10.},
                                                            {40., 22.},
                                                            {80., 30.}};

    double
    envelope(const double sigma)
    {
      double least = infinity;
      for (const auto &line : lines_through(entries))
        least = std::min(least, line.cohesion + line.tan_phi * sigma);
      return least;
    }


    ShearStrengthTable
    law(const double psi = 0., const double tension = infinity)
    {
      return {1.8, 20000., 0.3, lines_through(entries), psi, tension};
    }


    /// How far Mohr's circle of a stress is beyond the envelope (kPa); the
    /// circle by its angles.
    double
    beyond(const SymmetricTensor<2, 3> &stress)
    {
      const auto   s      = principal_stress(stress).value;
      const double centre = -(s[0] + s[2]) / 2., radius = (s[0] - s[2]) / 2.;
      double       worst = -infinity;
      for (unsigned int i = 0; i <= 20000; ++i)
        {
          const double angle = i * std::acos(-1.) / 20000.;
          worst              = std::max(worst,
                           radius * std::sin(angle) -
                             envelope(centre + radius * std::cos(angle)));
        }
      return worst;
    }
  } // namespace


  TEST(ShearStrengthTable, circles_touch_the_envelope)
  {
    Lattice::Random random(3);
    unsigned int    n_plastic = 0;
    for (const double psi : {0., 5., 25.})
      {
        const ShearStrengthTable clay = law(psi);
        for (unsigned int i = 0; i < 60; ++i)
          {
            SymmetricTensor<2, 3> stress =
              -(1. + i) * unit_symmetric_tensor<3>();
            double variables[2] = {1., 0.};
            double lost =
              clay.update(random.stress<3>(0.01), stress, variables, nullptr);
            if (lost == 0. && variables[1] == 0.)
              continue;
            ++n_plastic;
            EXPECT_GE(lost, -1e-10);
            EXPECT_GT(variables[1], 0.);
            // At the apex the circle is a point, beside the scan's reach.
            const auto s = principal_stress(stress).value;
            if (s[0] - s[2] > 1e-6)
              {
                EXPECT_NEAR(beyond(stress), 0., 1e-5);
              }
          }
      }
    EXPECT_GT(n_plastic, 100u);
  }


  TEST(ShearStrengthTable, one_line_is_mohr_coulomb)
  {
    const double             phi = 30., degree = std::acos(-1.) / 180.;
    const ShearStrengthTable one(
      1.8, 20000., 0.3, {{5., std::tan(phi * degree)}}, 10., 2.);
    const MohrCoulomb own(1.8, 20000., 0.3, {5., phi, 10.}, 2.);
    Lattice::Random   random(11);
    unsigned int      n_plastic = 0;
    for (unsigned int i = 0; i < 300; ++i)
      {
        const auto strain       = random.stress<3>(i % 2 == 0 ? 0.003 : 0.03);
        SymmetricTensor<2, 3> a = -20. * unit_symmetric_tensor<3>(), b = a;
        SymmetricTensor<4, 3> C, D;
        double       of_one[2] = {1., 0.}, of_own[4] = {5., phi, 10., 0.};
        const double lost = one.update(strain, a, of_one, &C);
        EXPECT_NEAR(own.update(strain, b, of_own, &D), lost, 1e-8);
        EXPECT_NEAR((a - b).norm(), 0., 1e-8);
        EXPECT_NEAR((C - D).norm(), 0., 1e-5);
        EXPECT_NEAR(of_one[1], of_own[3], 1e-12);
        n_plastic += lost > 0.;
      }
    EXPECT_GT(n_plastic, 100u);
  }


  TEST(ShearStrengthTable, triaxial_compression_by_hand)
  {
    // Between two circles that touch at the middle of each line: of the second,
    // tan phi = 0.4, c = 6 kPa.
    const ShearStrengthTable clay    = law();
    const double             sin_phi = 0.4 / std::sqrt(1.16);
    const double             K_p     = (1. + sin_phi) / (1. - sin_phi);
    const double             cell    = 15.;
    const double             axial   = cell * K_p + 2. * 6. * std::sqrt(K_p);
    SymmetricTensor<2, 3>    stress  = -cell * unit_symmetric_tensor<3>();
    double                   variables[2] = {1., 0.};
    for (unsigned int i = 0; i < 100; ++i)
      {
        // The cell pressure stays: without dilatancy the volume does, too,
        // once it yields.
        SymmetricTensor<2, 3> strain;
        strain[1][1] = -2e-4;
        strain[0][0] = strain[2][2] = variables[1] > 0. ? 1e-4 : 0.3 * 2e-4;
        clay.update(strain, stress, variables, nullptr);
      }
    const double now = -stress[1][1], side = -stress[0][0];
    EXPECT_NEAR(now, side * K_p + 12. * std::sqrt(K_p), 1e-8 * now);
    EXPECT_NEAR(now / axial, 1., 0.1);
    // It touches on that line: 10 to 40 kPa.
    const double centre = (now + side) / 2., radius = (now - side) / 2.;
    EXPECT_GT(centre - radius * sin_phi, 10.);
    EXPECT_LT(centre - radius * sin_phi, 40.);
  }


  TEST(ShearStrengthTable, tangent_is_the_derivative)
  {
    Lattice::Random random(5);
    unsigned int    n_plastic = 0, n_used = 0;
    for (const double psi : {0., 8.})
      for (const double tension : {infinity, 0.})
        {
          const ShearStrengthTable clay = law(psi, tension);
          for (unsigned int i = 0; i < 80; ++i)
            {
              const auto strain = random.stress<3>(0.006);
              const auto begin =
                random.stress<3>(5.) - (2. + i) * unit_symmetric_tensor<3>();
              const auto end = [&](const SymmetricTensor<2, 3> &e) {
                SymmetricTensor<2, 3> stress       = begin;
                double                variables[2] = {1., 0.};
                clay.update(e, stress, variables, nullptr);
                return stress;
              };
              SymmetricTensor<2, 3> stress = begin;
              SymmetricTensor<4, 3> C;
              double                variables[2] = {1., 0.};
              clay.update(strain, stress, variables, &C);
              n_plastic += variables[1] > 0.;
              constexpr double step  = 1e-8;
              bool             kinks = false;
              double           worst = 0.;
              for (unsigned int b = 0; b < 6; ++b)
                {
                  SymmetricTensor<2, 3> up = strain, down = strain;
                  up.access_raw_entry(b) += step;
                  down.access_raw_entry(b) -= step;
                  // A shear entry of the tensor stands for two.
                  const auto one_side = (end(up) - stress) / step,
                             other    = (stress - end(down)) / step;
                  kinks = kinks || (one_side - other).norm() > 30.;
                  for (unsigned int a = 0; a < 6; ++a)
                    worst =
                      std::max(worst,
                               std::abs(
                                 0.5 * (one_side + other).access_raw_entry(a) -
                                 (b < 3 ? 1. : 2.) *
                                   C.access_raw_entry(6 * a + b)));
                }
              if (kinks)
                continue; // where another plane takes over
              ++n_used;
              EXPECT_LT(worst, 0.5); // of 27,000: steps of 1e-8
            }
        }
    EXPECT_GT(n_plastic, 150u);
    EXPECT_GT(n_used, 250u);
  }


  TEST(ShearStrengthTable, every_stress_finds_its_return)
  {
    Lattice::Random random(17);
    double          worst = 0.;
    for (const double psi : {0., 3., 25.})
      for (const double tension : {infinity, 1., 0.})
        {
          const ShearStrengthTable clay = law(psi, tension);
          for (unsigned int i = 0; i < 3000; ++i)
            {
              const double          size = i % 3 == 0 ? 0.1 : 0.005;
              SymmetricTensor<2, 3> stress =
                random.stress<3>(20.) -
                random(-5., 60.) * unit_symmetric_tensor<3>();
              double variables[2] = {random(0.3, 2.), 0.};
              ASSERT_NO_THROW(clay.update(
                random.stress<3>(size), stress, variables, nullptr));
              const auto s = principal_stress(stress).value;
              worst        = std::max(worst, s[0] - tension);
              for (const auto &line : lines_through(entries))
                {
                  const double t   = variables[0] * line.tan_phi;
                  const double cos = 1. / std::sqrt(1. + t * t);
                  worst =
                    std::max(worst,
                             (1. + t * cos) * s[0] - (1. - t * cos) * s[2] -
                               2. * variables[0] * line.cohesion * cos);
                }
            }
        }
    EXPECT_LT(worst, 1e-7);
  }


  TEST(ShearStrengthTable, a_reduction_divides_the_strength)
  {
    const ShearStrengthTable clay         = law();
    double                   variables[2] = {1., 0.2};
    clay.divide_strengths(1.6, variables);
    EXPECT_EQ(variables[0], 1. / 1.6);
    EXPECT_EQ(variables[1], 0.2);
    EXPECT_TRUE(clay.is_of_effective_stress());
    EXPECT_FALSE(clay.has_symmetric_tangent());
    EXPECT_TRUE(clay.initial_problem({0., 0.}));
    EXPECT_FALSE(clay.initial_problem({0.5, 0.}));
  }


  TEST(ShearStrengthTable, made_from_parameters)
  {
    MaterialParameters p;
    p.name                        = "peat";
    p.model                       = MaterialModel::mohr_coulomb;
    p.mohr_coulomb.strength_table = "0: 3, 10: 10, 40: 22, 80: 30";
    EXPECT_NO_THROW(p.check(2, 0.5));
    const auto            made   = make_material(p, 10., 0.5);
    SymmetricTensor<2, 3> stress = -30. * unit_symmetric_tensor<3>(), shear;
    shear[0][1]                  = 0.5;
    double variables[2]          = {1., 0.};
    ASSERT_EQ(made->variables()[0].name, "strength factor");
    made->update(shear, stress, variables, nullptr);
    EXPECT_NEAR(beyond(stress), 0., 1e-5);

    const auto table = [](const std::string &text) {
      shear_strength_entries(text, "T");
    };
    EXPECT_NO_THROW(table("0: 0, 10: 5"));
    EXPECT_USER_ERROR(table("0: 1"), "T", "has 1 pair");
    EXPECT_USER_ERROR(table("5: 1, 10: 5"), "T", "begins at");
    EXPECT_USER_ERROR(table("0: 1, 10: 5, 10: 6"), "T", "after");
    EXPECT_USER_ERROR(table("0: 1, 10: 0.5"), "T", "falls");
    EXPECT_USER_ERROR(table("0: 1, 10: 2, 20: 5"), "T", "steeper");
    EXPECT_USER_ERROR(table("0: 0, 10: 0"), "T", "no strength");
    EXPECT_USER_ERROR(table("0: 1, 1e-9: 5"), "T", "too steep");
    for (const char *const odd :
         {"0: nan, 1: 2", "0: -1, 1: 2", "0: 1, inf: 2", "a: 1, 2: 3", "0, 1"})
      EXPECT_THROW(table(odd), UserError);
    p.mohr_coulomb.softening_strain = 0.1;
    EXPECT_USER_ERROR(p.check(2, 0.5),
                      "Materials/peat/Softening strain",
                      "with a Shear");
    // Also where it is not used.
    p.model                       = MaterialModel::linear_elastic;
    p.mohr_coulomb.strength_table = "1: 2";
    EXPECT_USER_ERROR(p.check(2, 0.5),
                      "Materials/peat/Shear strength table",
                      "begins at");
  }
} // namespace materials_shear_strength_table
