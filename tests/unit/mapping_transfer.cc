// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/transfer.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>

namespace mapping_transfer
{
  using namespace Waker;

  namespace
  {
    constexpr double h = 0.25;


    /// Points all over the grid, with random mass, velocity, acceleration.
    template <int dim>
    MaterialPoints<dim>
    random_points(Lattice::Random &random)
    {
      MaterialPoints<dim> points;
      for (unsigned int p = 0; p < 300; ++p)
        {
          Lattice::add_point(points,
                             Point<dim>(random.vector<dim>(0., 1.)),
                             random(0.5, 2.),
                             random(0.02, 0.12),
                             3.);
          points.velocity[p]     = random.vector<dim>(-2., 3.);
          points.acceleration[p] = random.vector<dim>(-5., 4.);
        }
      return points;
    }


    template <int dim>
    NodalVector
    random_field(const BackgroundGrid<dim> &grid, Lattice::Random &random)
    {
      NodalVector u(grid.n_dofs());
      for (double &entry : u)
        entry = random(-1., 1.);
      return u;
    }


    template <int dim>
    void
    check_conservation(const ShapeFunctions functions)
    {
      Lattice::Random    random(11);
      const auto         grid   = Lattice::grid<dim>(1., h);
      auto               points = random_points<dim>(random);
      const auto         before = points;
      const Stencil<dim> stencil(grid);
      NodalState         nodes(grid);
      Weights<dim>       weights(grid, functions);
      weights.reinit(points);

      // What an earlier step has left must not matter.
      nodes.velocity.begin()[3] = nodes.acceleration.begin()[5] = 1e6;
      nodes.mass[7]                                             = 1e6;
      to_nodes(points, weights, nodes);

      double         point_mass = 0., node_mass = 0.;
      Tensor<1, dim> point_momentum, node_momentum, point_rate, node_rate,
        point_moment, node_moment;
      for (unsigned int p = 0; p < points.n_points(); ++p)
        {
          const double m = points.mass[p];
          point_mass += m;
          point_momentum += m * points.velocity[p];
          point_rate += m * points.acceleration[p];
          point_moment += m * points.position[p];
        }
      for (unsigned int i = 0; i < grid.n_nodes(); ++i)
        {
          node_mass += nodes.mass[i];
          node_moment += nodes.mass[i] * grid.node_position(i);
          for (unsigned int c = 0; c < dim; ++c)
            {
              const double v = nodes.velocity.begin()[dim * i + c];
              const double a = nodes.acceleration.begin()[dim * i + c];
              node_momentum[c] += nodes.mass[i] * v;
              node_rate[c] += nodes.mass[i] * a;
              EXPECT_TRUE(nodes.mass[i] > 0. || (v == 0. && a == 0.));
            }
        }
      const double tolerance = 1e-12 * point_mass;
      EXPECT_NEAR(node_mass, point_mass, tolerance);
      EXPECT_LT((node_momentum - point_momentum).norm(), tolerance);
      EXPECT_LT((node_rate - point_rate).norm(), tolerance);
      EXPECT_LT((node_moment - point_moment).norm(), tolerance);

      set_gravity<dim>(9.81, nodes);
      Tensor<1, dim> weight, expected_weight;
      expected_weight[1] = -9.81 * point_mass;
      for (unsigned int i = 0; i < grid.n_dofs(); ++i)
        weight[i % dim] += nodes.external_force.begin()[i];
      EXPECT_LT((weight - expected_weight).norm(), 10. * tolerance);

      // And back: the increments of momentum and of the mass's moment.
      nodes.increment        = random_field(grid, random);
      nodes.new_acceleration = random_field(grid, random);
      Tensor<1, dim> moved, new_rate;
      for (unsigned int i = 0; i < grid.n_nodes(); ++i)
        for (unsigned int c = 0; c < dim; ++c)
          {
            moved[c] += nodes.mass[i] * nodes.increment.begin()[dim * i + c];
            new_rate[c] +=
              nodes.mass[i] * nodes.new_acceleration.begin()[dim * i + c];
          }
      const double         dt     = 0.03;
      const TransferReport report = to_particles(nodes, weights, dt, points);

      double         squares = 0., largest = 0.;
      Tensor<1, dim> momentum, rate, moment;
      for (unsigned int p = 0; p < points.n_points(); ++p)
        {
          const double         m  = points.mass[p];
          const Tensor<1, dim> du = points.position[p] - before.position[p];
          momentum += m * points.velocity[p];
          rate += m * points.acceleration[p];
          moment += m * du;
          squares += m * du.norm_square();
          largest = std::max(largest, du.norm());
        }
      EXPECT_LT((moment - moved).norm(), tolerance);
      EXPECT_LT((rate - new_rate).norm(), tolerance);
      EXPECT_LT(
        (momentum - point_momentum - 0.5 * dt * (point_rate + new_rate)).norm(),
        tolerance);
      EXPECT_NEAR(report.mass, point_mass, tolerance);
      EXPECT_NEAR(report.squared_displacement, squares, tolerance);
      EXPECT_NEAR(report.largest_displacement, largest, 1e-13);
    }


    /// The factorised loops against plain sums over the nodes.
    template <int dim>
    void
    check_stencil(const ShapeFunctions functions)
    {
      Lattice::Random    random(12);
      const auto         grid   = Lattice::grid<dim>(1., h);
      const auto         points = random_points<dim>(random);
      const NodalVector  u      = random_field(grid, random);
      const Stencil<dim> stencil(grid);
      Weights<dim>       weights(grid, functions);
      weights.reinit(points);
      for (unsigned int p = 0; p < points.n_points(); ++p)
        {
          const Tensor<1, dim> f = random.vector<dim>(-1., 1.);
          const Tensor<2, dim> P = random.matrix<dim>(-1., 1.);
          Tensor<1, dim>       value;
          Tensor<2, dim>       gradient;
          NodalVector          forces(grid.n_dofs()), stresses(grid.n_dofs());
          stencil.for_each_node(
            weights[p],
            [&](const unsigned int node, const double S, const auto &slope) {
              const Tensor<1, dim> divergence = P * slope;
              for (unsigned int c = 0; c < dim; ++c)
                {
                  const double ui = u.begin()[dim * node + c];
                  value[c] += S * ui;
                  gradient[c] += ui * slope;
                  forces.begin()[dim * node + c] += S * f[c];
                  stresses.begin()[dim * node + c] += divergence[c];
                }
            });
          ASSERT_LT((stencil.value(weights[p], u.begin()) - value).norm(),
                    1e-13);
          ASSERT_LT((stencil.gradient(weights[p], u.begin()) - gradient).norm(),
                    1e-12);
          NodalVector scattered(grid.n_dofs());
          stencil.scatter_value(weights[p], f, scattered.begin());
          scattered -= forces;
          ASSERT_LT(scattered.linfty_norm(), 1e-14);
          scattered = 0.;
          stencil.scatter_gradient(weights[p], P, scattered.begin());
          scattered -= stresses;
          ASSERT_LT(scattered.linfty_norm(), 1e-13);
        }
    }
  } // namespace


  TEST(Mapping, mass_and_momentum_go_to_the_nodes_and_back)
  {
    for (const auto functions : {ShapeFunctions::linear, ShapeFunctions::gimp})
      {
        check_conservation<2>(functions);
        check_conservation<3>(functions);
      }
  }


  TEST(Mapping, factorised_sums_are_the_plain_ones)
  {
    for (const auto functions : {ShapeFunctions::linear, ShapeFunctions::gimp})
      {
        check_stencil<2>(functions);
        check_stencil<3>(functions);
      }
  }


  TEST(Mapping, a_node_moves_with_its_points)
  {
    // Eq. 2.31: mass-weighted means, for two points of unequal mass.
    const auto        grid = Lattice::grid<2>(1., h);
    MaterialPoints<2> points;
    Lattice::add_point(points, Point<2>(0.6, 0.5), 1., 0.05, 1.);
    Lattice::add_point(points, Point<2>(0.55, 0.5), 3., 0.05, 1.);
    points.velocity[0][0] = 8.;
    points.velocity[1][0] = -1.;
    Weights<2> weights(grid, ShapeFunctions::linear);
    NodalState nodes(grid);
    weights.reinit(points);
    to_nodes(points, weights, nodes);
    // Node (0.5, 0.5) has index (3, 3): N = 0.6 and 0.8.
    const unsigned int node = grid.node({{3, 3}});
    EXPECT_NEAR(nodes.mass[node], 0.6 + 2.4, 1e-14);
    EXPECT_NEAR(nodes.velocity.begin()[2 * node],
                (0.6 * 8. - 2.4 * 1.) / 3.,
                1e-14);
  }
} // namespace mapping_transfer
