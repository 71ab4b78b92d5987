// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/dyke_geometry.h>
#include <waker/surface/shape/surface.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace measures_dyke_geometry
{
  using namespace Waker;

  namespace
  {
    SurfaceChain
    make_chain(const std::vector<Point<2>> &vertices)
    {
      SurfaceChain chain;
      chain.vertices = vertices;
      chain.on_face.assign(vertices.size(), -1);
      return chain;
    }

    DykeGeometry
    measure(const Surface &chains, const double level)
    {
      return measure_dyke(to_facets(chains), level);
    }

    // 1:2 slopes, crest from x = 10 to 14 at y = 5.
    Surface
    trapezium()
    {
      return {{make_chain(
        {Point<2>(0, 0), Point<2>(24, 0), Point<2>(14, 5), Point<2>(10, 5)})}};
    }
  } // namespace



  TEST(Measures, dyke_height_and_width)
  {
    const DykeGeometry dyke = measure(trapezium(), 3.);
    EXPECT_EQ(dyke.height, 5.);
    EXPECT_NEAR(dyke.width, 12., 1e-13);
    ASSERT_EQ(dyke.parts.size(), 1u);
    EXPECT_NEAR(dyke.parts[0][0], 6., 1e-13);
    EXPECT_NEAR(dyke.parts[0][1], 18., 1e-13);

    // Below all axes, too.
    Surface low = trapezium();
    for (Point<2> &v : low.chains[0].vertices)
      v[1] -= 20.;
    EXPECT_EQ(measure(low, -17.).height, -15.);
    EXPECT_NEAR(measure(low, -17.).width, 12., 1e-12);

    // Flooded, no soil.
    EXPECT_EQ(measure(trapezium(), 5.5).width, 0.);
    EXPECT_TRUE(measure(trapezium(), 5.5).parts.empty());
    EXPECT_EQ(measure(Surface(), 1.).width, 0.);
    // Lower than any level: 0 is one.
    EXPECT_LT(measure(Surface(), 1.).height, -1e300);

    // No level, no width.
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(measure(trapezium(), none).width));
    EXPECT_EQ(measure(trapezium(), none).height, 5.);
  }



  TEST(Measures, dyke_width_is_robust_at_vertices_on_the_level)
  {
    // A vertex on the level: passed through, touched from below, from above,
    // and a whole segment on it.
    const Surface through = {{make_chain({Point<2>(0, 0),
                                          Point<2>(8, 0),
                                          Point<2>(7, 1),
                                          Point<2>(6, 2),
                                          Point<2>(2, 2),
                                          Point<2>(1, 1)})}};
    EXPECT_EQ(measure(through, 1.).width, 6.);

    const Surface notch = {{make_chain({Point<2>(0, 0),
                                        Point<2>(8, 0),
                                        Point<2>(8, 2),
                                        Point<2>(4, 1),
                                        Point<2>(0, 2)})}};
    EXPECT_EQ(measure(notch, 1.).width, 8.);

    const Surface peak = {{make_chain({Point<2>(0, 0),
                                       Point<2>(10, 0),
                                       Point<2>(10, 3),
                                       Point<2>(8, 0.5),
                                       Point<2>(4, 1),
                                       Point<2>(2, 0.5),
                                       Point<2>(0, 3)})}};
    EXPECT_NEAR(measure(peak, 1.).width, 1.6 + 1.6, 1e-13);

    // The base at the level counts, the crest at the level does not.
    EXPECT_EQ(measure(trapezium(), 0.).width, 24.);
    EXPECT_EQ(measure(trapezium(), 5.).width, 0.);
    EXPECT_NEAR(measure(trapezium(), 5. - 1e-12).width, 4., 1e-9);
  }



  TEST(Measures, dyke_width_is_a_sum_of_parts)
  {
    // Two tops of one body, a block in front, a hole in the first top; the
    // chains are not in the order of x.
    Surface surface = {
      {make_chain({Point<2>(10, 0),
                   Point<2>(30, 0),
                   Point<2>(30, 4),
                   Point<2>(25, 4),
                   Point<2>(25, 1),
                   Point<2>(20, 1),
                   Point<2>(20, 6),
                   Point<2>(10, 6)}),
       make_chain(
         {Point<2>(2, 0), Point<2>(5, 0), Point<2>(5, 3), Point<2>(2, 3)}),
       make_chain({Point<2>(12, 1),
                   Point<2>(12, 3),
                   Point<2>(14, 3),
                   Point<2>(14, 1)})}};

    const DykeGeometry dyke = measure(surface, 2.);
    EXPECT_EQ(dyke.height, 6.);
    const std::vector<std::array<double, 2>> parts = {{{2., 5.}},
                                                      {{10., 12.}},
                                                      {{14., 20.}},
                                                      {{25., 30.}}};
    EXPECT_EQ(dyke.parts, parts);
    EXPECT_DOUBLE_EQ(dyke.width, 16.);

    // Two bodies that touch are one part.
    const DykeGeometry touching = measure(
      {{make_chain(
          {Point<2>(5, 0), Point<2>(9, 0), Point<2>(9, 3), Point<2>(5, 3)}),
        make_chain(
          {Point<2>(2, 0), Point<2>(5, 0), Point<2>(5, 3), Point<2>(2, 3)})}},
      2.);
    EXPECT_EQ(touching.parts.size(), 1u);
    EXPECT_DOUBLE_EQ(touching.width, 7.);

    // The same from the right.
    for (SurfaceChain &chain : surface.chains)
      {
        std::reverse(chain.vertices.begin(), chain.vertices.end());
        for (Point<2> &v : chain.vertices)
          v[0] = -v[0];
      }
    const DykeGeometry mirrored = measure(surface, 2.);
    ASSERT_EQ(mirrored.parts.size(), 4u);
    EXPECT_EQ(mirrored.parts[0][0], -30.);
    EXPECT_DOUBLE_EQ(mirrored.width, dyke.width);
  }


  namespace
  {
    /// The prism of a trapezium (1:2 slopes) from z0 to z1 with its crest, 4 m
    /// wide, at a height that is linear along z: a closed surface of triangles.
    void
    add_prism(Facets<3>   &facets,
              const double z0,
              const double z1,
              const double height0,
              const double height1)
    {
      const auto corners = [](const double z, const double h) {
        return std::array<Point<3>, 4>{{Point<3>(12. - 2. - 2. * h, 0., z),
                                        Point<3>(12. + 2. + 2. * h, 0., z),
                                        Point<3>(14., h, z),
                                        Point<3>(10., h, z)}};
      };
      const auto back = corners(z0, height0), front = corners(z1, height1);
      const auto add =
        [&](const Point<3> &a, const Point<3> &b, const Point<3> &c) {
          facets.push_back(make_facet<3>({{a, b, c}}));
        };
      for (unsigned int k = 0; k < 4; ++k)
        {
          const unsigned int l = (k + 1) % 4;
          add(back[k], front[l], front[k]);
          add(back[k], back[l], front[l]);
        }
      add(back[0], back[2], back[1]);
      add(back[0], back[3], back[2]);
      add(front[0], front[1], front[2]);
      add(front[0], front[2], front[3]);
    }
  } // namespace


  TEST(Measures, a_dyke_in_space_is_as_low_and_as_narrow_as_its_worst_section)
  {
    Facets<3> facets;
    add_prism(facets, 0., 4., 5., 3.);  // sinks to 3 m at z = 4 m
    add_prism(facets, 4., 10., 3., 6.); // and rises
    // The normals look outwards, or the test is wrong.
    ASSERT_NEAR(enclosed_volume<3>(facets),
                // Length by the mean of h (4 + 2 h) of a linear h.
                4. * (4. * 4. + 2. * 49. / 3.) + 6. * (4. * 4.5 + 2. * 21.),
                1e-9);
    const std::vector<double> sections = {0.5, 1.5, 2.5, 3.5, 4.5, 7.5, 9.5};
    const DykeGeometry        dyke     = measure_dyke(facets, sections, 2.);
    EXPECT_NEAR(dyke.height, 3.25, 1e-12); // at 3.5 and at 4.5 m
    EXPECT_EQ(dyke.height_z, 3.5);
    EXPECT_NEAR(dyke.width, 4. + 4. * 1.25, 1e-12);
    EXPECT_EQ(dyke.width_z, 3.5);
    ASSERT_EQ(dyke.parts.size(), 1u);
    EXPECT_NEAR(dyke.parts[0][0], 12. - 4.5, 1e-12);
    EXPECT_EQ(dyke.level, 2.);

    // Any section that the water overtops has no width left.
    const DykeGeometry wet = measure_dyke(facets, sections, 3.5);
    EXPECT_EQ(wet.width, 0.);
    EXPECT_EQ(wet.width_z, 3.5);
    // A section without soil: a gap in the dyke.
    Facets<3> gap;
    add_prism(gap, 0., 4., 5., 5.);
    add_prism(gap, 5., 9., 5., 5.);
    const DykeGeometry broken = measure_dyke(gap, {3.5, 4.5, 5.5}, 2.);
    EXPECT_EQ(broken.width, 0.);
    EXPECT_EQ(broken.width_z, 4.5);
    EXPECT_LT(broken.height, -1e300);
    EXPECT_EQ(broken.height_z, 4.5);
    // On vertices: each section is closed all the same.
    EXPECT_NEAR(measure_dyke(facets, {4.}, 2.).width, 8., 1e-12);
    // A hole is no soil: facets that look inwards.
    Facets<3> hollow;
    add_prism(hollow, 0., 4., 5., 5.);
    Facets<3> inside;
    add_prism(inside, 1., 3., 3., 3.);
    for (Facet<3> &facet : inside)
      {
        std::swap(facet.vertices[0], facet.vertices[1]);
        hollow.push_back(facet);
      }
    EXPECT_NEAR(measure_dyke(hollow, {0.5, 2.}, 2.).width, 16. - 8., 1e-12);
    EXPECT_EQ(measure_dyke(hollow, {0.5, 2.}, 2.).width_z, 2.);
    EXPECT_EQ(measure_dyke(hollow, {0.5, 2.}, 2.).parts.size(), 2u);
    // Without a level there is no width; H is.
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(measure_dyke(facets, sections, none).width));
    EXPECT_TRUE(std::isnan(measure_dyke(facets, sections, none).width_z));
    EXPECT_NEAR(measure_dyke(facets, sections, none).height, 3.25, 1e-12);
  }
} // namespace measures_dyke_geometry
