// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/von_mises_softening.h>

#include "mapping_lattice.h"
#include "verification_data.h"
#include <gtest/gtest.h>

namespace materials_tangent
{
  // The algorithmic tangent against central differences of the stress.

  using namespace Waker;

  namespace
  {
    using Invariant = VonMisesSoftening::Invariant;


    struct Input
    {
      SymmetricTensor<2, 3> stress;
      SymmetricTensor<2, 3> strain;
      double                strength, residual;
    };


    SymmetricTensor<2, 3>
    stress_after(const Material              &material,
                 const Input                 &input,
                 const SymmetricTensor<2, 3> &change,
                 SymmetricTensor<4, 3>       *tangent  = nullptr,
                 double                      *strength = nullptr)
    {
      double variables[3]          = {input.strength, input.residual, 0.1};
      SymmetricTensor<2, 3> stress = input.stress;
      material.update(input.strain + change, stress, variables, tangent);
      if (strength != nullptr)
        *strength = variables[0];
      return stress;
    }


    /// Largest error of the tangent over its largest entry.
    double
    tangent_error(const Material &material, const Input &input)
    {
      SymmetricTensor<4, 3> D;
      stress_after(material, input, {}, &D);
      const double delta = 1e-6;
      double       error = 0., size = 0.;
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int l = k; l < 3; ++l)
          {
            SymmetricTensor<2, 3> e;
            e[k][l]               = delta; // for k != l also the entry (l, k)
            const auto difference = (stress_after(material, input, e) -
                                     stress_after(material, input, -1. * e)) /
                                    (k == l ? 2. * delta : 4. * delta);
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int j = i; j < 3; ++j)
                {
                  error =
                    std::max(error, std::abs(difference[i][j] - D[i][j][k][l]));
                  size = std::max(size, std::abs(D[i][j][k][l]));
                }
          }
      return error / size;
    }


    /// Which branch the return takes.
    enum Regime
    {
      elastic,
      softening,
      kink, // the strength reaches its residual value in the step
      residual,
      n_regimes
    };
    const char *const regime_names[] = {"elastic",
                                        "softening",
                                        "over the kink",
                                        "residual"};
  } // namespace


  TEST(Materials, algorithmic_tangent_is_the_derivative)
  {
    Lattice::Random random(17);
    unsigned int    count[n_regimes] = {};
    double          worst[n_regimes] = {};
    for (const auto invariant : {Invariant::equivalent, Invariant::half})
      for (unsigned int n = 0; n < 400; ++n)
        {
          const VonMisesSoftening material(
            1.5, 1000., 0.45, 13., 5., -50., invariant);
          Input input;
          // A start inside the yield surface, q < sqrt(3) 5.
          input.stress = random.stress<3>(1.5);
          input.stress += random(-60., 10.) * unit_symmetric_tensor<3>();
          input.strain   = random.stress<3>(n % 4 == 0   ? 0.002
                                            : n % 4 == 1 ? 0.15
                                                         : 0.05);
          input.residual = 5.;
          input.strength = n % 4 == 3 ? 5. : random(6., 13.);
          double after   = 0.;
          stress_after(material, input, {}, nullptr, &after);
          const Regime regime = input.strength == 5.      ? residual
                                : after == input.strength ? elastic
                                : after == 5.             ? kink
                                                          : softening;
          // Not within the differences' reach of a corner.
          if (after != 5. && after < 5.001)
            continue;
          const double error = tangent_error(material, input);
          EXPECT_LT(error, 2e-8) << regime_names[regime] << ' ' << n;
          worst[regime] = std::max(worst[regime], error);
          ++count[regime];
        }
    for (unsigned int r = 0; r < n_regimes; ++r)
      {
        EXPECT_GT(count[r], 40u) << regime_names[r];
        Verification::row("tangents_material",
                          "regime,states,largest relative error",
                          regime_names[r],
                          count[r],
                          worst[r]);
      }
  }


  TEST(Materials, linear_elastic_tangent_is_the_derivative)
  {
    const LinearElastic material(1.5, 1000., 0.3);
    Lattice::Random     random(18);
    for (unsigned int n = 0; n < 20; ++n)
      EXPECT_LT(
        tangent_error(material,
                      {random.stress<3>(10.), random.stress<3>(0.1), 0., 0.}),
        2e-9);
    // And the law itself: uniaxial strain, and shear.
    SymmetricTensor<2, 3> strain, stress;
    strain[1][1] = 0.01;
    strain[0][1] = 0.02;
    EXPECT_EQ(material.update(strain, stress, nullptr, nullptr), 0.);
    const double M = 1000. * 0.7 / (1.3 * 0.4);
    EXPECT_NEAR(stress[1][1], 0.01 * M, 1e-12);
    EXPECT_NEAR(stress[0][0], 0.01 * M * 0.3 / 0.7, 1e-12);
    EXPECT_NEAR(stress[2][2], 0.01 * M * 0.3 / 0.7, 1e-12);
    EXPECT_NEAR(stress[0][1], 0.04 * 1000. / 2.6, 1e-12);
    EXPECT_NEAR(material.bulk_modulus() + 4. / 3. * material.shear_modulus(),
                M,
                1e-10);
  }


  TEST(Materials, softening_tangent_has_the_slope_of_simple_shear)
  {
    // Just over yield the stress falls along the flow direction: the solvers
    // must live with an indefinite tangent.
    const VonMisesSoftening material(1.5, 1000., 0.45, 13., 5., -50.);
    const double            G = 1000. / 2.9;
    Input                   input{{}, {}, 13., 5.};
    input.strain[0][1] = 0.5 * (13. / G + 0.02); // just over yield
    SymmetricTensor<4, 3> D;
    stress_after(material, input, {}, &D);
    // d tau / d gamma = G H' / (3 G + H') with H' = sqrt(3) H_s.
    const double H = -50. * std::sqrt(3.);
    EXPECT_NEAR(D[0][1][0][1], G * H / (3. * G + H), 1e-10);
  }
} // namespace materials_tangent
