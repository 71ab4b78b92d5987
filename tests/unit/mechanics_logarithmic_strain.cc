// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/von_mises_softening.h>
#include <waker/mechanics/consistent_tangent.h>
#include <waker/mechanics/deformation.h>
#include <waker/mechanics/logarithmic_motion.h>

#include "logarithmic_body.h"
#include "mapping_lattice.h"
#include <gtest/gtest.h>

namespace mechanics_logarithmic_strain
{
  // Logarithmic strain against closed forms, and its tangent against
  // differences of the internal force.

  using namespace Waker;
  using namespace LogarithmicBody;
  using LogarithmicBody::identity; // there are others

  namespace
  {
    template <int dim>
    void
    check_uniaxial(const double stretch)
    {
      Body<dim>      body;
      Tensor<2, dim> F    = identity<dim>();
      F[0][0]             = stretch;
      const auto   report = body.deform(F);
      const double M = K + 4. / 3. * G, e = std::log(stretch);
      for (unsigned int p = 0; p < body.points.n_points(); ++p)
        {
          const SymmetricTensor<2, 3> tau = stretch * body.points.stress[p];
          EXPECT_NEAR(tau[0][0], M * e, 1e-12 * M);
          EXPECT_NEAR(tau[1][1], (K - 2. / 3. * G) * e, 1e-12 * M);
          EXPECT_NEAR(tau[2][2], (K - 2. / 3. * G) * e, 1e-12 * M);
          EXPECT_NEAR(body.points.volume[p], stretch * body.V0, 1e-14);
        }
      EXPECT_NEAR(report.elastic_energy,
                  body.points.n_points() * body.V0 * 0.5 * M * e * e,
                  1e-11 * M * body.V0);
    }


    template <int dim>
    void
    check_simple_shear(const double gamma)
    {
      Body<dim>      body;
      Tensor<2, dim> F = identity<dim>();
      F[0][1]          = gamma;
      body.deform(F);
      // tau = 2 G ln(lambda) (n n - m m), n at half of atan(2 / gamma).
      const double lambda = 0.5 * gamma + std::sqrt(1. + 0.25 * gamma * gamma);
      const double size   = 2. * G * std::log(lambda);
      const double angle  = std::atan2(2., gamma);
      for (const auto &stress : body.points.stress)
        {
          EXPECT_NEAR(stress[0][0], size * std::cos(angle), 1e-11 * G);
          EXPECT_NEAR(stress[1][1], -size * std::cos(angle), 1e-11 * G);
          EXPECT_NEAR(stress[0][1], size * std::sin(angle), 1e-11 * G);
          EXPECT_NEAR(stress[2][2], 0., 1e-11 * G);
        }
    }


    /// A rotation in one step turns the stress, however large, and leaves a
    /// body without stress alone.
    template <int dim>
    void
    check_rotation()
    {
      const Tensor<1, 3> axis(dim == 2 ? Tensor<1, 3>({0., 0., 1.})
                                       : Tensor<1, 3>({0.3, -0.5, 1.}));
      for (const double angle : {0.01, 1., 3.})
        {
          const auto R = Lattice::rotation<dim>(angle, axis);
          Body<dim>  free;
          free.deform(R);
          for (const auto &stress : free.points.stress)
            EXPECT_LT(stress.norm(), 2e-12 * E);

          Body<dim>       loaded;
          Lattice::Random random(17);
          loaded.deform(identity<dim>() + random.matrix<dim>(-0.3, 0.3));
          const SymmetricTensor<2, 3> before = loaded.points.stress[0];
          const auto                  report = loaded.deform(R);
          const auto                  Q      = Lattice::embedded(R);
          const SymmetricTensor<2, 3> turned =
            symmetrize(Q * Tensor<2, 3>(before) * transpose(Q));
          EXPECT_GT(before.norm(), 0.1 * E);
          EXPECT_LT((loaded.points.stress[0] - turned).norm(), 1e-11 * E);
          EXPECT_NEAR(report.elastic_energy,
                      loaded.deform(identity<dim>()).elastic_energy,
                      1e-12 * report.elastic_energy);
        }
    }


    /// What matters is where a body ends, not in how many steps.
    template <int dim>
    void
    check_steps()
    {
      Lattice::Random      random(23);
      Tensor<2, dim>       F = identity<dim>();
      Body<dim>            stepwise, at_once;
      const Tensor<2, dim> rate = random.matrix<dim>(-0.08, 0.08);
      for (unsigned int k = 0; k < 20; ++k)
        {
          const Tensor<2, dim> dF =
            identity<dim>() + rate + random.matrix<dim>(-0.05, 0.05);
          F = dF * F;
          stepwise.deform(dF);
        }
      const auto report = at_once.deform(F);
      EXPECT_GT(report.elastic_energy, 0.05 * E * at_once.V0);
      for (unsigned int p = 0; p < at_once.points.n_points(); ++p)
        {
          EXPECT_LT(
            (stepwise.points.stress[p] - at_once.points.stress[p]).norm(),
            1e-11 * E);
          EXPECT_NEAR(stepwise.points.volume[p],
                      determinant(F) * at_once.V0,
                      1e-13);
          EXPECT_LT((stepwise.points.deformation[p] - F).norm(), 1e-12);
        }
    }
  } // namespace


  TEST(LogarithmicStrain, Uniaxial)
  {
    for (const double stretch : {0.3, 0.9, 1. + 1e-9, 1.5, 3.})
      {
        check_uniaxial<2>(stretch);
        check_uniaxial<3>(stretch);
      }
  }


  /// Small strains keep their digits.
  TEST(LogarithmicStrain, SmallStrainIsAccurate)
  {
    Tensor<2, 2> H;
    H[0][1] = 1e-9;
    H[0][0] = 2e-9;
    const LogarithmicStep<2> step(H, SymmetricTensor<2, 3>());
    EXPECT_NEAR(step.trial_strain()[0][0] / 2e-9, 1., 1e-8);
    EXPECT_NEAR(step.trial_strain()[0][1] / 5e-10, 1., 1e-8);
    EXPECT_NEAR(step.trial_strain()[1][1], 0., 1e-17);
  }


  TEST(LogarithmicStrain, SimpleShear)
  {
    for (const double gamma : {1e-7, 0.1, 1., 5.})
      {
        check_simple_shear<2>(gamma);
        check_simple_shear<3>(gamma);
      }
  }


  TEST(LogarithmicStrain, Rotation)
  {
    check_rotation<2>();
    check_rotation<3>();
  }


  TEST(LogarithmicStrain, StepSizeDoesNotMatter)
  {
    check_steps<2>();
    check_steps<3>();
  }


  // After plastic flow plane strain has an elastic strain out of the plane:
  // it stays. All of the trial strain is that of the same motion in 3D.
  TEST(LogarithmicStrain, PlaneStrainIsASliceOfThreeDimensions)
  {
    Lattice::Random             random(31);
    const SymmetricTensor<2, 3> in_space = random.stress<3>(0.05);
    SymmetricTensor<2, 3>       elastic;
    elastic[0][0]        = in_space[0][0];
    elastic[1][1]        = in_space[1][1];
    elastic[0][1]        = in_space[0][1];
    elastic[2][2]        = 0.013;
    const Tensor<2, 2> H = random.matrix<2>(-0.1, 0.1);
    Tensor<2, 3>       H_3;
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
        H_3[i][j] = H[i][j];
    const SymmetricTensor<2, 3> plane =
      LogarithmicStep<2>(H, elastic).trial_strain();
    const SymmetricTensor<2, 3> space =
      LogarithmicStep<3>(H_3, elastic).trial_strain();
    EXPECT_EQ(plane[2][2], 0.013);
    EXPECT_GT(space.norm(), 0.05);
    EXPECT_LT((plane - space).norm(), 1e-15);
  }


  /// A step that turns a point inside out must not pass.
  TEST(LogarithmicStrain, InsideOutIsNotANumber)
  {
    Tensor<2, 2> H;
    H[0][0] = -1.2;
    const LogarithmicStep<2> step(H, SymmetricTensor<2, 3>());
    EXPECT_FALSE(std::isfinite(trace(step.trial_strain())));
    Body<2> body;
    body.deform(identity<2>() + H);
    EXPECT_FALSE(std::isfinite(body.force.l2_norm()));
  }
} // namespace mechanics_logarithmic_strain
