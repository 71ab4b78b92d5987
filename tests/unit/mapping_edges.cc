// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/mapping/weights.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>

namespace mapping_edges
{
  // Where functions begin and end: touching cells, the outermost cells, and the
  // end of the grid.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.25;


    template <int dim>
    PointWeights<dim>
    weights_at(const BackgroundGrid<dim> &grid,
               const Point<dim>          &x,
               const double               l,
               const ShapeFunctions       functions)
    {
      MaterialPoints<dim> points;
      Lattice::add_point(points, x, 1., l);
      Weights<dim> weights(grid, functions);
      weights.reinit(points);
      return weights[0];
    }


    /// Nodes with a value or gradient that is not zero.
    template <int dim>
    unsigned int
    n_active(const BackgroundGrid<dim> &grid, const PointWeights<dim> &w)
    {
      unsigned int n = 0;
      Stencil<dim>(grid).for_each_node(
        w, [&](const unsigned int, const double S, const auto &gradient) {
          n += S != 0. || gradient.norm() != 0.;
        });
      return n;
    }


    template <int dim>
    bool
    throws(const Point<dim> &x, const double l, const ShapeFunctions functions)
    {
      const auto grid = Lattice::grid<dim>(1., h);
      try
        {
          weights_at(grid, x, l, functions);
        }
      catch (const NumericalFailure &)
        {
          return true;
        }
      return false;
    }
  } // namespace


  TEST(Mapping, touching_domains_wake_no_node)
  {
    // 2 x 2 points of a cell, 1e-13 off or exactly aligned: the four nodes of
    // the cell, and no other. 1e-9 off: the next ones count.
    const auto grid2 = Lattice::grid<2>(1., h);
    const auto grid3 = Lattice::grid<3>(1., h);
    for (const double shift : {0., 1e-13, -1e-13, 1e-9, -1e-9})
      for (const double x : {0.25, 0.75})
        for (const double y : {0.25, 0.75})
          {
            const double s     = h * shift;
            const bool   alone = std::abs(shift) < 1e-12;
            // At 0.25 h only a shift downwards leaves the cell.
            const bool         x_out = !alone && (shift < 0.) == (x < 0.5);
            const bool         y_out = !alone && (shift < 0.) == (y < 0.5);
            const unsigned int nx = x_out ? 3 : 2, ny = y_out ? 3 : 2;
            const Point<2>     q(0.25 + x * h + s, 0.5 + y * h + s);
            const auto w = weights_at(grid2, q, 0.25 * h, ShapeFunctions::gimp);
            EXPECT_EQ(n_active(grid2, w), nx * ny) << q << ' ' << shift;
            const Point<3> r(q[0], q[1], q[0]);
            EXPECT_EQ(
              n_active(grid3,
                       weights_at(grid3, r, 0.25 * h, ShapeFunctions::gimp)),
              nx * ny * nx)
              << r << ' ' << shift;
          }

    // One point per cell, as large as the cell.
    for (const double shift : {0., 1e-13, -1e-13})
      EXPECT_EQ(n_active(grid2,
                         weights_at(grid2,
                                    Point<2>(0.375 + h * shift, 0.625),
                                    0.5 * h,
                                    ShapeFunctions::gimp)),
                4u)
        << shift;

    // The same far from the origin, where round-off is larger.
    const BackgroundGrid<2> far(Point<2>(-6., 0.),
                                Point<2>(42., 6.),
                                h,
                                MPI_COMM_SELF);
    for (unsigned int i = 0; i < 192; ++i)
      for (const double x : {0.25, 0.75})
        EXPECT_EQ(n_active(far,
                           weights_at(far,
                                      Point<2>(-6. + (i + x) * h, 0.1875),
                                      0.25 * h,
                                      ShapeFunctions::gimp)),
                  4u)
          << i;
  }


  TEST(Mapping, the_outermost_cells_are_as_good_as_others)
  {
    const auto       grid = Lattice::grid<3>(1., h); // and margin: -h to 1 + h
    const Stencil<3> stencil(grid);
    Lattice::Random  random(3);
    for (unsigned int n = 0; n < 200; ++n)
      for (const auto functions :
           {ShapeFunctions::linear, ShapeFunctions::gimp})
        {
          Point<3> x;
          for (unsigned int d = 0; d < 3; ++d)
            x[d] = n >> d & 1 ? 1. + h * random(0.26, 0.74)
                              : -h * random(0.26, 0.74);
          const auto   w = weights_at(grid, x, 0.25 * h, functions);
          Tensor<1, 3> sum_x;
          Tensor<2, 3> sum_x_gradient;
          stencil.for_each_node(
            w,
            [&](const unsigned int node, const double S, const auto &gradient) {
              ASSERT_LT(node, grid.n_nodes());
              const Tensor<1, 3> y(grid.node_position(node));
              sum_x += S * y;
              sum_x_gradient += outer_product(y, gradient);
            });
          ASSERT_LT((sum_x - Tensor<1, 3>(x)).norm(), 1e-13);
          ASSERT_LT(
            (sum_x_gradient - Tensor<2, 3>(unit_symmetric_tensor<3>())).norm(),
            1e-12);
        }
  }


  TEST(Mapping, a_point_off_the_grid_is_a_numerical_failure)
  {
    const double nan = std::nan("");
    for (unsigned int d = 0; d < 3; ++d)
      for (const double x :
           {-h - 0.01, 1. + h + 0.01, -1e30, 1e30, nan, HUGE_VAL, -HUGE_VAL})
        for (const auto f : {ShapeFunctions::linear, ShapeFunctions::gimp})
          {
            Point<3> q(0.4, 0.4, 0.4);
            q[d] = x;
            EXPECT_TRUE(throws(q, 0.05, f)) << q;
            if (d < 2)
              {
                Point<2> r(0.4, 0.4);
                r[d] = x;
                EXPECT_TRUE(throws(r, 0.05, f)) << r;
              }
          }
    // Inside, but its support domain is not.
    const Point<2> edge(1. + h - 0.01, 0.4);
    EXPECT_FALSE(throws(edge, 0.05, ShapeFunctions::linear));
    EXPECT_TRUE(throws(edge, 0.05, ShapeFunctions::gimp));
    EXPECT_FALSE(throws(edge, 0.01, ShapeFunctions::gimp));
    EXPECT_TRUE(throws(Point<2>(0.4, -h + 0.01), 0.05, ShapeFunctions::gimp));
  }
} // namespace mapping_edges
