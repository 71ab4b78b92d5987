// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/transfer.h>
#include <waker/materials/linear_elastic.h>
#include <waker/mechanics/energy.h>
#include <waker/mechanics/time_scheme.h>

#include "mapping_lattice.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>

namespace mechanics_supports
{
  // What the time schemes do with nodes that a support holds.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.25, density = 1.5, dt = 0.01;


    /// One step of a block that moves and accelerates, on a base that moves.
    struct Step
    {
      Step(const Scheme        chosen,
           const FixityMethod  method,
           const double        gravity,
           const Tensor<1, 2> &velocity,
           const Tensor<1, 2> &acceleration)
        : grid(Lattice::grid<2>(2., h))
        , fixities(grid, {base(method)})
        , weights(grid, ShapeFunctions::gimp)
        , nodes(grid)
        , points(Lattice::box(Point<2>(0.43, 0.), 8, 0.5 * h, density))
      {
        materials.push_back(
          std::make_unique<LinearElastic>(density, 1000., 0.3));
        for (std::size_t p = 0; p < points.n_points(); ++p)
          {
            points.velocity[p]     = velocity;
            points.acceleration[p] = acceleration;
          }
        time.scheme             = chosen;
        time.ramp_duration      = chosen == Scheme::newmark ? 4. * dt : 0.;
        newton.tolerance        = 1e-12;
        newton.linear_tolerance = 1e-12;
        weights.reinit(points);
        to_nodes(points, weights, nodes);
        set_gravity<2>(gravity, nodes);
        scheme = make_time_scheme(SchemeInput<2>{grid,
                                                 weights,
                                                 materials,
                                                 fixities,
                                                 time,
                                                 newton,
                                                 mapping,
                                                 gravity,
                                                 density * h * h});
        take(0.);
      }

      /// From t on, after the points have been mapped.
      void
      take(const double t)
      {
        report = scheme->solve(points, t, dt, nodes);
        EXPECT_TRUE(report.converged);
        scheme->to_points(t, dt, nodes, points, report);
      }

      static FixityParameters
      base(const FixityMethod method)
      {
        FixityParameters parameters;
        parameters.name         = "base";
        parameters.type         = FixityType::prescribed;
        parameters.displacement = "0.3*t; -0.2*t";
        parameters.method       = method;
        return parameters;
      }

      TimeParameters                 time;
      NewtonParameters               newton;
      MappingParameters              mapping;
      BackgroundGrid<2>              grid;
      Fixities<2>                    fixities;
      Weights<2>                     weights;
      NodalState                     nodes;
      Materials                      materials;
      MaterialPoints<2>              points;
      StepReport<2>                  report;
      std::unique_ptr<TimeScheme<2>> scheme;
    };
  } // namespace


  // The points give their nodes an acceleration, which supports do not have.
  TEST(Mechanics, newmark_supports_move_at_constant_velocity)
  {
    const Step   step(Scheme::newmark,
                    FixityMethod::elimination,
                    10.,
                    {},
                    Tensor<1, 2>({1., 2.}));
    unsigned int n_with_soil = 0;
    for (const unsigned int dof : step.fixities.removed_list())
      if (step.nodes.mass[dof / 2] > 0.)
        {
          ++n_with_soil;
          EXPECT_NEAR(step.nodes.new_velocity.begin()[dof],
                      dof % 2 == 0 ? 0.3 : -0.2,
                      1e-14);
          EXPECT_NEAR(step.nodes.new_acceleration.begin()[dof], 0., 1e-11);
        }
    EXPECT_GE(n_with_soil, 10u);
  }


  // In a ramp r of the unbalanced force: m a = r (f_ext - f_int) + F, with a =
  // 0.
  TEST(Mechanics, newmark_supports_carry_the_share_of_the_ramp)
  {
    const Step step(Scheme::newmark,
                    FixityMethod::elimination,
                    10.,
                    {},
                    Tensor<1, 2>({1., 2.}));
    double     work = 0.;
    for (const unsigned int dof : step.fixities.removed_list())
      work += 0.25 *
              (step.nodes.internal_force.begin()[dof] -
               step.nodes.external_force.begin()[dof]) *
              (dof % 2 == 0 ? 0.3 : -0.2) * dt;
    EXPECT_GT(std::abs(work), 1e-4);
    EXPECT_NEAR(step.report.support_work, work, 1e-12);
  }


  // A block at rest on a base that begins to move. With Newmark up to 1.2e-3 of
  // the work of the base are left over, since strains are those of mid-step; it
  // was half of it.
  TEST(Mechanics, the_account_closes_where_supports_push)
  {
    for (const Scheme scheme : {Scheme::newmark, Scheme::quasi_static})
      for (const FixityMethod method :
           {FixityMethod::elimination, FixityMethod::penalty})
        {
          const double  g = scheme == Scheme::newmark ? 0. : 10.;
          Step          step(scheme, method, g, {}, {});
          EnergyAccount account;
          account += step.report;
          for (unsigned int k = 1; k < 10; ++k)
            {
              step.weights.reinit(step.points);
              to_nodes(step.points, step.weights, step.nodes);
              set_gravity<2>(g, step.nodes);
              step.take(k * dt);
              account += step.report;
            }
          SCOPED_TRACE(std::string(name_of(scheme)) + ", " + name_of(method));
          EXPECT_GT(std::abs(account.support_work), 0.1);
          EXPECT_NEAR(account.remainder() / account.support_work, 0., 4e-3);
        }
  }


  // Without weight and stress there are no other forces to compare with.
  TEST(Mechanics, newton_knows_the_forces_of_springs_alone)
  {
    for (const double v : {0., 0.02})
      {
        const Step step(Scheme::newmark,
                        FixityMethod::penalty,
                        0.,
                        Tensor<1, 2>({v, 0.}),
                        {});
        EXPECT_GE(step.report.newton_iterations, 1u);
        EXPECT_GT(step.report.kinetic_energy, 1e-4);
      }
  }


  // What moves with its base is not strained.
  TEST(Mechanics, explicit_supports_carry_a_body_along)
  {
    const Step step(Scheme::explicit_steps,
                    FixityMethod::elimination,
                    0.,
                    Tensor<1, 2>({0.3, -0.2}),
                    {});
    for (std::size_t p = 0; p < step.points.n_points(); ++p)
      {
        EXPECT_LT((step.points.velocity[p] - Tensor<1, 2>({0.3, -0.2})).norm(),
                  1e-14);
        EXPECT_LT(step.points.stress[p].norm(), 1e-10);
      }
    const Step still(
      Scheme::explicit_steps, FixityMethod::elimination, 0., {}, {});
    double largest = 0.;
    for (const auto &stress : still.points.stress)
      largest = std::max(largest, stress.norm());
    EXPECT_GT(largest, 1.); // the base goes without it
  }


  // A penalty takes part in the step as it is at its end: m a = f_ext - k (u -
  // g).
  TEST(Mechanics, explicit_penalties_are_in_balance_at_the_end_of_the_step)
  {
    const Step   step(Scheme::explicit_steps,
                    FixityMethod::penalty,
                    10.,
                    Tensor<1, 2>({0.1, 0.4}),
                    {});
    unsigned int n_with_soil = 0;
    for (const auto &penalty : step.fixities.penalties())
      {
        const double mass = step.nodes.mass[penalty.dof / 2];
        if (mass == 0.)
          continue;
        ++n_with_soil;
        const double k = penalty.factor * 1000. * 0.7 / (1.3 * 0.4); // M, in 2D
        const double g = (penalty.dof % 2 == 0 ? 0.3 : -0.2) * dt;
        const double u = step.nodes.increment.begin()[penalty.dof];
        const double f = step.nodes.external_force.begin()[penalty.dof];
        EXPECT_NEAR(mass * step.nodes.new_acceleration.begin()[penalty.dof],
                    f - k * (u - g),
                    1e-10);
      }
    EXPECT_GE(n_with_soil, 10u);
  }
} // namespace mechanics_supports
