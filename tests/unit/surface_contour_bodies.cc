// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/boxes/box_union_contour.h>

#include "box_raster.h"
#include "mapping_lattice.h"
#include "verification_data.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace surface_contour_bodies
{
  // Bodies of support domains as they come: lattices anywhere on the grid, and
  // what deformation makes of them.

  using namespace Waker;

  namespace
  {
    using Boxes = std::vector<Box<2>>;
    using Lattice::Random;

    constexpr double h = 0.25;

    Box<2>
    domain(const Point<2> &x, const Tensor<1, 2> &l)
    {
      return {x - l, x + l};
    }

    Tensor<1, 2>
    vector(const double x, const double y)
    {
      Tensor<1, 2> v;
      v[0] = x;
      v[1] = y;
      return v;
    }

    /// n_x x n_y domains of h/2, the first with its lower corner at `corner`.
    Boxes
    lattice(const Point<2> &corner, const int n_x, const int n_y)
    {
      Boxes boxes;
      for (int j = 0; j < n_y; ++j)
        for (int i = 0; i < n_x; ++i)
          boxes.push_back(
            domain(corner + vector((i + 0.5) * h / 2, (j + 0.5) * h / 2),
                   vector(h / 4, h / 4)));
      return boxes;
    }

    BoxUnionRules<2>
    half_gaps()
    {
      BoxUnionRules<2> rules;
      rules.minimum_gap = vector(h / 4, h / 4);
      rules.tolerance   = 1e-9 * h;
      return rules;
    }

    Surface
    contour(const Boxes &boxes, const BoxUnionRules<2> &rules)
    {
      BoxUnionContour search;
      Surface         surface;
      search.trace(boxes, rules, surface);
      return surface;
    }

    double
    total_area(const Surface &surface)
    {
      double area = 0.;
      for (const SurfaceChain &chain : surface.chains)
        area += chain.area();
      return area;
    }

    void
    expect_same(const Surface &a, const Surface &b)
    {
      ASSERT_EQ(a.chains.size(), b.chains.size());
      for (std::size_t c = 0; c < a.chains.size(); ++c)
        {
          ASSERT_EQ(a.chains[c].vertices.size(), b.chains[c].vertices.size());
          ASSERT_EQ(a.chains[c].on_face, b.chains[c].on_face);
          for (std::size_t k = 0; k < a.chains[c].vertices.size(); ++k)
            ASSERT_LT(a.chains[c].vertices[k].distance(b.chains[c].vertices[k]),
                      1e-9 * h);
        }
    }

    /// A body of about 1.5 n x n domains after deformation: sheared, stretched,
    /// shaken by up to `noise` h, with a hole, a crack and domains torn off.
    Boxes
    deformed_body(Random &random, const double noise, const int n = 16)
    {
      const double   shear   = random(-0.4, 0.4);
      const double   stretch = random(0.8, 1.2);
      const Point<2> hole(random(0., 3.), random(0., 2.));
      const double   radius = random(0., 0.5);
      const double   crack  = random(0., 3.);
      const double   width  = random(0., 0.3) * h;
      Boxes          boxes;
      for (const Box<2> &box :
           lattice(Point<2>(random(0., h), random(0., h)), 3 * n / 2, n))
        {
          Point<2> x = box.lower + vector(h / 4, h / 4);
          if (x.distance(hole) < radius || random(0., 1.) < 0.003)
            continue;
          if (x[0] > crack)
            x[0] += width;
          x[0] += shear * x[1];
          x[0] *= stretch;
          x[1] /= stretch;
          x += noise * h * random.vector<2>(-1., 1.);
          boxes.push_back(domain(x, vector(h / 4, h / 4)));
        }
      return boxes;
    }

    Boxes
    mirrored(const Boxes &boxes)
    {
      Boxes mirror = boxes;
      for (Box<2> &box : mirror)
        {
          const double left = -box.upper[0];
          box.upper[0]      = -box.lower[0];
          box.lower[0]      = left;
        }
      return mirror;
    }
  } // namespace



  TEST(Surface, contour_of_a_lattice_is_a_rectangle_wherever_it_lies)
  {
    Random random(1);
    for (unsigned int trial = 0; trial < 500; ++trial)
      {
        const Point<2> corner(random(-100., 100.), random(-100., 100.));
        Boxes          boxes = lattice(corner, 12, 7);
        // Positions that have been through many steps: off by round-off.
        for (Box<2> &box : boxes)
          {
            const Tensor<1, 2> noise = random.vector<2>(-1e-13, 1e-13);
            box.lower += noise;
            box.upper += noise;
          }
        for (const double gap : {0., h / 4})
          for (const bool restricted : {true, false})
            {
              BoxUnionRules<2> rules = half_gaps();
              rules.minimum_gap      = vector(gap, gap);
              rules.restricted       = restricted;
              const Surface surface  = contour(boxes, rules);
              ASSERT_EQ(surface.chains.size(), 1u);
              ASSERT_EQ(surface.chains[0].vertices.size(), 4u);
              ASSERT_NEAR(total_area(surface), 84 * h * h / 4, 1e-10);
            }

        // A missing domain is a hole, if it is no gap.
        boxes.erase(boxes.begin() + 30);
        BoxUnionRules<2> rules   = half_gaps();
        Surface          surface = contour(boxes, rules);
        ASSERT_EQ(surface.chains.size(), 2u);
        ASSERT_NEAR(surface.chains[1].area(), -h * h / 4, 1e-10);
        rules.minimum_gap[1] = h / 2;
        surface              = contour(boxes, rules);
        ASSERT_EQ(surface.chains.size(), 1u);
      }
  }



  TEST(Surface, contour_needs_the_points_near_the_surface_only)
  {
    // The restricted search gives the contour of the full one.
    Random      random(2);
    std::size_t n_all = 0, n_swept = 0;
    for (unsigned int trial = 0; trial < 400; ++trial)
      {
        BoxUnionRules<2> rules = half_gaps();
        const Boxes      boxes = deformed_body(random, random(0., 0.1), 40);
        rules.minimum_gap =
          vector(random(0.1, 0.9) * h / 2, random(0.1, 0.9) * h / 2);
        rules.symmetric = trial % 2;
        if (trial % 3 == 0)
          {
            rules.closed_faces = trial / 3 % 16;
            rules.lower        = Point<2>(0.3, 0.2);
            rules.upper        = Point<2>(5.3, 3.9);
          }
        SCOPED_TRACE(trial);
        BoxUnionContour search;
        Surface         surface;
        search.trace(boxes, rules, surface);
        n_all += boxes.size();
        n_swept += search.n_swept();
        rules.restricted = false;
        expect_same(surface, contour(boxes, rules));
      }
    // It has left out points, though these bodies are small and full of gaps.
    EXPECT_LT(n_swept, 0.8 * n_all);
    RecordProperty("swept", std::to_string(double(n_swept) / n_all));
  }



  TEST(Surface, contour_filled_from_the_left_is_not_symmetric)
  {
    // What is filled on the way to the right differs from what is filled on the
    // way to the left; with the symmetric rule nothing does.
    Random             random(4);
    unsigned int       n_different = 0;
    double             mean        = 0.;
    const unsigned int n_bodies    = 300;
    for (unsigned int body = 0; body < n_bodies; ++body)
      {
        BoxUnionRules<2> rules  = half_gaps();
        const Boxes      boxes  = deformed_body(random, 0.1);
        const Boxes      mirror = mirrored(boxes);
        const double     left   = total_area(contour(boxes, rules));
        const double     right  = total_area(contour(mirror, rules));

        // The area that only one of them has, by the union of both.
        Boxes       together = BoxRaster(boxes, rules).rectangles();
        const Boxes other    = mirrored(BoxRaster(mirror, rules).rectangles());
        together.insert(together.end(), other.begin(), other.end());
        BoxUnionRules<2> no_gaps = rules;
        no_gaps.minimum_gap      = Tensor<1, 2>();
        const double either      = total_area(contour(together, no_gaps));

        rules.symmetric       = true;
        const double both     = total_area(contour(boxes, rules));
        const double unfilled = total_area(contour(boxes, no_gaps));
        ASSERT_NEAR(both, total_area(contour(mirror, rules)), 1e-9);
        // It fills less than either, and all of them more than nothing.
        ASSERT_LE(both, std::min(left, right) + 1e-9);
        ASSERT_LE(unfilled, both + 1e-9);

        const double difference = (2. * either - left - right) / both;
        n_different += difference > 1e-9;
        mean += difference / n_bodies;
        Verification::row("contour_symmetry",
                          "body,unfilled,symmetric,from_left,from_right,"
                          "one_only",
                          body,
                          unfilled,
                          both,
                          left,
                          right,
                          difference * both);
      }
    EXPECT_GT(n_different, n_bodies / 10);
    EXPECT_LT(mean, 1e-2);
  }
} // namespace surface_contour_bodies
