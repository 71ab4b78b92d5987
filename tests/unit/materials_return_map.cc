// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/von_mises_softening.h>

#include "mapping_lattice.h"
#include "verification_data.h"
#include <gtest/gtest.h>

namespace materials_return_map
{
  using namespace Waker;

  namespace
  {
    constexpr double E = 1000., nu = 0.45; // kPa, -
    constexpr double G = E / (2. * (1. + nu)), K = E / (3. * (1. - 2. * nu));
    const double     sqrt_3 = std::sqrt(3.);
    using Invariant         = VonMisesSoftening::Invariant;


    struct PointState
    {
      SymmetricTensor<2, 3> stress;
      double                variables[3]; // c, c_r, plastic strain
    };


    double
    von_mises(const SymmetricTensor<2, 3> &stress)
    {
      return std::sqrt(1.5) * deviator(stress).norm();
    }


    /// The rate equations, integrated by brute force with Heun's method in tiny
    /// steps: associated flow, f = q - sqrt(3) c, dc = H d(lambda) until c_r.
    /// No return, no trial stress.
    PointState
    integrate(PointState                   state,
              const SymmetricTensor<2, 3> &strain,
              const double                 H,
              const unsigned int           n)
    {
      const auto de   = strain / n;
      const auto rate = [&](const SymmetricTensor<2, 3> &stress,
                            const double                 modulus) {
        const auto   s = deviator(stress);
        const double q = von_mises(stress);
        return std::max(0.,
                        3. * G * (s * de) / q / (3. * G + sqrt_3 * modulus));
      };
      for (unsigned int k = 0; k < n; ++k)
        {
          const auto elastic =
            2. * G * deviator(de) + K * trace(de) * unit_symmetric_tensor<3>();
          if (von_mises(state.stress + elastic) < sqrt_3 * state.variables[0])
            {
              state.stress += elastic;
              continue;
            }
          const double modulus =
            state.variables[0] > state.variables[1] ? H : 0.;
          const auto flow = [&](const SymmetricTensor<2, 3> &stress) {
            return rate(stress, modulus) * 1.5 / von_mises(stress) *
                   deviator(stress);
          };
          const auto   first   = flow(state.stress);
          const auto   second  = flow(state.stress + elastic - 2. * G * first);
          const auto   plastic = 0.5 * (first + second);
          const double multiplier = std::sqrt(2. / 3.) * plastic.norm();
          state.stress += elastic - 2. * G * plastic;
          state.variables[0] =
            std::max(state.variables[1],
                     state.variables[0] + modulus * multiplier);
          state.variables[2] += multiplier;
        }
      return state;
    }


    PointState
    return_map(PointState                   state,
               const VonMisesSoftening     &material,
               const SymmetricTensor<2, 3> &strain,
               const unsigned int           n)
    {
      for (unsigned int k = 0; k < n; ++k)
        material.update(strain / n, state.stress, state.variables, nullptr);
      return state;
    }


    SymmetricTensor<2, 3>
    symmetric(const double xx,
              const double yy,
              const double zz,
              const double xy,
              const double xz = 0.,
              const double yz = 0.)
    {
      SymmetricTensor<2, 3> t;
      t[0][0] = xx, t[1][1] = yy, t[2][2] = zz;
      t[0][1] = xy, t[0][2] = xz, t[1][2] = yz;
      return t;
    }
  } // namespace


  TEST(Materials, return_map_is_first_order_to_brute_force)
  {
    const VonMisesSoftening material(1.5, E, nu, 13., 5., -50.);
    // Elastic, yielding, softening and residual, on a path that turns the
    // deviator by about 90 degrees: radial return is then an approximation.
    const PointState start = {symmetric(-20., -4., -10., 2.), {13., 5., 0.}};
    struct Path
    {
      const char           *name;
      SymmetricTensor<2, 3> strain;
      bool                  residual;
    };
    const Path paths[] = {
      {"to softening", symmetric(-0.01, 0.012, 0., 0.04), false},
      {"to residual strength",
       symmetric(0.03, -0.05, 0.01, 0.13, -0.06, 0.04),
       true},
    };
    for (const Path &path : paths)
      {
        const PointState exact = integrate(start, path.strain, -50., 200000);
        // The reference itself is good enough.
        const PointState coarse = integrate(start, path.strain, -50., 100000);
        EXPECT_LT((exact.stress - coarse.stress).norm(), 1e-3) << path.name;
        EXPECT_GT(exact.variables[2], 0.01);

        double last_stress = 0., last_plastic = 0.;
        for (unsigned int n = 25; n <= 400; n *= 2)
          {
            const PointState result =
              return_map(start, material, path.strain, n);
            const double stress = (result.stress - exact.stress).norm();
            const double plastic =
              std::abs(result.variables[2] - exact.variables[2]);
            Verification::row("simple_shear_return_map",
                              "path,steps,stress error (kPa),"
                              "plastic strain error",
                              path.name,
                              n,
                              stress,
                              plastic);
            if (n > 50)
              {
                EXPECT_NEAR(last_plastic / plastic, 2., 0.15) << path.name << n;
                // At the residual strength the stress forgets its past: what
                // remains is the drift of the reference.
                EXPECT_TRUE(path.residual ||
                            std::abs(last_stress / stress - 2.) < 0.15)
                  << path.name << n;
              }
            last_stress  = stress;
            last_plastic = plastic;
          }
        EXPECT_LT(last_stress, 0.01) << path.name;
        EXPECT_EQ(exact.variables[0] == 5., path.residual) << path.name;
      }
  }


  TEST(Materials, return_map_is_exact_on_radial_paths)
  {
    // Any deviator, loaded further along itself, with compression on top: from
    // elastic over the kink to the residual strength in one step.
    for (const auto invariant : {Invariant::equivalent, Invariant::half})
      for (const double size : {0.04, 0.1, 0.3})
        {
          const double factor = invariant == Invariant::half ? sqrt_3 / 2. : 1.;
          const VonMisesSoftening material(
            1.5, E, nu, 13., 5., -50., invariant);
          const auto direction =
            deviator(symmetric(0.5, -0.2, 0.1, 0.3, -0.4, 0.2));
          const auto strain = size / direction.norm() * direction -
                              0.01 * unit_symmetric_tensor<3>();
          const PointState one =
            return_map({{}, {13., 5., 0.}}, material, strain, 1);

          // By hand: q = 3 G (e_q - lambda), c = max(c_r, c_i + H lambda).
          const double H   = -50. * factor;
          const double e_q = std::sqrt(2. / 3.) * size;
          double lambda = (3. * G * e_q - sqrt_3 * 13.) / (3. * G + sqrt_3 * H);
          double c      = 13. + H * lambda;
          if (c < 5.)
            {
              c      = 5.;
              lambda = e_q - sqrt_3 * c / (3. * G);
            }
          EXPECT_NEAR(one.variables[0], c, 1e-11) << size;
          EXPECT_NEAR(one.variables[2], factor * lambda, 1e-13) << size;
          EXPECT_NEAR(von_mises(one.stress), sqrt_3 * c, 1e-11) << size;
          EXPECT_NEAR(trace(one.stress), -0.09 * K, 1e-9) << size;
          const auto off_axis =
            deviator(one.stress) -
            sqrt_3 * c / (std::sqrt(1.5) * size) * deviator(strain);
          EXPECT_LT(off_axis.norm(), 1e-11) << size;
        }
  }


  TEST(Materials, strength_stays_between_its_bounds)
  {
    // A random walk in strain: yield is never exceeded, strength never rises
    // nor falls below its residual value, dissipation is sqrt(3) c d(lambda).
    Lattice::Random random(5);
    for (const auto invariant : {Invariant::equivalent, Invariant::half})
      for (const double residual : {5., 13., 0.})
        {
          const double factor = invariant == Invariant::half ? sqrt_3 / 2. : 1.;
          const VonMisesSoftening material(
            1.5, E, nu, 13., residual, -50., invariant);
          PointState state     = {{}, {13., residual, 0.}};
          double     total     = 0.;
          bool       was_still = false, has_softened = false;
          for (unsigned int step = 0; step < 4000; ++step)
            {
              const double size =
                step % 40 == 0 ? 0.1 : (step % 7 == 0 ? 1e-5 : 0.004);
              const auto   strain = random.stress<3>(size);
              const double c = state.variables[0], e = state.variables[2];
              const double p = trace(state.stress);
              const double energy =
                material.update(strain, state.stress, state.variables, nullptr);
              total += trace(strain);
              ASSERT_LE(von_mises(state.stress),
                        sqrt_3 * state.variables[0] + 1e-11);
              ASSERT_LE(state.variables[0], c);
              ASSERT_GE(state.variables[0], residual);
              ASSERT_GE(state.variables[2], e);
              ASSERT_EQ(state.variables[1], residual);
              ASSERT_NEAR(trace(state.stress) - p,
                          3. * K * trace(strain),
                          1e-9);
              ASSERT_NEAR(energy,
                          sqrt_3 * state.variables[0] *
                            (state.variables[2] - e) / factor,
                          1e-12);
              was_still    = was_still || state.variables[2] == e;
              has_softened = has_softened || state.variables[0] < c;
            }
          EXPECT_NEAR(state.variables[0], residual, 1e-12); // it gets there
          EXPECT_NEAR(trace(state.stress), 3. * K * total, 1e-6);
          EXPECT_TRUE(was_still || residual == 0.);
          EXPECT_EQ(has_softened, residual < 13.);
        }
  }
} // namespace materials_return_map
