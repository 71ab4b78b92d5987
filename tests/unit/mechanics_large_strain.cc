// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/transfer.h>
#include <waker/materials/linear_elastic.h>
#include <waker/mechanics/deformation.h>
#include <waker/mechanics/energy.h>
#include <waker/mechanics/time_scheme.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>

namespace mechanics_large_strain
{
  // Logarithmic strain and stretched domains in the time schemes: the balance
  // of energy, and how Newton converges.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.25, density = 1.5, E = 1000.;


    /// A block of 1 m (0.5 m in 3D), on a fixed base or free.
    template <int dim>
    struct Block
    {
      Block(const TimeParameters &time,
            const double          gravity,
            const bool            on_base,
            const double          tolerance = 1e-10)
        : time(time)
        , gravity(gravity)
        , grid(Lattice::grid<dim>(2., h))
        , fixities(grid,
                   on_base ? std::vector<FixityParameters>(1)
                           : std::vector<FixityParameters>())
        , weights(grid, ShapeFunctions::gimp)
        , nodes(grid)
      {
        Point<dim> lower;
        for (unsigned int d = 0; d < dim; ++d)
          lower[d] = d == 1 && on_base ? 0. : 0.5;
        points = Lattice::box(lower, dim == 2 ? 8 : 4, 0.5 * h, density);
        prepare_domains(SupportDomains::stretched, points);
        materials.push_back(std::make_unique<LinearElastic>(density, E, 0.3));
        newton.tolerance                 = tolerance;
        newton.linear_tolerance          = 1e-6;
        newton.maximum_linear_iterations = 3000;
        mapping.strain                   = StrainMeasure::logarithmic;
        scheme = make_time_scheme(SchemeInput<dim>{grid,
                                                   weights,
                                                   materials,
                                                   fixities,
                                                   this->time,
                                                   newton,
                                                   mapping,
                                                   gravity,
                                                   density * std::pow(h, dim)});
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
        EXPECT_EQ(move_domains(SupportDomains::stretched, h, points), 0u);
        account.kinetic = report.kinetic_energy;
        account.elastic = report.elastic_energy;
        account.gravity_work += report.gravity_work;
        account.load_work += report.load_work;
        account.support_work += report.support_work;
        account.mapping_loss += report.mapping_loss;
        return report;
      }

      TimeParameters                   time;
      double                           gravity;
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


    /// Pressed down by a fifth of its height, in so many steps: the account.
    template <int dim>
    EnergyAccount
    press(const unsigned int n_steps)
    {
      TimeParameters time;
      time.scheme        = Scheme::quasi_static;
      time.load_duration = 1.;
      Block<dim> block(time, 200. * (dim == 2 ? 1. : 2.), true);
      double     mass = 0.;
      for (const double m : block.points.mass)
        mass += m;
      for (unsigned int k = 0; k < n_steps; ++k)
        {
          const auto report = block.step(1. * k / n_steps, 1. / n_steps);
          EXPECT_LT(report.newton_iterations, 8u);
          EXPECT_NEAR(report.reaction[1] / (mass * block.gravity),
                      (k + 1.) / n_steps,
                      1e-6);
        }
      double smallest = 1.;
      for (const auto &F : block.points.deformation)
        smallest = std::min(smallest, F[1][1]);
      EXPECT_LT(smallest, 0.85); // large
      return block.account;
    }


    template <int dim>
    void
    check_pressed()
    {
      const EnergyAccount coarse = press<dim>(5), fine = press<dim>(20);
      EXPECT_GT(fine.elastic, 1.);
      EXPECT_LT(std::abs(fine.mapping_loss), 0.02 * fine.gravity_work);
      // The means of the forces at both ends of a step: second order.
      EXPECT_LT(std::abs(fine.remainder()), 1e-3 * fine.elastic);
      EXPECT_LT(std::abs(fine.remainder()),
                0.15 * std::abs(coarse.remainder()));
    }


    TEST(LargeStrain, QuasiStaticEnergyIsBalanced)
    {
      check_pressed<2>();
      check_pressed<3>();
    }


    /// A body in free flight that stretches by a tenth and swings: Newmark.
    TEST(LargeStrain, NewmarkEnergyAndMomentum)
    {
      TimeParameters time;
      time.ramp_duration = 0.;
      Block<2>           block(time, 0., false, 1e-9);
      const Point<2>     centre(1., 1.);
      const Tensor<1, 2> drift({0.3, 0.2});
      MaterialPoints<2> &points = block.points;
      const double       speed  = 2.5; // m/s per m
      for (unsigned int p = 0; p < points.n_points(); ++p)
        {
          const Tensor<1, 2> x  = points.position[p] - centre;
          points.velocity[p][0] = speed * x[0] - speed * x[1];
          points.velocity[p][1] = speed * x[0] - speed * x[1];
          points.velocity[p] += drift;
        }
      block.account.kinetic_start  = kinetic_energy(points);
      const Tensor<1, 2> momentum0 = momentum(points);
      double             largest   = 0.;
      for (unsigned int k = 0; k < 60; ++k)
        {
          block.step(0.002 * k, 0.002);
          largest = std::max(largest, block.account.elastic);
        }
      const EnergyAccount &account = block.account;
      EXPECT_GT(largest, 0.2 * account.kinetic_start);
      EXPECT_LT(std::abs(account.remainder()), 5e-3 * account.kinetic_start);
      EXPECT_LT((momentum(points) - momentum0).norm(), 1e-6 * momentum0.norm());
    }
  } // namespace
} // namespace mechanics_large_strain
