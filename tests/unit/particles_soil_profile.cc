// SPDX-License-Identifier: LGPL-2.1-or-later
#include "soil_profiles.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

namespace particles_soil_profile
{
  using namespace Waker;
  using namespace SoilProfiles;

  namespace
  {
    template <int dim>
    double
    total(const MaterialPoints<dim> &points, const std::vector<double> &values)
    {
      double sum = 0.;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        sum += values[p];
      return sum;
    }

    template <int dim>
    Tensor<1, dim>
    first_moment(const MaterialPoints<dim> &points)
    {
      Tensor<1, dim> sum;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        sum += points.volume[p] * (points.position[p] - Point<dim>());
      return sum;
    }

    /// First moment of a polygon, by the formula of the surveyor.
    Tensor<1, 2>
    first_moment(const Polygon &c)
    {
      Tensor<1, 2> sum;
      for (std::size_t i = 0; i < c.size(); ++i)
        {
          const auto  &a     = c[i];
          const auto  &b     = c[(i + 1) % c.size()];
          const double cross = a[0] * b[1] - a[1] * b[0];
          for (unsigned int d = 0; d < 2; ++d)
            sum[d] += (a[d] + b[d]) * cross / 6.;
        }
      return sum;
    }

    std::string
    polygon_text(const Polygon &corners)
    {
      std::ostringstream s;
      s.precision(17);
      for (const auto &c : corners)
        s << c[0] << ", " << c[1] << "; ";
      return s.str();
    }

  } // namespace


  TEST(Particles, dyke_of_chapter_5)
  {
    const auto grid   = dyke_grid();
    const auto points = make(grid, {layer(dyke)});
    EXPECT_EQ(points.n_points(), 6440u);
    EXPECT_NEAR(total(points, points.volume), 100., 1e-10);
    EXPECT_NEAR(total(points, points.mass), 100. * 15. / 9.81, 1e-10);
    EXPECT_NEAR(profile_volume(grid, {layer(dyke)}), 100., 1e-12);

    // Without merging, one sliver more in each of the 40 rows.
    EXPECT_EQ(make(grid, {layer(dyke)}, 0.).n_points(), 6480u);

    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        ASSERT_EQ(points.id[p], p);
        ASSERT_GE(points.volume[p], 0.25 * 0.125 * 0.125);
        ASSERT_LE(points.volume[p], 1.2 * 0.125 * 0.125);
        ASSERT_EQ(points.position[p], points.initial_position[p]);
        ASSERT_EQ(points.half_size[p][0], 0.0625);
        ASSERT_EQ(points.half_size[p][1], 0.0625);
        ASSERT_EQ(points.velocity[p].norm(), 0.);
        ASSERT_EQ(points.acceleration[p].norm(), 0.);
        ASSERT_EQ(points.stress[p].norm(), 0.);
      }
    EXPECT_TRUE(points.scalars.empty());
  }


  TEST(Particles, slivers_go_to_the_fullest_neighbour)
  {
    const auto grid = dyke_grid();
    // On the inner slope (1:3) the 1/6 above a full sub-cell joins that one.
    const auto  points = make(grid, {layer(dyke)});
    std::size_t larger = 0;
    for (const double v : points.volume)
      if (std::abs(v / (0.125 * 0.125) - 7. / 6.) < 1e-9)
        ++larger;
    EXPECT_EQ(larger, 39u); // in the lowest row there is none below: 1/2 + 1/6
  }


  TEST(Particles, order_is_cells_then_sub_cells)
  {
    const BackgroundGrid<2> grid(Point<2>(0., 0.),
                                 Point<2>(3., 2.),
                                 1.,
                                 MPI_COMM_SELF);
    const auto              points = make(grid, {layer("0,0; 3,0; 3,2; 0,2")});
    ASSERT_EQ(points.n_points(), 24u);
    const std::vector<Point<2>> start = {Point<2>(.25, .25),
                                         Point<2>(.75, .25),
                                         Point<2>(.25, .75),
                                         Point<2>(.75, .75),
                                         Point<2>(1.25, .25)};
    for (unsigned int p = 0; p < start.size(); ++p)
      EXPECT_LT(points.position[p].distance(start[p]), 1e-14);
    EXPECT_LT(points.position[12].distance(Point<2>(.25, 1.25)), 1e-14);
  }


  TEST(Particles, random_polygons_keep_volume_and_moment)
  {
    const BackgroundGrid<2>                grid(Point<2>(-3., 1.),
                                 Point<2>(7., 11.),
                                 0.5,
                                 MPI_COMM_SELF);
    std::mt19937                           random(4);
    std::uniform_real_distribution<double> uniform(0., 1.);
    unsigned int                           non_convex = 0;
    for (unsigned int k = 0; k < 200; ++k)
      {
        // A star: simple, seldom convex, with corners on the lattice at times.
        const unsigned int n = 3 + k % 20;
        Polygon            corners;
        for (unsigned int i = 0; i < n; ++i)
          {
            const double a = 2. * M_PI * (i + 0.8 * uniform(random)) / n;
            const double r = 0.3 + 4.6 * uniform(random);
            corners.push_back({{2. + r * std::cos(a), 6. + r * std::sin(a)}});
            if (k % 3 == 0)
              for (double &x : corners.back())
                x = std::round(4. * x) / 4.;
          }
        if (k % 2)
          std::reverse(corners.begin(), corners.end());
        LayerParameters l = layer(polygon_text(corners));
        Polygon         simple;
        try
          {
            simple = l.corners();
          }
        catch (const UserError &)
          {
            continue; // rounding has made corners meet
          }
        for (std::size_t i = 0; i < simple.size(); ++i)
          if (signed_area({simple[i],
                           simple[(i + 1) % simple.size()],
                           simple[(i + 2) % simple.size()]}) < 0.)
            {
              ++non_convex;
              break;
            }
        const double       area   = signed_area(simple);
        const Tensor<1, 2> moment = first_moment(simple);
        ASSERT_GT(area, 0.);
        for (const double minimum_cut : {0., 0.25, 0.5})
          {
            const auto points = make(grid, {l}, minimum_cut, 1 + k % 3);
            ASSERT_NEAR(total(points, points.volume), area, 1e-12 * area);
            ASSERT_LT((first_moment(points) - moment).norm(), 1e-11 * area)
              << l.polygon;
          }
      }
    EXPECT_GT(non_convex, 100u);
  }


  TEST(Particles, mirrored_dyke_has_mirrored_points)
  {
    const auto points = make(dyke_grid(), {layer(dyke)});
    const auto mirror =
      make(dyke_grid(-42., 6.), {layer("0,0; -30,0; -15,5; -5,5")});
    ASSERT_EQ(points.n_points(), mirror.n_points());
    const auto sorted = [](const MaterialPoints<2> &p, const double sign) {
      std::vector<std::array<long, 3>> rows;
      for (std::size_t i = 0; i < p.n_points(); ++i)
        rows.push_back({{std::lround(1e9 * p.position[i][1]),
                         std::lround(1e9 * sign * p.position[i][0]),
                         std::lround(1e12 * p.volume[i])}});
      std::sort(rows.begin(), rows.end());
      return rows;
    };
    const auto a = sorted(points, 1.), b = sorted(mirror, -1.);
    for (std::size_t i = 0; i < a.size(); ++i)
      for (unsigned int k = 0; k < 3; ++k)
        ASSERT_NEAR(a[i][k], b[i][k], 1);
  }


  TEST(Particles, layers_have_material_and_velocity)
  {
    const auto      grid         = dyke_grid();
    LayerParameters upper        = layer("0,1; 10,1.7; 10,3; 0,3", "sand");
    upper.velocity               = "1; -2";
    const LayerParameters lower  = layer("10,0; 10,1.7; 0,1; 0,0");
    const auto            points = make(grid, {upper, lower});
    double                clay = 0., sand = 0.;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const bool is_sand = points.material[p] == 1;
        (is_sand ? sand : clay) += points.volume[p];
        EXPECT_NEAR(points.mass[p],
                    points.volume[p] * densities[points.material[p]],
                    1e-15);
        EXPECT_EQ(points.velocity[p][1], is_sand ? -2. : 0.);
        if (p > 0) // both layers in one order
          {
            const auto a = grid.cell_index(points.position[p - 1]);
            const auto b = grid.cell_index(points.position[p]);
            EXPECT_LE(a[1], b[1] + 1); // a merged point may lie beyond its cell
          }
      }
    EXPECT_NEAR(clay, 13.5, 1e-11);
    EXPECT_NEAR(sand, 16.5, 1e-11);
  }


  TEST(Particles, velocity_follows_its_expressions)
  {
    const auto      grid = dyke_grid();
    LayerParameters l    = layer(dyke);
    l.velocity           = "0.1*sin(pi*x/50); -y^2 + min(x, 1)";
    const auto points    = make(grid, {l});
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const Point<2> x = points.position[p];
        ASSERT_DOUBLE_EQ(points.velocity[p][0],
                         0.1 * std::sin(numbers::PI * x[0] / 50.));
        ASSERT_DOUBLE_EQ(points.velocity[p][1],
                         -x[1] * x[1] + std::min(x[0], 1.));
      }

    const BackgroundGrid<3> block(Point<3>(0., 0., 0.),
                                  Point<3>(2., 2., 2.),
                                  1.,
                                  MPI_COMM_SELF);
    l            = layer("0,0; 2,0; 2,2; 0,2");
    l.velocity   = "z; 0; x*y";
    const auto q = make(block, {l});
    for (std::size_t p = 0; p < q.n_points(); ++p)
      {
        EXPECT_EQ(q.velocity[p][0], q.position[p][2]);
        EXPECT_EQ(q.velocity[p][1], 0.);
        EXPECT_EQ(q.velocity[p][2], q.position[p][0] * q.position[p][1]);
      }
  }


  TEST(Particles, extruded_slice_in_3d)
  {
    const BackgroundGrid<3> grid(Point<3>(-1., 0., -1.),
                                 Point<3>(7., 2., 2.),
                                 0.5,
                                 MPI_COMM_SELF);
    const BackgroundGrid<2> plane(Point<2>(-1., 0.),
                                  Point<2>(7., 2.),
                                  0.5,
                                  MPI_COMM_SELF);
    LayerParameters         l    = layer("0,0; 6,0; 3,1; 1,1");
    const auto              flat = make(plane, {l});

    // Over the whole grid: 12 slices like the plane one.
    auto points = make(grid, {l});
    EXPECT_EQ(points.n_points(), 12 * flat.n_points());
    EXPECT_NEAR(total(points, points.volume), 12., 1e-11);
    EXPECT_NEAR(profile_volume(grid, {l}), 12., 1e-12);
    for (std::size_t p = 1; p < points.n_points(); ++p)
      {
        const auto a = grid.cell_index(points.position[p - 1]);
        const auto b = grid.cell_index(points.position[p]);
        ASSERT_LE(a[2], b[2]);
      }

    // Slices cut by the extent: 0.6 of one at the lower end stays, 0.2 of one
    // at the upper end goes to its neighbour.
    l.extent = {0.1, 1.05};
    points   = make(grid, {l});
    EXPECT_NEAR(total(points, points.volume), 0.95 * 4., 1e-11);
    const Tensor<1, 2> moment = first_moment(l.corners());
    const auto         actual = first_moment(points);
    EXPECT_NEAR(actual[0], 0.95 * moment[0], 1e-11);
    EXPECT_NEAR(actual[1], 0.95 * moment[1], 1e-11);
    EXPECT_NEAR(actual[2], 0.95 * 4. * 0.575, 1e-11);
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        ASSERT_GT(points.volume[p], 0.25 * 0.25 * 0.25 * 0.25 - 1e-12);
        ASSERT_LT(points.position[p][2], 1.);
        ASSERT_EQ(points.half_size[p][2], 0.125);
      }

    // One thin slice keeps all its volume.
    l.extent = {0.1, 0.12};
    points   = make(grid, {l});
    EXPECT_EQ(points.n_points(), flat.n_points());
    EXPECT_NEAR(total(points, points.volume), 0.02 * 4., 1e-12);

    // Layers above each other along z do not overlap.
    LayerParameters next = l;
    next.extent          = {0.12, 1.};
    EXPECT_EQ(where_it_fails(grid, {l, next}), "");
    next.extent = {0.11, 1.};
    EXPECT_EQ(where_it_fails(grid, {l, next}), "Soil profile/layer/Polygon");
  }
} // namespace particles_soil_profile
