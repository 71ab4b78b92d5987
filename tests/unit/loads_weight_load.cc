// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/loads/weight_load.h>
#include <waker/mapping/transfer.h>
#include <waker/particles/soil_profile.h>

#include "user_errors.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace loads_weight_load
{
  // Weight of points: whose, how much, and what the nodes get.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.5; // m

    template <int dim>
    BackgroundGrid<dim>
    box()
    {
      Point<dim> lower, upper;
      for (unsigned int d = 0; d < dim; ++d)
        upper[d] = 4.;
      return BackgroundGrid<dim>(lower, upper, h, MPI_COMM_SELF);
    }


    /// A slope of 45 degrees, 2 m high, with a crest from x = 0 to 2 m; in 3D
    /// from z = 0 to 4 m.
    template <int dim>
    MaterialPoints<dim>
    slope()
    {
      LayerParameters layer;
      layer.name     = "slope";
      layer.material = "clay";
      layer.polygon  = "0, 0; 4, 0; 2, 2; 0, 2";
      return make_material_points(box<dim>(), {layer}, {}, {"clay"}, {2.});
    }


    WeightLoadParameters
    rectangle(const std::vector<double> &from, const std::vector<double> &to)
    {
      WeightLoadParameters p;
      p.from        = from;
      p.to          = to;
      p.unit_weight = 18.;
      return p;
    }


    template <int dim>
    std::vector<double>
    weights_of(WeightLoadParameters       p,
               const LoadedPoints         which,
               const MaterialPoints<dim> &points)
    {
      p.points = which;
      return weight_per_metre(p, "Load programmes/soil/", h, points);
    }


    double
    sum(const std::vector<double> &values)
    {
      return std::accumulate(values.begin(), values.end(), 0.);
    }


    /// Moment about the x-y origin along z, per unit of weight: mean x.
    template <int dim>
    double
    mean(const std::vector<double> &weight,
         const MaterialPoints<dim> &points,
         const unsigned int         d)
    {
      double moment = 0.;
      for (std::size_t p = 0; p < weight.size(); ++p)
        moment += weight[p] * points.position[p][d];
      return moment / sum(weight);
    }
  } // namespace


  TEST(Loads, weight_of_a_rectangle_is_unit_weight_times_area)
  {
    const MaterialPoints<2> points = slope<2>();
    // Points of 0.25 m: along them, across them, within one, the whole crest.
    const std::vector<std::pair<double, double>> strips = {{0.5, 1.},
                                                           {0.6, 1.45},
                                                           {1.05, 1.15},
                                                           {0., 2.}};
    for (const auto &[a, b] : strips)
      for (const LoadedPoints which : {LoadedPoints::top, LoadedPoints::column})
        {
          SCOPED_TRACE(std::to_string(a) + " " + name_of(which));
          const std::vector<double> weight =
            weights_of(rectangle({a}, {b}), which, points);
          EXPECT_NEAR(sum(weight), 18. * (b - a), 1e-12);
          std::size_t n_loaded = 0;
          for (std::size_t p = 0; p < weight.size(); ++p)
            if (weight[p] > 0.)
              {
                ++n_loaded;
                const bool over = points.position[p][0] + 0.125 > a &&
                                  points.position[p][0] - 0.125 < b;
                EXPECT_TRUE(over);
                if (which == LoadedPoints::top)
                  {
                    EXPECT_NEAR(points.position[p][1], 1.875, 1e-12);
                  }
              }
          EXPECT_GE(n_loaded, which == LoadedPoints::top ? 1u : 8u);
        }

    // A point that lies half below the rectangle carries half.
    const std::vector<double> half =
      weights_of(rectangle({0.375}, {0.5}), LoadedPoints::top, points);
    EXPECT_NEAR(*std::max_element(half.begin(), half.end()),
                18. * 0.125,
                1e-12);

    // Two columns of 8 equal points share it equally.
    const std::vector<double> column =
      weights_of(rectangle({0.5}, {1.}), LoadedPoints::column, points);
    std::size_t n_column = 0;
    for (const double weight : column)
      if (weight != 0.)
        {
          ++n_column;
          EXPECT_NEAR(weight, 18. * 0.5 / 16., 1e-12);
        }
    EXPECT_EQ(n_column, 16u); // 2 x 8
    EXPECT_NEAR(mean(column, points, 0), 0.75, 1e-12);
    EXPECT_NEAR(mean(column, points, 1), 1., 1e-12);
  }


  TEST(Loads, weight_of_a_rectangle_in_space)
  {
    const MaterialPoints<3> points = slope<3>();
    for (const LoadedPoints which : {LoadedPoints::top, LoadedPoints::column})
      {
        const std::vector<double> weight =
          weights_of(rectangle({0.6, 1.5}, {1.1, 2.5}), which, points);
        EXPECT_NEAR(sum(weight), 18. * 0.5 * 1., 1e-12);
        EXPECT_NEAR(mean(weight, points, 2), 2., 1e-12);
        double least = 4., largest = 0.;
        for (std::size_t p = 0; p < weight.size(); ++p)
          if (weight[p] > 0.)
            {
              least   = std::min(least, points.position[p][2]);
              largest = std::max(largest, points.position[p][2]);
            }
        EXPECT_NEAR(least, 1.625, 1e-12);
        EXPECT_NEAR(largest, 2.375, 1e-12);
      }
  }


  TEST(Loads, weight_acts_like_that_of_the_points)
  {
    const BackgroundGrid<2> grid   = box<2>();
    MaterialPoints<2>       points = slope<2>();
    // It follows the points wherever they go.
    for (Point<2> &x : points.position)
      x += Point<2>(0.07, 0.11);
    Weights<2> weights(grid, ShapeFunctions::gimp);
    weights.reinit(points);
    NodalState nodes(grid);
    to_nodes(points, weights, nodes);
    set_gravity<2>(9.81, nodes);
    NodalVector own(nodes.external_force);

    std::vector<double> weight(points.n_points());
    for (std::size_t p = 0; p < weight.size(); ++p)
      weight[p] = 9.81 * points.mass[p];
    NodalVector added(grid.n_dofs());
    add_weight(weight, 0.5, weights, added);
    add_weight(weight, 0., weights, added);
    add_weight(weight, 0.5, weights, added);
    EXPECT_GT(own.l2_norm(), 10.);
    own -= added;
    EXPECT_LT(own.linfty_norm(), 1e-12);
  }


  TEST(Loads, a_rectangle_off_the_crest_is_refused)
  {
    const MaterialPoints<2> points = slope<2>();
    const std::string       path   = "Load programmes/soil/From";
    for (const LoadedPoints which : {LoadedPoints::top, LoadedPoints::column})
      {
        const auto put = [&](const double a, const double b) {
          weights_of(rectangle({a}, {b}), which, points);
        };
        put(1.5, 2.);
        put(1.5, 2.4); // the slope falls by less than a cell
        EXPECT_USER_ERROR(put(1.5, 3.), path, "not level");
        EXPECT_USER_ERROR(put(3.5, 5.), path, "none at x = 4.");
        EXPECT_USER_ERROR(put(-0.5, 1.), path, "none at x = -0.25 m");
      }
    const MaterialPoints<3> space = slope<3>();
    EXPECT_USER_ERROR(weights_of(rectangle({1., 3.}, {2., 5.}),
                                 LoadedPoints::top,
                                 space),
                      path,
                      "z = 4.5 m");
    EXPECT_USER_ERROR(weights_of(rectangle({1.}, {2.}),
                                 LoadedPoints::top,
                                 MaterialPoints<2>()),
                      path,
                      "none at x = 1.5 m");
  }
} // namespace loads_weight_load
