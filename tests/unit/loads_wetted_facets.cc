// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/dyke_geometry.h>
#include <waker/surface/proximity_field.h>

#include "named.h"
#include "rectangles.h"
#include "standing_water.h"
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace loads_wetted_facets
{
  using namespace Waker;

  namespace
  {
    constexpr double       gamma_w     = 9.81;
    constexpr unsigned int bottom_face = 1u << 2;
    constexpr unsigned int side_faces  = 16u | 32u; // along z

    BackgroundGrid<3>
    make_grid(const double length = 4., const double h = 0.5)
    {
      return BackgroundGrid<3>(Point<3>(0, 0, 0),
                               Point<3>(16, 5, length),
                               h,
                               MPI_COMM_SELF);
    }

    WaterParameters
    water(const std::string &side, const double level)
    {
      WaterParameters parameters;
      parameters.side        = Named{side};
      parameters.level       = level;
      parameters.unit_weight = gamma_w;
      return parameters;
    }

    // Only those faces of a box that a bit of `faces` names.
    void
    add_box(Facets<3>         &facets,
            const Point<3>    &a,
            const Point<3>    &b,
            const unsigned int faces,
            const unsigned int closed = bottom_face)
    {
      for (unsigned int face = 0; face < 6; ++face)
        {
          if (!(faces >> face & 1u))
            continue;
          const unsigned int d = face / 2, e = (d + 1) % 3, f = (d + 2) % 3;
          Point<3>           x = a;
          x[d]                 = face % 2 == 0 ? a[d] : b[d];
          Point<3> y = x, z = x;
          y[e]           = b[e];
          z              = y;
          z[f]           = b[f];
          const int mark = closed >> face & 1u ? static_cast<int>(face) : -1;
          if (face % 2 == 1)
            add_rectangle(facets, x, y, z, mark);
          else
            {
              y    = x;
              y[f] = b[f];
              add_rectangle(facets, x, y, z, mark);
            }
        }
    }

    // The points of a body below the height H(x, z), between sides along z.
    Facets<3>
    detect_heights(const BackgroundGrid<3>                         &grid,
                   const std::function<double(double x, double z)> &height,
                   const unsigned int                               closed)
    {
      const double      s = grid.cell_size() / 2;
      MaterialPoints<3> points;
      for (double z = s / 2; z < grid.upper_corner()[2]; z += s)
        for (double x = s / 2; x < grid.upper_corner()[0]; x += s)
          for (double y = s / 2; y < height(x, z); y += s)
            {
              points.id.push_back(points.id.size());
              points.position.emplace_back(x, y, z);
              points.volume.push_back(s * s * s);
            }
      ProximityField<3> field(grid, SurfaceParameters(), closed);
      Facets<3>         facets;
      field.detect(points, facets);
      return facets;
    }

    // Area of the wetted facets in a range of x.
    double
    wet_area(const StandingWater<3> &load, const double from, const double to)
    {
      double sum = 0.;
      for (const Facet<3> &facet : load.facets())
        {
          const double x = (facet.vertices[0][0] + facet.vertices[1][0] +
                            facet.vertices[2][0]) /
                           3.;
          if (x >= from && x < to)
            sum += facet.measure();
        }
      return sum;
    }
  } // namespace



  // Steps of boxes, as of support domains, with vertices on the sides of
  // others, and faces exactly at the level.
  TEST(Loads, water_in_3d_climbs_steps)
  {
    const auto         grid = make_grid();
    constexpr unsigned left = 1, right = 2, top = 8, ends = 16 | 32;
    Facets<3>          facets;
    // A high step behind a low one; the low one in three lengths.
    for (int k = 0; k < 3; ++k)
      add_box(facets,
              Point<3>(2, 0, 4. / 3. * k),
              Point<3>(4, 1, 4. / 3. * (k + 1)),
              left | bottom_face | top);
    add_box(facets, Point<3>(4, 1, 0), Point<3>(8, 3, 4), left | top);
    add_box(facets, Point<3>(4, 0, 0), Point<3>(8, 3, 4), right | bottom_face);
    add_box(facets, Point<3>(2, 0, 0), Point<3>(4, 1, 4), ends, side_faces);
    add_box(facets, Point<3>(4, 0, 0), Point<3>(8, 3, 4), ends, side_faces);
    EXPECT_NEAR(enclosed_volume(facets), 56., 1e-12);

    for (const double level : {0.5, 1., 2.5, 3., 4.})
      {
        StandingWater<3> load(grid, water("left", level));
        load.find(facets);
        const SpatialResultant sum = load.spatial_resultant();

        // Over the crest it comes to the other side.
        const double thrust =
          level <= 3. ? 0.5 * level * level * gamma_w * 4. : 0.;
        EXPECT_NEAR(sum.force[0], thrust, 1e-10);
        ASSERT_EQ(load.spill().has_value(), level > 3.);
        if (level > 3.)
          {
            EXPECT_EQ(load.spill()->height, 3.);
          }
        const double on_steps = std::max(level - 1., 0.) * 2. * 4. +
                                std::max(level - 3., 0.) * 4. * 4.;
        EXPECT_NEAR(sum.force[1], -gamma_w * on_steps, 1e-10);
        EXPECT_EQ(sum.force[2], 0.);
        EXPECT_NEAR(load.resultant().force[1], sum.force[1] / 4., 1e-12);

        // On the nodes: the same.
        NodalVector force(grid.n_dofs());
        load.add_nodal_forces(std::vector<double>(grid.n_nodes(), 1.),
                              1.,
                              force);
        Tensor<1, 3> nodal, moment;
        for (unsigned int i = 0; i < grid.n_nodes(); ++i)
          {
            Tensor<1, 3> f;
            for (unsigned int d = 0; d < 3; ++d)
              f[d] = force.begin()[3 * i + d];
            nodal += f;
            moment += cross_product_3d(Tensor<1, 3>(grid.node_position(i)), f);
          }
        EXPECT_LT((nodal - sum.force).norm(), 1e-9);
        EXPECT_LT((moment - sum.moment).norm(), 1e-9);
      }

    // From the right.
    StandingWater<3> load(grid, water("right", 2.));
    load.find(facets);
    EXPECT_NEAR(load.spatial_resultant().force[0], -2. * gamma_w * 4., 1e-10);
    EXPECT_NEAR(load.spatial_resultant().force[1], 0., 1e-10);
  }



  // Extruded, the plane's load is that of the facets, node by node.
  TEST(Loads, water_on_facets_equals_that_on_a_prismatic_body)
  {
    const auto   grid = make_grid(2.);
    SurfaceChain chain;
    chain.vertices = {Point<2>(1.3, 0),
                      Point<2>(15.1, 0),
                      Point<2>(9, 4.2),
                      Point<2>(6, 4.2),
                      Point<2>(4.4, 1.9)};
    chain.on_face  = {2, -1, -1, -1, -1};
    Facets<3>         facets;
    const std::size_t n = chain.vertices.size();
    for (std::size_t k = 0; k < n; ++k)
      {
        const Point<2> &a = chain.vertices[k];
        const Point<2> &b = chain.vertices[(k + 1) % n];
        add_rectangle(facets,
                      Point<3>(a[0], a[1], 2),
                      Point<3>(a[0], a[1], 0),
                      Point<3>(b[0], b[1], 0),
                      chain.on_face[k]);
      }
    for (const double level : {1., 3.3, 4.6})
      {
        StandingWater<3> plane(grid, water("left", level));
        StandingWater<3> spatial(grid, water("left", level));
        plane.find(Surface{{chain}});
        spatial.find(facets);
        // What is written of a slice: the same area, outwards alike.
        Tensor<1, 3> areas[2];
        for (const Facet<3> &facet : plane.facets())
          areas[0] += facet.measure() * facet.normal;
        for (const Facet<3> &facet : spatial.facets())
          areas[1] += facet.measure() * facet.normal;
        EXPECT_LT((areas[0] - areas[1]).norm(), 1e-12);
        NodalVector               a(grid.n_dofs()), b(grid.n_dofs());
        const std::vector<double> mass(grid.n_nodes(), 1.);
        plane.add_nodal_forces(mass, 1., a);
        spatial.add_nodal_forces(mass, 1., b);
        EXPECT_GT(a.l2_norm(), 1.);
        b -= a;
        EXPECT_LT(b.linfty_norm(), 1e-11);
        EXPECT_NEAR(plane.resultant().force[0],
                    spatial.resultant().force[0],
                    1e-11);
        EXPECT_NEAR(plane.resultant().moment,
                    spatial.resultant().moment,
                    1e-10);
      }
  }



  // A body that hovers over the bottom stands on it: no water comes under it.
  TEST(Loads, water_in_3d_stays_out_of_a_slit)
  {
    const auto         grid = make_grid();
    constexpr unsigned free = 1 | 2 | 4 | 8;
    Facets<3>          facets;
    add_box(facets, Point<3>(2, 0.2, 0), Point<3>(8, 3, 4), free, 0);
    add_box(facets, Point<3>(2, 0.2, 0), Point<3>(8, 3, 4), 48, side_faces);
    StandingWater<3> load(grid, water("left", 2.2));
    load.find(facets);
    EXPECT_NEAR(load.spatial_resultant().force[0], 2. * gamma_w * 4., 1e-10);
    EXPECT_NEAR(load.spatial_resultant().force[1], 0., 1e-10);
  }



  // On a detected dyke: the thrust is exact, what lies behind the crest is dry,
  // and a gap in the crest lets the water in.
  TEST(Loads, water_in_3d_comes_through_a_gap)
  {
    const auto grid = make_grid(8.);
    // The crest runs obliquely; behind it a ditch, deeper than the level.
    for (const bool has_gap : {false, true})
      {
        const Facets<3> facets = detect_heights(
          grid,
          [=](const double x, const double z) {
            const double crest  = has_gap && z > 3 && z < 5 ? 1.25 : 3.25;
            const double middle = 7. + 0.2 * z;
            const double slope  = 4.5 - std::abs(x - middle);
            return std::min({crest, slope});
          },
          bottom_face | side_faces);
        const double     level = 2.25;
        StandingWater<3> load(grid, water("left", level));
        load.find(facets);
        const double outer = wet_area(load, 0., 6.),
                     inner = wet_area(load, 10., 16.);
        EXPECT_GT(outer, 10.);
        ASSERT_EQ(load.spill().has_value(), has_gap);
        if (has_gap)
          {
            EXPECT_NEAR(load.spill()->height, 1.25, 0.25);
            EXPECT_NEAR(load.spill()->z, 4., 1.25);
          }
        if (has_gap)
          {
            EXPECT_NEAR(inner, outer, 0.3 * outer);
          }
        else
          {
            EXPECT_EQ(inner, 0.);
            EXPECT_NEAR(load.spatial_resultant().force[0],
                        0.5 * gamma_w * level * level * 8.,
                        1e-9);
          }
        for (const Facet<3> &facet : load.facets())
          for (const Point<3> &x : facet.vertices)
            ASSERT_LE(x[1], level + 1e-12);

        // And from the other side.
        StandingWater<3> right(grid, water("right", level));
        right.find(facets);
        EXPECT_EQ(wet_area(right, 0., 5.) > 0., has_gap);
        EXPECT_GT(wet_area(right, 10., 16.), 10.);
      }
  }



  // Two ridges with gaps that do not face each other: no section is low, but a
  // way between them is.
  TEST(Loads, water_in_3d_finds_a_way_across_the_sections)
  {
    const auto      grid   = make_grid(8.);
    const Facets<3> facets = detect_heights(
      grid,
      [](const double x, const double z) {
        const double low  = 1.25 + (x > 7. && x < 9. ? 0.5 : 0.);
        const bool   gap  = x < 8. ? z < 2. : z > 6.;
        const bool   wall = (x > 5. && x < 7.) || (x > 9. && x < 11.);
        return x < 3. || x > 13. ? 0. : wall && !gap ? 3.25 : low;
      },
      bottom_face | side_faces);
    std::vector<double> sections;
    for (double z = 0.5; z < 8.; z += 0.5)
      sections.push_back(z);
    EXPECT_GT(measure_dyke(facets, sections, 2.).height, 2.75);
    for (const char *const side : {"left", "right"})
      {
        StandingWater<3> load(grid, water(side, 2.25));
        load.find(facets);
        ASSERT_TRUE(load.spill());
        EXPECT_NEAR(load.spill()->height, 1.75, 0.2);
        StandingWater<3> low(grid, water(side, load.spill()->height - 1e-3));
        low.find(facets);
        EXPECT_FALSE(low.spill());
        StandingWater<3> high(grid, water(side, load.spill()->height + 1e-3));
        high.find(facets);
        ASSERT_TRUE(high.spill());
        EXPECT_EQ(high.spill()->height, load.spill()->height);
      }
  }



  // Ground up to the closed wall, with a pit behind a bank.
  TEST(Loads, water_in_3d_starts_where_ground_leaves_the_wall)
  {
    const auto      grid   = make_grid();
    const Facets<3> facets = detect_heights(
      grid,
      [](const double x, const double z) {
        if (x < 4)
          return 1.;
        if (x < 7)
          return 3.5;
        return std::hypot(x - 10, z - 2) < 1.5 ? 1. : 2.5;
      },
      3u | bottom_face | side_faces);
    StandingWater<3> load(grid, water("left", 2.));
    load.find(facets);
    EXPECT_NEAR(wet_area(load, 0., 3.), 3. * 4., 0.1);
    EXPECT_EQ(wet_area(load, 6., 16.), 0.);
    // 1 m deep over 4 x 4 m, but for what is rounded at the foot of the bank.
    EXPECT_NEAR(load.spatial_resultant().force[1] / (16. * gamma_w), -1., 0.08);

    // The pit cannot be reached from the right either.
    StandingWater<3> right(grid, water("right", 2.));
    right.find(facets);
    EXPECT_TRUE(right.facets().empty());
  }



  // A hollow inside, and a smaller body beside the large one, stay dry.
  TEST(Loads, water_in_3d_loads_the_outside_of_the_largest_body)
  {
    const auto         grid = make_grid();
    constexpr unsigned all  = 63;
    Facets<3>          facets, hollow;
    add_box(facets, Point<3>(1, 1, 1), Point<3>(2, 2, 2), all, 0);
    add_box(facets, Point<3>(4, 1, 1), Point<3>(7, 4, 3), all, 0);
    add_box(hollow, Point<3>(5, 2, 1.5), Point<3>(6, 3, 2.5), all, 0);
    for (const Facet<3> &facet : hollow)
      facets.push_back(make_facet<3>(
        {{facet.vertices[0], facet.vertices[2], facet.vertices[1]}}));
    EXPECT_NEAR(enclosed_volume(facets), 1. + 18. - 1., 1e-12);

    StandingWater<3> load(grid, water("left", 4.5));
    load.find(facets);
    EXPECT_EQ(load.facets().size(), 12u);
    EXPECT_NEAR(load.spatial_resultant().force[1], 18. * gamma_w, 1e-10);
    EXPECT_NEAR(load.spatial_resultant().force[0], 0., 1e-10);

    // Floating.
    load.set_level(2.5);
    load.find(facets);
    EXPECT_NEAR(load.spatial_resultant().force[1], 9. * gamma_w, 1e-10);

    // Out of the water, and without water.
    load.set_level(0.5);
    load.find(facets);
    EXPECT_TRUE(load.facets().empty());
    EXPECT_EQ(make_wet_surface(grid, WaterSide::none, {}), nullptr);
  }
} // namespace loads_wetted_facets
