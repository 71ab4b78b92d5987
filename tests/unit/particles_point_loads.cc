// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/particles/point_loads.h>

#include <gtest/gtest.h>

namespace particles_point_loads
{
  using namespace Waker;


  // 0.1 and 0.3 are as far from 0.2, but for round-off: the first one is
  // loaded, wherever the body is.
  TEST(Particles, the_first_of_the_nearest_points_is_loaded)
  {
    ASSERT_LT(0.3 - 0.2, 0.2 - 0.1);
    for (const bool mirrored : {false, true})
      {
        MaterialPoints<2> points;
        points.resize(2);
        points.position[mirrored ? 1 : 0] = Point<2>(0.1, 0.);
        points.position[mirrored ? 0 : 1] = Point<2>(0.3, 0.);
        PointLoadParameters load;
        load.name        = "tip";
        load.from        = {0.2, 0.};
        load.force       = {3., -2.};
        points.volume[0] = points.volume[1] = 0.01;
        apply_point_loads<2>({load}, 0.5, points);
        EXPECT_EQ(points.load[0], (Tensor<1, 2>({3., -2.})));
        EXPECT_EQ(points.load[1], (Tensor<1, 2>()));
      }
  }
} // namespace particles_point_loads
