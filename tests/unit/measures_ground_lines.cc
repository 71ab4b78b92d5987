// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/ground_lines.h>

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace Waker::measures_ground_lines
{
  namespace
  {
    constexpr double h    = 0.5; // cells; squares of 0.25 m
    constexpr double side = 0.5 * h;
    constexpr double step = 1.25 * h;

    /// A body of one column a square, 2 m along x and 2 m along z, with tops
    /// at a height that is a function of the middle; none where that is 0.
    struct Ground
    {
      explicit Ground(const std::function<double(double, double)> &height)
        : grid(Point<3>(), Point<3>(2., 2., 2.), h, MPI_COMM_SELF)
      {
        for (unsigned int k = 0; k < 8; ++k)
          for (unsigned int i = 0; i < 8; ++i)
            {
              const double x = (i + 0.5) * side, z = (k + 0.5) * side;
              const double y = height(x, z);
              if (!(y > 0.))
                continue;
              points.resize(points.n_points() + 1);
              points.id.back()               = points.n_points();
              points.position.back()         = Point<3>(x, 0.5 * y, z);
              points.initial_position.back() = points.position.back();
              for (unsigned int d = 0; d < 3; ++d)
                points.half_size.back()[d] = d == 1 ? 0.5 * y : 0.5 * side;
            }
      }

      std::vector<GroundPolyline>
      lines(const double crest) const
      {
        return ground_lines(TopView<3>(grid, points),
                            points,
                            crest,
                            ground_step(grid));
      }

      BackgroundGrid<3> grid;
      MaterialPoints<3> points;
    };


    std::vector<GroundPolyline>
    of_kind(const std::vector<GroundPolyline> &lines, const GroundLine kind)
    {
      std::vector<GroundPolyline> some;
      for (const GroundPolyline &line : lines)
        if (line.kind == kind)
          some.push_back(line);
      return some;
    }


    double
    length(const GroundPolyline &line)
    {
      double sum = 0.;
      for (std::size_t v = 1; v < line.vertices.size(); ++v)
        sum += line.vertices[v].distance(line.vertices[v - 1]);
      return sum;
    }


    bool
    is_closed(const GroundPolyline &line)
    {
      return line.vertices.front().distance(line.vertices.back()) < 1e-12;
    }


    /// Enclosed by it, seen from above (m^2).
    double
    area(const GroundPolyline &line)
    {
      double sum = 0.;
      for (std::size_t v = 1; v < line.vertices.size(); ++v)
        {
          const Point<3> &a = line.vertices[v - 1], &b = line.vertices[v];
          sum += 0.5 * (a[0] * b[2] - b[0] * a[2]);
        }
      return std::abs(sum);
    }


    double
    cliff(const double x, const double)
    {
      return x < 1. ? 1. : 0.25;
    }
  } // namespace


  TEST(GroundLines, a_cliff_is_a_scarp_and_the_end_of_the_crest)
  {
    const Ground ground(cliff);
    EXPECT_EQ(crest_height(ground.points), 1.);
    const auto lines = ground.lines(1.);
    ASSERT_EQ(lines.size(), 2u);

    // Along the sides of the squares, on the upper ones.
    const auto scarps = of_kind(lines, GroundLine::scarp);
    ASSERT_EQ(scarps.size(), 1u);
    ASSERT_EQ(scarps[0].vertices.size(), 9u);
    for (unsigned int k = 0; k < 9; ++k)
      EXPECT_NEAR(scarps[0].vertices[k].distance(Point<3>(1., 1., k * side)),
                  0.,
                  1e-12);

    // Between the middles at 0.875 and 1.125 m, where the height would be 1 -
    // 0.625 m; the line lies on the higher ground.
    const auto crests = of_kind(lines, GroundLine::crest);
    ASSERT_EQ(crests.size(), 1u);
    EXPECT_EQ(crests[0].vertices.size(), 8u);
    for (const Point<3> &x : crests[0].vertices)
      {
        EXPECT_NEAR(x[0], 0.875 + side * step / 0.75, 1e-12);
        EXPECT_EQ(x[1], 1.);
      }
    EXPECT_NEAR(length(crests[0]), 2. - side, 1e-12);
  }


  TEST(GroundLines, a_slope_has_a_crest_but_no_scarp)
  {
    // 45 degrees from x = 0.75 m on: the middles lie at 1, 0.875, 0.625 m...
    const Ground ground([](const double x, const double) {
      return std::max(std::min(1., 1.75 - x), 0.05);
    });
    const auto   lines = ground.lines(1.);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].kind, GroundLine::crest);
    for (const Point<3> &x : lines[0].vertices)
      EXPECT_NEAR(x[0], 0.75 + step, 1e-12);
    // Later, 0.1 m lower all over: the crest is that of t = 0.
    const auto later = ground.lines(1.1);
    ASSERT_EQ(later.size(), 1u);
    EXPECT_NEAR(later[0].vertices[0][0], 0.75 + step - 0.1, 1e-12);
  }


  TEST(GroundLines, a_drop_of_a_cell_is_no_scarp_nor_is_the_end_of_the_soil)
  {
    const Ground ground([](const double x, const double) {
      return x < 0.5 ? 1. : x < 1. ? 0.5 : 0.;
    });
    EXPECT_TRUE(of_kind(ground.lines(1.), GroundLine::scarp).empty());
  }


  TEST(GroundLines, a_scarp_around_a_hole_closes_and_two_share_a_corner)
  {
    const auto in =
      [](const double x, const double z, const int i, const int k) {
        return std::abs(x - (i + 0.5) * side) < 0.01 &&
               std::abs(z - (k + 0.5) * side) < 0.01;
      };
    const Ground one([&](const double x, const double z) {
      return in(x, z, 3, 3) ? 0.125 : 1.;
    });
    auto         scarps = of_kind(one.lines(1.), GroundLine::scarp);
    ASSERT_EQ(scarps.size(), 1u);
    EXPECT_EQ(scarps[0].vertices.size(), 5u);
    EXPECT_TRUE(is_closed(scarps[0]));
    EXPECT_NEAR(area(scarps[0]), side * side, 1e-12);
    for (const Point<3> &x : scarps[0].vertices)
      EXPECT_EQ(x[1], 1.);

    // Each side once.
    const Ground two([&](const double x, const double z) {
      return in(x, z, 3, 3) || in(x, z, 4, 4) ? 0.125 : 1.;
    });
    scarps = of_kind(two.lines(1.), GroundLine::scarp);
    ASSERT_EQ(scarps.size(), 2u);
    for (const GroundPolyline &scarp : scarps)
      {
        EXPECT_TRUE(is_closed(scarp));
        EXPECT_NEAR(length(scarp), 4. * side, 1e-12);
        EXPECT_NEAR(area(scarp), side * side, 1e-12);
      }
  }


  TEST(GroundLines, moved_soil_is_outlined)
  {
    // Two by two squares have moved down the slope by twice the limit.
    Ground       ground([](const double, const double) { return 1.; });
    unsigned int n = 0;
    for (std::size_t p = 0; p < ground.points.n_points(); ++p)
      {
        const Point<3> &x = ground.points.position[p];
        if (x[0] > 0.75 && x[0] < 1.25 && x[2] > 0.5 && x[2] < 1.)
          {
            ground.points.initial_position[p][0] -= 1.2 * step;
            ground.points.initial_position[p][1] += 1.6 * step;
            ++n;
          }
      }
    ASSERT_EQ(n, 4u);
    const auto lines = ground.lines(1.);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].kind, GroundLine::moved);
    EXPECT_TRUE(is_closed(lines[0]));
    // Half way from the outer middles to their neighbours, corners cut.
    EXPECT_NEAR(area(lines[0]),
                side * side * (1. + 4. * 0.5 + 4. * 0.125),
                1e-12);

    // By less than the limit: none.
    for (std::size_t p = 0; p < ground.points.n_points(); ++p)
      ground.points.initial_position[p] =
        ground.points.position[p] +
        0.49 * (ground.points.initial_position[p] - ground.points.position[p]);
    EXPECT_TRUE(ground.lines(1.).empty());
  }


  TEST(GroundLines, moved_soil_at_the_border_has_an_open_outline)
  {
    Ground ground([](const double, const double) { return 1.; });
    for (std::size_t p = 0; p < ground.points.n_points(); ++p)
      if (ground.points.position[p][0] > 1.5)
        ground.points.initial_position[p][0] -= 2. * step;
    const auto lines = ground.lines(1.);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_FALSE(is_closed(lines[0]));
    EXPECT_NEAR(length(lines[0]), 2. - side, 1e-12);
    for (const Point<3> &x : lines[0].vertices)
      EXPECT_NEAR(x[0], 1.5, 1e-12);
  }
} // namespace Waker::measures_ground_lines
