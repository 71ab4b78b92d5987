// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/particles/layer_body.h>
#include <waker/particles/layer_gaps.h>

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace particles_layer_body
{
  // Volumes and first moments of bodies between height maps.

  using namespace Waker;

  namespace
  {
    using dealii::Point;


    /// Heights over a grid of n x n rectangles of [0, size]^2, each of two
    /// triangles.
    std::shared_ptr<const HeightMap>
    map(const double                                 size,
        const unsigned int                           n,
        const std::function<double(double, double)> &height)
    {
      std::vector<Point<3>> places;
      for (unsigned int k = 0; k <= n; ++k)
        for (unsigned int i = 0; i <= n; ++i)
          {
            const double x = size * i / n, z = size * k / n;
            places.emplace_back(x, height(x, z), z);
          }
      const auto vertex = [&](const unsigned int i, const unsigned int k) {
        return places[k * (n + 1) + i];
      };
      std::vector<StlTriangle> triangles;
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int i = 0; i < n; ++i)
          {
            triangles.push_back(
              {{vertex(i, k), vertex(i + 1, k), vertex(i + 1, k + 1)}});
            triangles.push_back(
              {{vertex(i, k), vertex(i, k + 1), vertex(i + 1, k + 1)}});
          }
      return std::make_shared<HeightMap>(triangles,
                                         std::array<double, 2>{{0., 0.}},
                                         std::array<double, 2>{{size, size}},
                                         1e-9,
                                         "the map",
                                         "path");
    }


    LayerBody
    prism(const std::string &corners, const double end)
    {
      LayerBody body;
      body.corners = parse_polygon(corners, "");
      body.end     = end;
      return body;
    }


    /// Volume and first moment of the parts.
    std::array<double, 4>
    moments(const std::vector<LatticePart<3>> &parts)
    {
      std::array<double, 4> sum{};
      for (const LatticePart<3> &part : parts)
        {
          sum[3] += part.share;
          for (unsigned int d = 0; d < 3; ++d)
            {
              sum[d] += part.share * part.centroid[d];
              EXPECT_GE(part.centroid[d], part.index[d]);
              EXPECT_LE(part.centroid[d], part.index[d] + 1);
            }
          EXPECT_LE(part.share, 1.);
        }
      return sum;
    }
  } // namespace


  // A box below a plane is a prism: what the cutter for prisms makes of it.
  TEST(LayerBody, BelowAPlaneItIsThePrism)
  {
    LayerBody  box   = prism("0, 0; 7, 0; 7, 5; 0, 5", 7.);
    const auto plane = [](const double x, const double) {
      return 0.3 + 0.61 * x;
    };
    box.top          = map(7., 3, plane);
    const auto parts = cut_body(box);
    const auto plane_parts =
      cut_sub_cells({{{0., 0.}}, {{7., 0.}}, {{7., plane(7, 0)}}, {{0., 0.3}}});
    ASSERT_EQ(parts.size(), 7 * plane_parts.size());
    for (std::size_t p = 0; p < parts.size(); ++p)
      {
        const SubCellPart &expected = plane_parts[p % plane_parts.size()];
        EXPECT_EQ(parts[p].index[0], expected.index[0]);
        EXPECT_EQ(parts[p].index[1], expected.index[1]);
        EXPECT_EQ(parts[p].index[2], int(p / plane_parts.size()));
        EXPECT_NEAR(parts[p].share, expected.share, 1e-13);
        for (unsigned int d = 0; d < 2; ++d)
          EXPECT_NEAR(parts[p].centroid[d], expected.centroid[d], 1e-11);
        EXPECT_NEAR(parts[p].centroid[2], parts[p].index[2] + 0.5, 1e-11);
      }
  }


  // A pyramid of 4 x 4 on [0, 8]^2, 3 high: V = 16, its centroid at a quarter.
  TEST(LayerBody, APyramidHasItsVolumeAndFirstMoment)
  {
    LayerBody  body   = prism("0, 0; 8, 0; 8, 4; 0, 4", 8.);
    const auto height = [](const double x, const double z) {
      return 3. - 1.5 * std::max(std::abs(x - 4.), std::abs(z - 4.));
    };
    // Its faces meet on the diagonals: triangles from the middle.
    std::vector<StlTriangle>      triangles;
    const std::array<Point<3>, 4> corners = {{{0, height(0, 0), 0},
                                              {8, height(8, 0), 0},
                                              {8, height(8, 8), 8},
                                              {0, height(0, 8), 8}}};
    for (unsigned int k = 0; k < 4; ++k)
      triangles.push_back(
        {{corners[k], corners[(k + 1) % 4], Point<3>(4, 3, 4)}});
    body.top = std::make_shared<HeightMap>(triangles,
                                           std::array<double, 2>{{0., 0.}},
                                           std::array<double, 2>{{8., 8.}},
                                           1e-9,
                                           "the pyramid",
                                           "path");
    EXPECT_NEAR(body.volume(), 16., 1e-12);
    const auto sum = moments(cut_body(body));
    EXPECT_NEAR(sum[3], 16., 1e-11);
    EXPECT_NEAR(sum[0], 16. * 4., 1e-10);
    EXPECT_NEAR(sum[1], 16. * 0.75, 1e-11);
    EXPECT_NEAR(sum[2], 16. * 4., 1e-10);
  }


  // Rough maps, and a prism with a re-entrant corner: the parts add up to the
  // whole; a body and what lies above it add up to the prism.
  TEST(LayerBody, PartsAddUpToTheWhole)
  {
    std::mt19937 random(3);
    const auto   rough = [&random](const double low, const double high) {
      return [low, high, &random](double, double) {
        return std::uniform_real_distribution<double>(low, high)(random);
      };
    };
    const std::string corners =
      "0, 0; 9, 0; 9, 6; 5.3, 6; 4.4, 2.2; 3.1, 6; 0, 5";
    unsigned int n_cut = 0;
    for (unsigned int trial = 0; trial < 20; ++trial)
      {
        LayerBody lower = prism(corners, 9.), upper = lower;
        lower.begin = upper.begin = 0.37;
        lower.end = upper.end = 8.9;
        lower.bottom          = map(9., 4, rough(-1., 2.));
        lower.top = upper.bottom = map(9., 5, rough(2.5, 7.));
        const auto   parts       = cut_body(lower);
        const double volume      = lower.volume();
        EXPECT_GT(volume, 50.);
        EXPECT_NEAR(moments(parts)[3], volume, 1e-10 * volume);
        for (const LatticePart<3> &part : parts)
          n_cut += part.share < 1.;

        LayerBody above_bottom = lower;
        above_bottom.top       = nullptr;
        const double whole     = above_bottom.volume();
        EXPECT_NEAR(volume + upper.volume(), whole, 1e-10 * whole);
        EXPECT_NEAR(common_volume(lower, upper), 0., 1e-12 * volume);
        EXPECT_NEAR(common_volume(lower, above_bottom), volume, 1e-10 * volume);

        // Vertical lines see the same: 200 x 200 of them, by Simpson's cousin.
        if (trial > 0)
          continue;
        constexpr unsigned int n   = 200;
        double                 sum = 0.;
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int k = 0; k < n; ++k)
            for (const auto &stretch : lower.stretches(
                   9. * (i + 0.5) / n, 0.37 + 8.53 * (k + 0.5) / n, true))
              sum += (stretch.high - stretch.low) * 9. / n * 8.53 / n;
        EXPECT_NEAR(sum / volume, 1., 1e-3);
      }
    EXPECT_GT(n_cut, 1000u);
  }


  TEST(LayerBody, TwoBodiesOverlapByTheirCommonVolume)
  {
    // y < 1 + 0.1 x below, y > 0.5 + 0.1 x above: a slab of half a metre.
    LayerBody lower = prism("0, 0; 4, 0; 4, 3; 0, 3", 4.);
    LayerBody upper = lower;
    lower.top       = map(4., 2, [](double x, double) { return 1. + 0.1 * x; });
    upper.bottom = map(4., 3, [](double x, double) { return 0.5 + 0.1 * x; });
    EXPECT_NEAR(common_volume(lower, upper), 8., 1e-12);
    upper.begin = 3.;
    EXPECT_NEAR(common_volume(upper, lower), 2., 1e-12);
    // With a prism.
    const LayerBody block = prism("1, 0; 2, 0; 2, 5; 1, 5", 4.);
    EXPECT_NEAR(common_volume(lower, block), 4. * 1.15, 1e-12);
    EXPECT_TRUE(lower.stretches(4.5, 1., true).empty());
  }


  TEST(LayerBody, AGapBelowAMapIsFound)
  {
    LayerBody       lower = prism("0, 0; 4, 0; 4, 3; 0, 3", 4.);
    LayerBody       upper = lower;
    const LayerBody base  = prism("0, -1; 4, -1; 4, 0; 0, 0", 4.);
    lower.top    = map(4., 2, [](double x, double) { return 1. + x / 4; });
    upper.bottom = lower.top;
    EXPECT_TRUE(body_gaps({base, lower, upper}, 0.25).empty());
    // Open over half of the plan, most at its edge.
    upper.bottom =
      map(4., 2, [](double x, double z) { return 1. + x / 4 + (z > 3); });
    const auto gaps = body_gaps({base, lower, upper}, 0.25);
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_EQ(gaps[0].lower, 1u);
    EXPECT_EQ(gaps[0].upper, 2u);
    EXPECT_NEAR(gaps[0].area, 8., 1e-12);
    EXPECT_NEAR(gaps[0].height, 1. - 0.125 / 2., 1e-12);
    EXPECT_NEAR(gaps[0].middle[2], 3.875, 1e-12);
    // Prisms are for layer_gaps().
    EXPECT_TRUE(
      body_gaps({base, prism("0, 1; 4, 1; 4, 2; 0, 2", 4.)}, 0.25).empty());
  }
} // namespace particles_layer_body
