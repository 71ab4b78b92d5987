// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/failure_record.h>
#include <waker/measures/moving_body.h>

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace measures_moving_body
{
  using namespace Waker;

  namespace
  {
    constexpr double h = 0.5; // cells; four (eight) points each

    /// A block from 0 to 10 m along x, 0 to 4 m in height, in 3D 0 to 6 m.
    template <int dim>
    struct Block
    {
      Block()
        : grid(corner(-2.), corner(12.), h, MPI_COMM_SELF)
      {
        const unsigned int nz = dim == 3 ? 24 : 1;
        points.resize(40 * 16 * nz);
        for (std::size_t q = 0; q < points.n_points(); ++q)
          {
            Point<dim> x;
            x[0] = 0.125 + 0.25 * (q % 40);
            x[1] = 0.125 + 0.25 * (q / 40 % 16);
            if (dim == 3)
              x[dim - 1] = 0.125 + 0.25 * (q / 640);
            points.position[q] = points.initial_position[q] = x;
            points.volume[q] = std::pow(0.25, dim);
            for (unsigned int d = 0; d < dim; ++d)
              points.half_size[q][d] = 0.125;
          }
      }

      static Point<dim>
      corner(const double value)
      {
        Point<dim> x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = value;
        return x;
      }

      /// Move the soil for which `where` is true.
      template <typename Where>
      void
      move(const Where &where, const double dx, const double dy)
      {
        for (std::size_t q = 0; q < points.n_points(); ++q)
          if (where(points.initial_position[q]))
            {
              points.position[q][0] += dx;
              points.position[q][1] += dy;
            }
      }

      MovingBody
      find(const int direction) const
      {
        return largest_moving_body(points, grid, direction, 0.1, 0.01);
      }

      BackgroundGrid<dim> grid;
      MaterialPoints<dim> points;
    };
  } // namespace


  TEST(Measures, a_moving_body_has_the_size_and_the_place_of_what_moved)
  {
    Block<2> block;
    block.move([](const Point<2> &x) { return x[0] > 7. && x[1] > 1.; },
               0.3,
               -0.1);
    const MovingBody body = block.find(1);
    EXPECT_NEAR(body.area, 3. * 3., 1e-12);
    EXPECT_NEAR(body.share, 9. / 40., 1e-12);
    EXPECT_NEAR(body.distance, std::hypot(0.3, 0.1), 1e-12);
    EXPECT_NEAR(body.crest_cut, 7., 1e-12);
    EXPECT_EQ(block.find(-1).area, 0.);
  }


  TEST(Measures, a_body_below_the_crest_does_not_cut_it)
  {
    Block<2> block;
    block.move([](const Point<2> &x) { return x[0] < 2. && x[1] < 3.; },
               -0.2,
               0.);
    const MovingBody body = block.find(-1);
    EXPECT_NEAR(body.area, 6., 1e-12);
    EXPECT_TRUE(std::isnan(body.crest_cut));
  }


  // A common settlement is no slide, nor is a strain that grows evenly.
  TEST(Measures, what_moves_with_the_rest_is_no_body)
  {
    Block<2> block;
    block.move([](const Point<2> &) { return true; }, 1., -1.);
    EXPECT_EQ(block.find(1).distance, 0.);

    Block<2> strained;
    for (std::size_t q = 0; q < strained.points.n_points(); ++q)
      strained.points.position[q][0] *= 1.015;
    EXPECT_GT(strained.find(1).distance, 0.07);
    EXPECT_LT(strained.find(1).distance, 0.08);
  }


  // Points that fly off are many metres away, and few.
  TEST(Measures, points_that_fly_off_do_not_hide_a_slide)
  {
    Block<2> block;
    block.move([](const Point<2> &x) { return x[0] > 8.; }, 0.15, 0.);
    block.move([](const Point<2> &x) { return x[0] < 1. && x[1] < 0.5; },
               50.,
               0.);
    const MovingBody body = block.find(1);
    EXPECT_NEAR(body.area, 8., 1e-12);
    EXPECT_GT(body.distance, 0.1);
  }


  TEST(Measures, bodies_that_touch_at_no_face_are_two)
  {
    Block<2> block;
    block.move([](const Point<2> &x) { return x[0] > 9.; }, 0.3, 0.);
    block.move([](const Point<2> &x) { return x[0] > 5. && x[0] < 7.; },
               0.3,
               0.);
    EXPECT_NEAR(block.find(1).area, 8., 1e-12);
  }


  // The upper cluster has the mean of all its bodies: the largest one may have
  // moved further than that, with most of its points less than half as far as
  // it.
  TEST(Measures, an_uneven_body_among_small_ones_is_seen)
  {
    Block<2> block;
    // Two cells that touch, of 4 points each, and single cells that do not.
    const auto cell = [](const double x) { return static_cast<int>(x / h); };
    const auto fast = [&](const Point<2> &x) {
      return cell(x[1]) == 0 &&
             (cell(x[0]) == 0 || (cell(x[0]) == 1 && x[0] < 0.7 && x[1] < 0.2));
    };
    const auto slow = [&](const Point<2> &x) {
      return (cell(x[1]) == 0 && cell(x[0]) == 1 && !fast(x)) ||
             (cell(x[0]) >= 4 && (cell(x[0]) + cell(x[1])) % 2 == 0);
    };
    block.move(fast, 0.14, 0.);
    block.move(slow, 0.049, 0.);
    const MovingBody body = block.find(1);
    EXPECT_NEAR(body.area, 8 * 0.0625, 1e-12);
    EXPECT_NEAR(body.distance, (5 * 0.14 + 3 * 0.049) / 8, 1e-12); // 0.106
  }


  // The quick test leaves out nothing that the full one finds.
  TEST(Measures, what_need_not_be_found_is_too_small_or_too_slow)
  {
    unsigned int n_found = 0, n_left_out = 0;
    std::mt19937 random(1);
    const auto   uniform = [&](const double from, const double to) {
      return std::uniform_real_distribution<double>(from, to)(random);
    };
    for (unsigned int i = 0; i < 300; ++i)
      {
        Block<2>     block;
        const double scale = uniform(0.05, 0.3);
        for (unsigned int n_bodies = 0; n_bodies < 1 + i % 4; ++n_bodies)
          {
            const Point<2> centre(uniform(0., 10.), uniform(0., 4.));
            const double   size = uniform(0.2, 1.), u = uniform(0., scale);
            block.move(
              [&](const Point<2> &x) { return (x - centre).norm() < size; },
              u,
              0.);
          }
        for (Point<2> &x : block.points.position)
          x[0] += uniform(0., 0.3 * scale);
        constexpr double distance = 0.1, share = 0.01;
        const auto       find = [&](const double least_share) {
          return largest_moving_body(
            block.points, block.grid, 1, distance, least_share);
        };
        const MovingBody full = find(0.), quick = find(share);
        const bool is_slide = full.distance > distance && full.share > share;
        if (is_slide)
          {
            EXPECT_EQ(quick.area, full.area);
          }
        n_found += is_slide ? 1 : 0;
        n_left_out += full.area > 0. && quick.area == 0. ? 1 : 0;
      }
    EXPECT_GT(n_found, 50u);
    EXPECT_GT(n_left_out, 3u); // 7
  }


  TEST(Measures, in_space_a_body_is_measured_by_its_cross_section)
  {
    Block<3> block;
    block.move(
      [](const Point<3> &x) {
        return x[0] > 8. && x[1] > 2. && x[2] > 2. && x[2] < 3.;
      },
      0.3,
      0.);
    const MovingBody body = block.find(1);
    EXPECT_NEAR(body.area, 4., 1e-12);
    EXPECT_NEAR(body.share, 0.1, 1e-12);
    EXPECT_NEAR(body.crest_cut, 8., 1e-12);
  }


  TEST(Measures, slopes_fail_each_at_its_time)
  {
    Block<2>                   block;
    FailureRecord              record;
    const InitialFailureLimits limits;
    // The water stands on the right: inner is towards negative x.
    const auto look = [&](const double time) {
      record.watch_slopes(block.points, block.grid, -1, time, limits);
    };
    look(1.);
    EXPECT_EQ(record.slope(), Slopes::none);
    EXPECT_FALSE(record.failed());

    block.move([](const Point<2> &x) { return x[0] < 2.; }, -0.09, 0.);
    look(2.);
    EXPECT_FALSE(record.failed());
    block.move([](const Point<2> &x) { return x[0] < 2.; }, -0.02, 0.);
    look(3.);
    EXPECT_EQ(record.slope(), Slopes::inner);
    EXPECT_EQ(record.inner_slide.time, 3.);
    EXPECT_NEAR(record.inner_slide.body.crest_cut, 2., 1e-12);
    EXPECT_EQ(record.time_of(FailureReading::by_displacement), 3.);
    EXPECT_EQ(record.time_of(FailureReading::any), 3.);
    EXPECT_EQ(record.time_of(FailureReading::by_geometry), -1.);

    // The first slide goes on, and hides nothing of the second.
    block.move([](const Point<2> &x) { return x[0] < 2.; }, -5., -1.);
    block.move([](const Point<2> &x) { return x[0] > 9.; }, 0.11, 0.);
    look(4.);
    EXPECT_EQ(record.slope(), Slopes::both);
    EXPECT_EQ(record.inner_slide.time, 3.);
    EXPECT_EQ(record.outer_slide.time, 4.);
    EXPECT_NEAR(record.outer_slide.body.area, 4., 1e-12);
  }


  // A slide of less than the share of the profile is none.
  TEST(Measures, a_body_smaller_than_its_share_is_no_slide)
  {
    Block<2>             block;
    FailureRecord        record;
    InitialFailureLimits limits;
    limits.share = 0.026;
    block.move([](const Point<2> &x) { return x[0] > 9. && x[1] > 3.; },
               1.,
               0.);
    record.watch_slopes(block.points, block.grid, 1, 1., limits);
    EXPECT_FALSE(record.failed());
    limits.share = 0.024; // 1 of 40 m^2
    record.watch_slopes(block.points, block.grid, 1, 2., limits);
    EXPECT_EQ(record.inner_slide.time, 2.);
  }
} // namespace measures_moving_body
