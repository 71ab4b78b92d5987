// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/crest.h>
#include <waker/particles/removal.h>

#include "measures_blocks.h"
#include <gtest/gtest.h>

namespace measures_crest
{
  using namespace Waker;

  namespace
  {
    /// Damage if the soil for which `failed` is true is not stable.
    template <int dim, typename Where>
    CrestDamage
    damage(const Crest<dim>          &crest,
           const MaterialPoints<dim> &points,
           const Where               &failed)
    {
      std::vector<bool> stable;
      for (const Point<dim> &x : points.initial_position)
        stable.push_back(!failed(x));
      return crest.damage(points, stable);
    }


    /// A slope: above a line that falls by 45 degrees from (6, 4) there is
    /// nothing.
    MaterialPoints<2>
    slope()
    {
      MaterialPoints<2>        points = block_of_points<2>();
      std::vector<std::size_t> above;
      for (std::size_t q = 0; q < points.n_points(); ++q)
        if (points.position[q][0] + points.position[q][1] > 10.)
          above.push_back(q);
      remove_points(above, points);
      return points;
    }
  } // namespace


  TEST(Measures, retrogression_is_the_way_from_the_edge_to_stable_soil)
  {
    const MaterialPoints<2> points = slope();
    const Crest<2>          crest(points, 1, {});
    EXPECT_EQ(crest.lowest_x(), 0.);
    // The row of points at y = 3.875 ends there: the staircase of the lattice.
    EXPECT_EQ(crest.highest_x(), 6.25);
    const auto behind = [&](const double x_cut) {
      const auto failed = [&](const Point<2> &x) { return x[0] > x_cut; };
      return damage(crest, points, failed).retrogression;
    };
    EXPECT_EQ(behind(20.), 0.);
    EXPECT_EQ(behind(5.), 1.25);
    EXPECT_EQ(behind(2.5), 3.75);
    EXPECT_EQ(behind(-1.), 6.25); // the whole crest
    EXPECT_TRUE(std::isnan(
      damage(crest, points, [](const Point<2> &) { return true; }).width));

    // Below the crest nothing counts; stable soil in front bounds the way.
    const auto failed = [](const Point<2> &x) { return x[1] < 3.75; };
    EXPECT_EQ(damage(crest, points, failed).retrogression, 0.);
    const auto hole = [](const Point<2> &x) { return x[0] > 3. && x[0] < 6.; };
    EXPECT_EQ(damage(crest, points, hole).retrogression, 0.);
  }


  TEST(Measures, the_edge_of_the_crest_may_be_given)
  {
    const MaterialPoints<2> points = slope();
    const Crest<2>          crest(points, 1, 6.);
    const auto failed = [](const Point<2> &x) { return x[0] > 5.; };
    EXPECT_EQ(damage(crest, points, failed).retrogression, 1.);
    const auto front = [](const Point<2> &x) { return x[0] > 6.; };
    EXPECT_EQ(damage(crest, points, front).retrogression, 0.);
    const auto none = [](const Point<2> &) { return false; };
    EXPECT_EQ(damage(Crest<2>(points, 1, 6.5), points, none).retrogression, 0.);
  }


  TEST(Measures, a_crest_that_falls_to_the_other_side_is_the_mirror_image)
  {
    MaterialPoints<2> points = slope();
    for (std::size_t q = 0; q < points.n_points(); ++q)
      points.initial_position[q][0] = points.position[q][0] =
        -points.position[q][0];
    const auto     failed = [](const Point<2> &x) { return x[0] < -5.; };
    const Crest<2> crest(points, -1, {});
    EXPECT_EQ(crest.lowest_x(), -6.25);
    EXPECT_EQ(crest.highest_x(), 0.);
    EXPECT_EQ(damage(crest, points, failed).retrogression, 1.25);
    EXPECT_EQ(damage(Crest<2>(points, -1, -6.), points, failed).retrogression,
              1.);
  }


  TEST(Measures, a_crest_in_space_is_damaged_along_a_width)
  {
    const MaterialPoints<3> points = block_of_points<3>();
    const Crest<3>          crest  = crest_of(points);
    const auto              failed = [](const Point<3> &x) {
      return (x[2] > 1. && x[2] < 2. && x[0] > 8.) ||
             (x[2] > 4. && x[2] < 4.5 && x[0] > 6.5) ||
             (x[2] < 1. && x[0] > 2. && x[1] < 3.); // below the crest
    };
    const CrestDamage two = damage(crest, points, failed);
    EXPECT_EQ(two.retrogression, 3.5);
    EXPECT_NEAR(two.width, 1.5, 1e-12);
    // Whatever the order.
    const MaterialPoints<3> others = shuffled(points, 3);
    const CrestDamage       same   = damage(crest_of(others), others, failed);
    EXPECT_EQ(same.retrogression, two.retrogression);
    EXPECT_EQ(same.width, two.width);

    const auto none = [](const Point<3> &) { return false; };
    EXPECT_EQ(damage(crest, points, none).width, 0.);
    EXPECT_EQ(damage(crest, points, none).retrogression, 0.);
    const auto all = [](const Point<3> &) { return true; };
    EXPECT_NEAR(damage(crest, points, all).width, 6., 1e-12);
    EXPECT_EQ(damage(crest, points, all).retrogression, 10.);
  }


  TEST(Measures, a_crest_may_be_higher_at_some_z_and_points_of_several_sizes)
  {
    // From z = 3 on the block is 1 m lower and ends at x = 7; there each point
    // is half as long along z, from 4 m on.
    MaterialPoints<3>        points = block_of_points<3>();
    std::vector<std::size_t> gone;
    for (std::size_t q = 0; q < points.n_points(); ++q)
      {
        Point<3> &x = points.initial_position[q];
        if (x[2] > 3. && (x[1] > 3. || x[0] > 7.))
          gone.push_back(q);
        else if (x[2] > 4.)
          {
            // Two of the layers of before are in this one.
            x[2] = 4. + 0.5 * (x[2] - 4.);
            points.half_size[q][2] *= 0.5;
          }
      }
    remove_points(gone, points);
    const Crest<3> crest = crest_of(points);
    EXPECT_EQ(crest.highest_x(), 10.);
    const auto failed = [](const Point<3> &x) {
      return x[2] > 3.5 && x[2] < 4.25 && x[0] > 6.;
    };
    const CrestDamage here = damage(crest, points, failed);
    EXPECT_EQ(here.retrogression, 1.); // of 7 m, not of 10 m
    EXPECT_NEAR(here.width, 0.75, 1e-12);
  }


  TEST(Measures, a_crest_of_which_points_have_left_is_damaged)
  {
    MaterialPoints<3>        points = block_of_points<3>();
    const Crest<3>           crest  = crest_of(points);
    std::vector<std::size_t> gone;
    for (std::size_t q = 0; q < points.n_points(); ++q)
      if (points.position[q][0] > 9. && points.position[q][2] < 0.5)
        gone.push_back(q);
    remove_points(gone, points);
    const auto        none = [](const Point<3> &) { return false; };
    const CrestDamage here = damage(crest, points, none);
    EXPECT_EQ(here.retrogression, 1.);
    EXPECT_NEAR(here.width, 0.5, 1e-12);
  }
} // namespace measures_crest
