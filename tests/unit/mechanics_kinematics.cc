// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/von_mises_softening.h>
#include <waker/mechanics/kinematics.h>

#include "mapping_lattice.h"
#include "verification_data.h"
#include <gtest/gtest.h>

namespace mechanics_kinematics
{
  using namespace Waker;

  namespace
  {
    /// The derivative that Kinematics gives, and its largest error relative to
    /// its largest entry, for a material at a given start.
    template <int dim>
    double
    derivative_error(const Material              &material,
                     const std::array<double, 3> &variables,
                     const SymmetricTensor<2, 3> &start,
                     const Tensor<2, dim>        &H,
                     const bool                   objective,
                     bool                        *yields)
    {
      const auto stress_at = [&](const Tensor<2, dim>  &gradient,
                                 SymmetricTensor<4, 3> *tangent) {
        const Kinematics<dim> motion(gradient, objective);
        std::array<double, 3> v      = variables;
        SymmetricTensor<2, 3> stress = motion.turn(start);
        material.update(motion.strain(), stress, v.data(), tangent);
        if (tangent != nullptr)
          *yields = v[2] > variables[2];
        return stress;
      };
      constexpr unsigned int n    = dim * (dim + 1) / 2;
      const unsigned int     i[6] = {0, 1, dim == 2 ? 0u : 2u, 0, 0, 1};
      const unsigned int     j[6] = {0, 1, dim == 2 ? 1u : 2u, 1, 2, 2};

      SymmetricTensor<4, 3> D;
      stress_at(H, &D);
      const Kinematics<dim> motion(H, objective);
      const double          scale = 0.7; // a point's volume
      double                A[n][dim * dim];
      motion.stress_derivative(
        D, motion.turn(start), material.shear_modulus(), scale, A);

      const double delta = 1e-6;
      double       error = 0., size = 0.;
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int l = 0; l < dim; ++l)
          {
            Tensor<2, dim> up = H, down = H;
            up[k][l] += delta;
            down[k][l] -= delta;
            const auto difference =
              scale / (2. * delta) *
              (stress_at(up, nullptr) - stress_at(down, nullptr));
            for (unsigned int a = 0; a < n; ++a)
              {
                const double value = A[a][dim * k + l];
                error =
                  std::max(error, std::abs(difference[i[a]][j[a]] - value));
                size = std::max(size, std::abs(value));
              }
          }
      return error / size;
    }


    template <int dim>
    void
    check_derivative(const bool objective)
    {
      const VonMisesSoftening material(1.5, 1000., 0.45, 13., 5., -50.);
      Lattice::Random         random(23 + dim);
      // Small steps, steps with 60 degrees of rotation, and 40 % of stretch.
      const char *const names[]  = {"small", "rotation", "stretch"};
      const double      sizes[]  = {0.02, 0.04, 0.4};
      const double      angles[] = {0., 1., 0.3};
      for (unsigned int kind = 0; kind < 3; ++kind)
        {
          unsigned int n_yielding = 0;
          double       worst      = 0.;
          for (unsigned int n = 0; n < 100; ++n)
            {
              const auto R =
                Lattice::rotation<dim>(angles[kind],
                                       dim == 2 ? Tensor<1, 3>({0., 0., 1.})
                                                : random.vector<3>(-1., 1.));
              Tensor<2, dim> F = random.matrix<dim>(-sizes[kind], sizes[kind]);
              F += R;
              Tensor<2, dim> H = F;
              for (unsigned int d = 0; d < dim; ++d)
                H[d][d] -= 1.;
              // Start inside the yield surface, with pressure.
              const double strength =
                n % 3 == 0 ? 1e6 : (n % 3 == 1 ? 13. : 5.);
              const auto start =
                random.stress<dim>(1.5) - 30. * unit_symmetric_tensor<3>();
              bool         yields = false;
              const double error  = derivative_error<dim>(
                material, {{strength, 5., 0.}}, start, H, objective, &yields);
              EXPECT_LT(error, 1e-7) << names[kind] << ' ' << n;
              worst = std::max(worst, error);
              n_yielding += yields;
            }
          EXPECT_GT(n_yielding, 10u) << names[kind];
          EXPECT_LT(n_yielding, 90u) << names[kind];
          Verification::row("tangents_kinematics",
                            "dimension,objective rate,step,states yielding,"
                            "largest relative error",
                            dim,
                            objective,
                            names[kind],
                            n_yielding,
                            worst);
        }
    }


    template <int dim>
    void
    check_rotation()
    {
      Lattice::Random random(29);
      for (unsigned int n = 0; n < 200; ++n)
        {
          const double       angle = random(-2.5, 2.5); // far in one step
          const Tensor<1, 3> axis =
            dim == 2 ? Tensor<1, 3>({0., 0., 1.}) : random.vector<3>(-1., 1.);
          const Tensor<2, dim> R = Lattice::rotation<dim>(angle, axis);
          Tensor<2, dim>       H = R;
          for (unsigned int d = 0; d < dim; ++d)
            H[d][d] -= 1.;
          const Kinematics<dim> motion(H, true);
          EXPECT_LT(motion.strain().norm(), 1e-14) << angle;

          const auto         s        = random.stress<dim>(10.);
          const Tensor<2, 3> Q        = Lattice::embedded(R);
          const Tensor<2, 3> expected = Q * Tensor<2, 3>(s) * transpose(Q);
          EXPECT_LT((Tensor<2, 3>(motion.turn(s)) - expected).norm(), 1e-12);

          // Without the objective rate the same motion strains the point.
          const Kinematics<dim> small(H, false);
          EXPECT_GT(small.strain().norm(), 0.5 * (1. - std::cos(angle)));
          EXPECT_EQ((small.turn(s) - s).norm(), 0.);
        }
    }
  } // namespace


  TEST(Mechanics, a_rotation_in_one_step_turns_stress_and_strains_nothing)
  {
    check_rotation<2>();
    check_rotation<3>();
  }


  TEST(Mechanics, mid_step_strain_of_a_stretch)
  {
    // From 1 to 1 + H the mid-step strain is H / (1 + H/2): log(1 + H) but for
    // third order, and the way back undoes it.
    Tensor<2, 3> H;
    H[0][0] = 0.3, H[1][1] = -0.2, H[2][2] = 0.1;
    const auto e = Kinematics<3>(H, true).strain();
    for (unsigned int d = 0; d < 3; ++d)
      {
        EXPECT_NEAR(e[d][d], H[d][d] / (1. + 0.5 * H[d][d]), 1e-15);
        EXPECT_NEAR(e[d][d],
                    std::log1p(H[d][d]),
                    0.1 * std::pow(H[d][d], 2) / 2);
      }
    Tensor<2, 3> back;
    for (unsigned int d = 0; d < 3; ++d)
      back[d][d] = 1. / (1. + H[d][d]) - 1.;
    EXPECT_LT((Kinematics<3>(back, true).strain() + e).norm(), 1e-15);
    EXPECT_EQ(Kinematics<3>(H, false).strain()[0][0], 0.3);
  }


  TEST(Mechanics, stress_derivative_is_the_derivative)
  {
    for (const bool objective : {true, false})
      {
        check_derivative<2>(objective);
        check_derivative<3>(objective);
      }
  }


  TEST(Mechanics, plane_strain_is_a_slice_of_three_dimensions)
  {
    Lattice::Random random(31);
    for (unsigned int n = 0; n < 50; ++n)
      {
        const auto   H2 = random.matrix<2>(-0.4, 0.4);
        Tensor<2, 3> H3;
        for (unsigned int i = 0; i < 2; ++i)
          H3[i] = Tensor<1, 3>({H2[i][0], H2[i][1], 0.});
        const auto          s = random.stress<2>(10.);
        const Kinematics<2> flat(H2, true);
        const Kinematics<3> solid(H3, true);
        EXPECT_LT((flat.strain() - solid.strain()).norm(), 1e-14);
        EXPECT_LT((flat.turn(s) - solid.turn(s)).norm(), 1e-13);
      }
  }
} // namespace mechanics_kinematics
