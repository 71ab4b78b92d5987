// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/moved_soil.h>
#include <waker/particles/material_points.h>

#include <gtest/gtest.h>

namespace measures_moved_soil
{
  namespace
  {
    using namespace Waker;


    TEST(MovedSoil, is_counted_by_direction_with_its_mean_way)
    {
      MaterialPoints<2> points;
      points.id               = {0, 1, 2, 3};
      points.volume           = {1., 3., 2., 5.};
      points.initial_position = {{0., 0.}, {0., 0.}, {0., 0.}, {0., 0.}};
      points.position         = {{0.6, -1.}, {1., 0.}, {-2., -0.5}, {0.4, -3.}};
      const MovedSoil right   = moved_soil(points, true);
      EXPECT_DOUBLE_EQ(right.area, 4.);
      EXPECT_DOUBLE_EQ(right.dx, 0.9);
      EXPECT_DOUBLE_EQ(right.dy, -0.25);
      const MovedSoil left = moved_soil(points, false);
      EXPECT_DOUBLE_EQ(left.area, 2.);
      EXPECT_DOUBLE_EQ(left.dx, -2.);
      EXPECT_DOUBLE_EQ(left.dy, -0.5);
    }


    TEST(MovedSoil, is_an_area_in_three_dimensions_too)
    {
      // Six cubes of 0.5 m along z, from 1 to 4 m: the first two move by 1 m,
      // the third by 2 m and 0.5 m along z.
      MaterialPoints<3> points;
      for (unsigned int i = 0; i < 6; ++i)
        {
          const Point<3> x(0.25, 0.25, 1.25 + 0.5 * i);
          Point<3>       now = x;
          now[0] += i < 2 ? 1. : i == 2 ? 2. : 0.4;
          now[2] += i == 2 ? 0.5 : 0.;
          points.id.push_back(i);
          points.volume.push_back(0.125);
          Tensor<1, 3> half_size;
          for (unsigned int d = 0; d < 3; ++d)
            half_size[d] = 0.25;
          points.half_size.push_back(half_size);
          points.initial_position.push_back(x);
          points.position.push_back(now);
        }
      const MovedSoil moved = moved_soil(points, true);
      EXPECT_DOUBLE_EQ(moved.area, 3. * 0.125 / 3.); // m^3 by 3 m of dyke
      EXPECT_DOUBLE_EQ(moved.dx, 4. / 3.);
      EXPECT_DOUBLE_EQ(moved.dy, 0.);
      EXPECT_EQ(moved_soil(points, false).area, 0.);
    }
  } // namespace
} // namespace measures_moved_soil
