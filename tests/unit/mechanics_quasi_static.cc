// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/transfer.h>
#include <waker/materials/linear_elastic.h>
#include <waker/mechanics/energy.h>
#include <waker/mechanics/time_scheme.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>

namespace mechanics_quasi_static
{
  // The quasi-static scheme: load steps without inertia.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.25, density = 1.5, gravity = 10.;


    /// A block of 1 m (0.5 m in 3D) on a fixed base, loaded by its weight.
    template <int dim>
    struct Block
    {
      explicit Block(const TimeParameters &time)
        : time(time)
        , grid(Lattice::grid<dim>(2., h))
        , fixities(grid, {FixityParameters()})
        , weights(grid, ShapeFunctions::gimp)
        , nodes(grid)
      {
        Point<dim> lower;
        lower[0] = 0.43;
        points   = Lattice::box(lower, dim == 2 ? 8 : 4, 0.5 * h, density);
        materials.push_back(
          std::make_unique<LinearElastic>(density, 1000., 0.3));
        newton.tolerance                 = 1e-10;
        newton.linear_tolerance          = 1e-6;
        newton.maximum_linear_iterations = 3000;
        mapping.objective_rate           = false;
        scheme =
          make_quasi_static(SchemeInput<dim>{grid,
                                             weights,
                                             materials,
                                             fixities,
                                             this->time,
                                             newton,
                                             mapping,
                                             gravity,
                                             density * std::pow(h, dim)});
        account.elastic_start = 0.;
      }

      StepReport<dim>
      step(const double t, const double dt)
      {
        weights.reinit(points);
        to_nodes(points, weights, nodes);
        set_gravity<dim>(gravity, nodes);
        StepReport<dim> report = scheme->solve(points, t, dt, nodes);
        EXPECT_TRUE(report.converged);
        scheme->to_points(t, dt, nodes, points, report);
        account.elastic = report.elastic_energy;
        account.gravity_work += report.gravity_work;
        account.load_work += report.load_work;
        account.support_work += report.support_work;
        account.mapping_loss += report.mapping_loss;
        return report;
      }

      double
      weight() const
      {
        double sum = 0.;
        for (const double mass : points.mass)
          sum += mass * gravity;
        return sum;
      }

      TimeParameters                   time;
      NewtonParameters                 newton;
      MappingParameters                mapping;
      BackgroundGrid<dim>              grid;
      Fixities<dim>                    fixities;
      Weights<dim>                     weights;
      NodalState                       nodes;
      Materials                        materials;
      MaterialPoints<dim>              points;
      EnergyAccount                    account;
      std::unique_ptr<TimeScheme<dim>> scheme;
    };


    /// Points that stay in place: four load steps give what one gives.
    template <int dim>
    void
    check_proportional()
    {
      TimeParameters time;
      time.move_points     = false;
      time.ghost_stiffness = 0.; // it has no memory
      time.load_duration   = 2.;
      Block<dim> stepwise(time), at_once(time);
      for (unsigned int k = 0; k < 4; ++k)
        {
          const auto report = stepwise.step(0.5 * k, 0.5);
          EXPECT_NEAR(report.reaction[1] / stepwise.weight(),
                      0.25 * (k + 1),
                      1e-7);
        }
      stepwise.step(2., 0.5); // no more load: nothing happens
      const auto report = at_once.step(0., 2.);
      EXPECT_NEAR(report.reaction[0], 0., 1e-7 * at_once.weight());

      double largest = 0.;
      for (const auto &stress : at_once.points.stress)
        largest = std::max(largest, stress.norm());
      EXPECT_GT(largest, 0.3 * density * gravity);
      for (unsigned int p = 0; p < at_once.points.n_points(); ++p)
        {
          EXPECT_LT(
            (stepwise.points.stress[p] - at_once.points.stress[p]).norm(),
            1e-6 * largest);
          EXPECT_EQ(at_once.points.position[p],
                    at_once.points.initial_position[p]);
          EXPECT_EQ(at_once.points.velocity[p].norm(), 0.);
        }
      // Linear: half of force times displacement, whatever the steps. Without
      // an objective rate the balance is exact.
      EXPECT_NEAR(at_once.account.elastic,
                  at_once.account.gravity_work,
                  1e-6 * at_once.account.elastic);
      EXPECT_NEAR(stepwise.account.elastic,
                  at_once.account.elastic,
                  1e-6 * at_once.account.elastic);
      EXPECT_NEAR(stepwise.account.gravity_work,
                  at_once.account.gravity_work,
                  1e-6 * at_once.account.elastic);

      // A body without stress has carried no load, also if none is to grow.
      time.load_duration = 0.;
      Block<dim> suddenly(time);
      suddenly.step(0., 1.);
      EXPECT_NEAR(suddenly.account.gravity_work,
                  at_once.account.elastic,
                  1e-6 * at_once.account.elastic);
      EXPECT_NEAR(suddenly.account.elastic,
                  at_once.account.elastic,
                  1e-6 * at_once.account.elastic);
    }


    TEST(QuasiStatic, ProportionalLoads)
    {
      check_proportional<2>();
      check_proportional<3>();
    }


    TEST(QuasiStatic, PointsMoveAndEnergyIsBalanced)
    {
      TimeParameters time;
      time.load_duration = 1.;
      Block<2> block(time);
      double   last = 1.;
      for (unsigned int k = 0; k < 10; ++k)
        {
          const auto report = block.step(0.1 * k, 0.1);
          EXPECT_EQ(report.kinetic_energy, 0.);
          EXPECT_NEAR(report.reaction[1] / block.weight(), 0.1 * (k + 1), 1e-7);
          EXPECT_LT(report.newton_iterations, 6u);
          last = report.displacement_rate;
        }
      EXPECT_GT(last, 0.);
      double settled = 0.;
      for (unsigned int p = 0; p < block.points.n_points(); ++p)
        settled = std::min(settled,
                           block.points.position[p][1] -
                             block.points.initial_position[p][1]);
      // rho g H^2 / 2E' of a column that cannot or can spread sideways.
      EXPECT_LT(settled, -0.0050);
      EXPECT_GT(settled, -0.0080);
      const EnergyAccount &account = block.account;
      EXPECT_NEAR(account.load_work, 0., 1e-12 * account.gravity_work);
      EXPECT_GT(account.gravity_work, 0.9 * account.elastic);
      EXPECT_NEAR(account.remainder(), 0., 1e-8 * account.gravity_work);
      EXPECT_LT(std::abs(account.mapping_loss), 0.02 * account.gravity_work);
    }
  } // namespace
} // namespace mechanics_quasi_static
