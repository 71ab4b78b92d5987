// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/boxes/box_union_contour.h>

#include "box_raster.h"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace surface_contour
{
  using namespace Waker;

  namespace
  {
    using Boxes = std::vector<Box<2>>;

    double
    total_area(const Surface &surface)
    {
      double area = 0.;
      for (const SurfaceChain &chain : surface.chains)
        area += chain.area();
      return area;
    }

    // Random rectangles with their edges on a lattice of 1/8, so that many
    // coordinates are equal, exactly; of every kind of set from sparse to
    // dense.
    Boxes
    random_boxes(std::mt19937 &random)
    {
      const auto number = [&](const int low, const int high) {
        return low + int(random() % (high - low + 1));
      };
      const int n      = number(1, 40);
      const int extent = number(4, 40);
      const int size   = number(1, 12);
      Boxes     boxes(n);
      for (Box<2> &box : boxes)
        for (unsigned int d = 0; d < 2; ++d)
          {
            box.lower[d] = number(0, extent) / 8.;
            box.upper[d] = box.lower[d] + number(1, size) / 8.;
          }
      return boxes;
    }

    BoxUnionRules<2>
    random_rules(std::mt19937 &random)
    {
      BoxUnionRules<2> rules;
      for (unsigned int d = 0; d < 2; ++d)
        {
          rules.minimum_gap[d] = random() % 7 / 8.;
          rules.lower[d]       = random() % 12 / 8.;
          rules.upper[d]       = rules.lower[d] + (7 + random() % 40) / 8.;
        }
      rules.symmetric    = random() % 2;
      rules.restricted   = random() % 2;
      rules.closed_faces = random() % 2 ? random() % 16 : 0;
      return rules;
    }
  } // namespace



  TEST(Surface, contour_is_that_of_the_brute_force_union)
  {
    std::mt19937    random(3);
    BoxUnionContour search; // its work arrays must not matter
    Surface         surface;
    unsigned int    n_holes = 0, n_filled = 0, n_several = 0, n_on_face = 0;
    for (unsigned int set = 0; set < 5000; ++set)
      {
        const Boxes      boxes = random_boxes(random);
        BoxUnionRules<2> rules = random_rules(random);
        search.trace(boxes, rules, surface);
        const BoxRaster raster(boxes, rules);
        SCOPED_TRACE(set);

        // All edges, each once and with its direction: area, perimeter,
        // orientation.
        ASSERT_EQ(raster.edges_of(surface), raster.contour());
        ASSERT_NEAR(total_area(surface), raster.area(), 1e-12);

        // One chain per part and per hole, in order.
        unsigned int n_outer = 0;
        for (std::size_t c = 0; c < surface.chains.size(); ++c)
          {
            const SurfaceChain &chain = surface.chains[c];
            const double        area  = chain.area();
            ASSERT_NE(area, 0.);
            n_outer += area > 0.;
            if (c > 0)
              {
                const double before = surface.chains[c - 1].area();
                ASSERT_TRUE(area > 0. ? before >= area
                                      : before > 0. || before <= area);
              }

            // Corners only.
            const std::size_t n = chain.vertices.size();
            ASSERT_EQ(chain.on_face.size(), n);
            for (std::size_t k = 0; k < n; ++k)
              {
                const Tensor<1, 2> a =
                  chain.vertices[(k + 1) % n] - chain.vertices[k];
                const Tensor<1, 2> b =
                  chain.vertices[(k + 2) % n] - chain.vertices[(k + 1) % n];
                ASSERT_EQ(a * b, 0.);
                ASSERT_GT(a.norm() * b.norm(), 0.);

                // A segment is marked if it lies on a closed face.
                int face = -1;
                for (unsigned int d = 0; d < 2; ++d)
                  for (unsigned int f = 0; f < 2; ++f)
                    if (rules.is_closed(2 * d + f) && a[d] == 0. &&
                        chain.vertices[k][d] ==
                          (f == 0 ? rules.lower[d] : rules.upper[d]))
                      face = 2 * d + f;
                ASSERT_EQ(chain.on_face[k], face);
                n_on_face += face >= 0;
              }
          }
        ASSERT_EQ(n_outer, raster.n_parts(true));
        ASSERT_EQ(surface.chains.size() - n_outer, raster.n_parts(false) - 1);

        n_holes += surface.chains.size() - n_outer;
        rules.minimum_gap = Tensor<1, 2>();
        const BoxRaster unfilled(boxes, rules);
        n_filled += raster.area() > unfilled.area();
        n_several += n_outer > 1;
        // Filling never takes anything away.
        ASSERT_GE(raster.area(), unfilled.area());
      }
    // The sets are not all trivial.
    EXPECT_GT(n_holes, 500u);
    EXPECT_GT(n_filled, 1000u);
    EXPECT_GT(n_several, 1000u);
    EXPECT_GT(n_on_face, 1000u);
  }
} // namespace surface_contour
