// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/factory.h>
#include <waker/mechanics/step_motion.h>
#include <waker/mechanics/stress_update.h>

#include "mapping_lattice.h"
#include "named.h"
#include "verification_data.h"
#include <gtest/gtest.h>

namespace materials_simple_shear
{
  // Simple shear of one point of the chapter 5 clay, strained through the grid
  // with small strains: every number is known in closed form.

  using namespace Waker;

  namespace
  {
    constexpr double c_i = 13., c_r = 5., H_s = -50.; // kPa
    constexpr double G      = 1000. / (2. * 1.45);    // kPa
    const double     sqrt_3 = std::sqrt(3.);


    struct Moment
    {
      double gamma;          // total shear, -
      double tau;            // kPa
      double strength;       // kPa
      double plastic_strain; // the invariant that softens, -
      double dissipation;    // so far, kPa

      double
      plastic_gamma() const
      {
        return gamma - tau / G;
      }
    };


    /// Shear a point to `gamma` in n steps.
    template <int dim>
    std::vector<Moment>
    shear(const std::string &invariant,
          const double       gamma,
          const unsigned int n)
    {
      MaterialParameters parameters; // of chapter 5 by default
      parameters.von_mises.initial_strength         = std::to_string(c_i);
      parameters.von_mises.residual_strength        = std::to_string(c_r);
      parameters.von_mises.softening_modulus        = H_s;
      parameters.von_mises.plastic_strain_invariant = Named{invariant};
      Materials materials;
      materials.push_back(make_material(parameters, 9.81, 0.25));

      const auto          grid = Lattice::grid<dim>(1., 0.25);
      MaterialPoints<dim> points;
      Point<dim>          x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = 0.53 + 0.1 * d;
      const double volume = 0.01;
      Lattice::add_point(points, x, volume, 0.06);
      declare_material_variables(materials, points);
      Weights<dim> weights(grid, ShapeFunctions::gimp);
      weights.reinit(points);

      Tensor<2, dim> H;
      H[0][1]                = gamma / n; // u_x = gamma y
      const NodalVector   du = Lattice::linear_field(grid, H, Tensor<1, dim>());
      NodalVector         force(grid.n_dofs());
      StressUpdate<dim>   update(materials,
                               std::make_unique<StepMotion<dim>>(false));
      std::vector<Moment> history = {{0., 0., c_i, 0., 0.}};
      for (unsigned int step = 1; step <= n; ++step)
        {
          update.begin(points, weights);
          update.evaluate(points, weights, du, force);
          const StressReport report = update.accept(points);
          const Moment       before = history.back();
          history.push_back({step * gamma / n,
                             points.stress[0][0][1],
                             points.scalar("undrained shear strength")[0],
                             points.scalar("plastic strain")[0],
                             before.dissipation + report.dissipation / volume});
          EXPECT_NEAR(report.plastic_strain,
                      history.back().plastic_strain - before.plastic_strain,
                      1e-15);
          // Pure shear: nothing else.
          SymmetricTensor<2, 3> rest = points.stress[0];
          rest[0][1]                 = 0.;
          EXPECT_LT(rest.norm(), 1e-11);
        }
      return history;
    }


    /// @param factor the softening invariant per plastic shear strain
    template <int dim>
    void
    check_shear(const std::string &invariant, const double factor)
    {
      const double       yield    = c_i / G;
      const double       residual = (c_i - c_r) / (-H_s * factor);
      const unsigned int n        = 600;
      const auto         history  = shear<dim>(invariant, 0.6, n);
      ASSERT_EQ(history.size(), n + 1);

      double first_plastic = -1., first_residual = -1.;
      double plastic_work = 0.;
      for (unsigned int k = 1; k <= n; ++k)
        {
          const Moment &m = history[k], &before = history[k - 1];
          if (m.plastic_strain == 0.)
            {
              EXPECT_NEAR(m.tau, G * m.gamma, 1e-11);
              EXPECT_EQ(m.dissipation, 0.);
            }
          else
            {
              if (first_plastic < 0.)
                first_plastic = m.gamma;
              const double expected =
                std::max(c_r, c_i + H_s * factor * m.plastic_gamma());
              EXPECT_NEAR(m.tau, expected, 1e-11);
              EXPECT_NEAR(m.strength, expected, 1e-11);
              EXPECT_NEAR(m.plastic_strain, factor * m.plastic_gamma(), 1e-13);
              if (first_residual < 0. && m.tau < c_r + 1e-9)
                first_residual = m.plastic_gamma();
              // Dissipation of a step: tau d(gamma_p) with tau at its end.
              plastic_work +=
                m.tau * (m.plastic_gamma() - before.plastic_gamma());
              EXPECT_NEAR(m.dissipation, plastic_work, 1e-11);
            }
        }
      const double step = 0.6 / n;
      EXPECT_GT(first_plastic, yield);
      EXPECT_LT(first_plastic, yield + step);
      EXPECT_GE(first_residual, residual - 1e-12);
      EXPECT_LT(first_residual, residual + 1.2 * step);

      // The slope between two moments that are both softening.
      const Moment &a = history[60], &b = history[200];
      ASSERT_GT(a.plastic_strain, 0.);
      ASSERT_GT(b.tau, c_r);
      const double slope =
        (b.tau - a.tau) / (b.plastic_gamma() - a.plastic_gamma());
      EXPECT_NEAR(slope, H_s * factor, 1e-10);

      // Radial return is exact on this path: one step does it, too.
      for (const double gamma : {0.1, 0.2, 0.6})
        {
          const Moment one  = shear<dim>(invariant, gamma, 1).back();
          const Moment many = shear<dim>(invariant, gamma, 500).back();
          EXPECT_NEAR(one.tau, many.tau, 1e-11);
          EXPECT_NEAR(one.plastic_strain, many.plastic_strain, 1e-13);
        }

      if (dim == 2)
        {
          for (unsigned int k = 0; k <= n; k += 3)
            Verification::row("simple_shear_" + invariant,
                              "gamma,tau,plastic gamma,strength,plastic strain,"
                              "dissipation",
                              history[k].gamma,
                              history[k].tau,
                              history[k].plastic_gamma(),
                              history[k].strength,
                              history[k].plastic_strain,
                              history[k].dissipation);
          // Yield: where the softening line starts, and the last elastic shear.
          double last_elastic = 0.;
          for (const Moment &m : history)
            if (m.plastic_strain == 0.)
              last_elastic = m.tau;
          Verification::row(
            "simple_shear",
            "invariant,last elastic tau (kPa),"
            "softening line at plastic gamma 0 (kPa),slope (kPa),"
            "expected slope (kPa),plastic gamma at residual,"
            "expected plastic gamma",
            invariant,
            last_elastic,
            b.tau - slope * b.plastic_gamma(),
            slope,
            H_s * factor,
            b.plastic_gamma() + (c_r - b.tau) / slope,
            residual);
        }
    }
  } // namespace


  TEST(Materials, simple_shear_softens_with_the_equivalent_strain)
  {
    // Yield at tau = c_i, slope H_s / sqrt(3), residual at
    // gamma_p = sqrt(3) (c_i - c_r) / |H_s|.
    check_shear<2>("equivalent", 1. / sqrt_3);
    check_shear<3>("equivalent", 1. / sqrt_3);
  }


  TEST(Materials, simple_shear_softens_with_the_half_strain)
  {
    // sqrt(e:e / 2) is gamma_p / 2: slope H_s / 2.
    check_shear<2>("half", 0.5);
    check_shear<3>("half", 0.5);
  }
} // namespace materials_simple_shear
