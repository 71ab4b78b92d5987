// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/particles/polygon.h>
#include <waker/particles/sub_cells.h>

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace particles_sub_cells
{
  namespace
  {
    using namespace Waker;
  }


  TEST(Particles, small_parts_are_handed_on_until_large_enough)
  {
    // A slope of 1:10: shares 1/20, 3/20, 5/20, ... from the toe.
    const auto parts = cut_sub_cells({{{0., 0.}}, {{10., 0.}}, {{10., 1.}}});
    ASSERT_EQ(parts.size(), 10u);
    EXPECT_NEAR(parts[0].share, 0.05, 1e-14);
    EXPECT_NEAR(parts[0].centroid[0], 2. / 3., 1e-14);
    const auto merged = merge_small_parts(parts, 0.25);
    ASSERT_EQ(merged.size(), 8u);
    EXPECT_EQ(merged[0].index[0], 2);
    EXPECT_NEAR(merged[0].share, 0.45, 1e-14);
    EXPECT_NEAR(merged[0].centroid[0], 2., 1e-14); // of the triangle of 3 x 0.3

    // A part that is alone stays.
    const Polygon alone = {{{0.1, 0.1}}, {{0.2, 0.1}}, {{0.1, 0.2}}};
    EXPECT_EQ(merge_small_parts(cut_sub_cells(alone), 0.25).size(), 1u);

    // In a thin strip no part takes all the others.
    const Polygon strip = {{{0., 0.}},
                           {{100., 0.}},
                           {{100., 0.1}},
                           {{0., 0.1}}};
    for (const auto &part : merge_small_parts(cut_sub_cells(strip), 0.25))
      EXPECT_LE(part.share, 0.51);
  }


  TEST(Particles, parts_agree_with_clipping_each_sub_cell)
  {
    // A comb: several edges in one sub-cell, and sub-cells with two parts.
    const Polygon comb  = {{{0.3, 0.2}},
                           {{6.1, 0.4}},
                           {{5.9, 5.3}},
                           {{4.7, 0.9}},
                           {{4.6, 6.}},
                           {{4.4, 1.1}},
                           {{2., 5.5}},
                           {{2.2, 1.3}},
                           {{0., 3.}}};
    const auto    parts = cut_sub_cells(comb);
    double        sum   = 0.;
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 7; ++i)
        {
          const double x = i, y = j;
          const double area = common_area(
            comb, {{{x, y}}, {{x + 1, y}}, {{x + 1, y + 1}}, {{x, y + 1}}});
          const auto part =
            std::find_if(parts.begin(), parts.end(), [&](const SubCellPart &p) {
              return p.index == std::array<int, 2>{{i, j}};
            });
          EXPECT_NEAR(part == parts.end() ? 0. : part->share, area, 1e-13);
          sum += area;
        }
    EXPECT_NEAR(sum, signed_area(comb), 1e-12);
  }


  TEST(Particles, layers_that_touch_do_not_overlap)
  {
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> uniform(0., 1.);
    for (unsigned int k = 0; k < 200; ++k)
      {
        // The line between them has corners that only one of them knows.
        const double  y0 = 1. + uniform(random), y1 = 1. + uniform(random);
        const double  s    = uniform(random);
        const double  y    = y0 + s * (y1 - y0);
        const Polygon low  = {{{0., 0.}}, {{7., 0.}}, {{7., y1}}, {{0., y0}}};
        const Polygon high = {
          {{0., y0}}, {{7. * s, y}}, {{7., y1}}, {{7., 3.}}, {{0., 3.}}};
        EXPECT_NEAR(common_area(low, high), 0., 1e-13);
        EXPECT_NEAR(common_area(low, low), signed_area(low), 1e-13);
      }
  }
} // namespace particles_sub_cells
