// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/surface/proximity_field.h>

#include "verification_data.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace surface_proximity_field
{
  using namespace Waker;

  namespace
  {
    constexpr unsigned int bottom_face = 1u << 2;

    template <int dim>
    void
    add_point(MaterialPoints<dim> &points,
              const Point<dim>    &x,
              const double         volume)
    {
      points.id.push_back(points.id.size());
      points.position.push_back(x);
      points.volume.push_back(volume);
    }

    // Points at (k + 1/2 + offset) s in [from, to].
    template <typename Inside>
    MaterialPoints<2>
    lattice(const Point<2> &from,
            const Point<2> &to,
            const double    s,
            const Point<2> &offset,
            const Inside   &inside)
    {
      MaterialPoints<2> points;
      for (double y = from[1] + (0.5 + offset[1]) * s; y < to[1]; y += s)
        for (double x = from[0] + (0.5 + offset[0]) * s; x < to[0]; x += s)
          if (inside(x, y))
            add_point(points, Point<2>(x, y), s * s);
      return points;
    }

    MaterialPoints<2>
    block(const Point<2> &from,
          const Point<2> &to,
          const double    s,
          const Point<2> &offset = Point<2>())
    {
      return lattice(from, to, s, offset, [](double, double) { return true; });
    }
  } // namespace



  // Detected height of a flat top minus the edge of the support domains, over
  // all offsets of the points in a cell. References: an independent
  // computation. The data of doc/verification/proximity_field.md: one row per
  // radius and vertical offset.
  TEST(Surface, flat_face_has_no_mean_offset)
  {
    struct Reference
    {
      double radius, inward, outward;
    };
    const double            h = 1.;
    const BackgroundGrid<2> grid(Point<2>(0, 0),
                                 Point<2>(12, 8),
                                 h,
                                 MPI_COMM_SELF);
    for (const Reference &r : {Reference{0.75, -0.14, 0.14},
                               Reference{1., -0.095, 0.071},
                               Reference{1.5, -0.039, 0.039},
                               Reference{2., -0.022, 0.022}})
      {
        SurfaceParameters parameters;
        parameters.kernel_radius = r.radius;
        ProximityField<2> field(grid, parameters, bottom_face);

        double       sum = 0., lowest = 1., highest = -1.;
        unsigned int n        = 0;
        const int    n_offset = 100;

        double       row_sum = 0., row_lowest = 1., row_highest = -1.;
        unsigned int row_n = 0;
        for (int k = 0; k < n_offset * n_offset; ++k)
          {
            const Point<2> shift((k % n_offset + 0.5) / n_offset,
                                 (k / n_offset + 0.5) / n_offset);
            const double   top = 5. + shift[1];
            const auto     points =
              block(Point<2>(0.5, 0), Point<2>(11.5, top), 0.5 * h, 2. * shift);
            ASSERT_NEAR(points.position.back()[1] + 0.25 * h, top, 1e-12);

            const Surface surface = field.detect(points);
            ASSERT_EQ(surface.chains.size(), 1u);
            for (const Point<2> &v : surface.chains[0].vertices)
              // crossings of vertical edges, away from the corners
              if (v[1] > 2 && v[0] > 4.5 && v[0] < 8.5 &&
                  std::abs(v[0] - std::round(v[0])) < 1e-12)
                {
                  row_sum += v[1] - top;
                  row_lowest  = std::min(row_lowest, v[1] - top);
                  row_highest = std::max(row_highest, v[1] - top);
                  ++row_n;
                }
            if ((k + 1) % n_offset != 0)
              continue;

            Verification::row("proximity_field",
                              "radius_h,offset_h,crossings,mean_h,inward_h,"
                              "outward_h",
                              r.radius,
                              shift[1],
                              row_n,
                              row_sum / row_n,
                              row_lowest,
                              row_highest);
            sum += row_sum;
            n += row_n;
            lowest      = std::min(lowest, row_lowest);
            highest     = std::max(highest, row_highest);
            row_sum     = 0.;
            row_n       = 0;
            row_lowest  = 1.;
            row_highest = -1.;
          }
        ASSERT_GE(n, 4u * n_offset * n_offset);
        RecordProperty("mean_offset_" + std::to_string(r.radius),
                       std::to_string(sum / n));
        EXPECT_NEAR(sum / n, 0., 0.005) << "radius " << r.radius;
        EXPECT_NEAR(lowest, r.inward, 0.01) << "radius " << r.radius;
        EXPECT_NEAR(highest, r.outward, 0.01) << "radius " << r.radius;
      }
  }



  TEST(Surface, kernel_integrates_to_one)
  {
    // The sum of the nodal values times h^2 is a quadrature of the kernel; over
    // all offsets of the point in a cell its mean is the integral.
    const double            h = 0.25;
    const BackgroundGrid<2> grid(Point<2>(-1, -1),
                                 Point<2>(1, 1),
                                 h,
                                 MPI_COMM_SELF);
    for (const double radius : {0.5, 0.8, 1., 1.25, 2.})
      {
        SurfaceParameters parameters;
        parameters.kernel_radius = radius;
        ProximityField<2> field(grid, parameters, 0);
        double            sum = 0;
        const int         n   = 50;
        for (int k = 0; k < n * n; ++k)
          {
            MaterialPoints<2> points;
            add_point(points,
                      Point<2>(h * (k % n + 0.5) / n, h * (k / n + 0.5) / n),
                      3.);
            for (const double f : field.field(points))
              sum += f * h * h;
          }
        EXPECT_NEAR(sum / (n * n), 3., 1e-3) << "radius " << radius;
      }
  }



  TEST(Surface, mirrored_base_does_not_halve_the_field)
  {
    const double            h = 0.25;
    const BackgroundGrid<2> grid(Point<2>(0, 0),
                                 Point<2>(8, 3),
                                 h,
                                 MPI_COMM_SELF);
    const BackgroundGrid<2> deep_grid(Point<2>(0, -3),
                                      Point<2>(8, 3),
                                      h,
                                      MPI_COMM_SELF);
    for (const double radius : {0.75, 1., 1.6, 2.})
      {
        SurfaceParameters parameters;
        parameters.kernel_radius = radius;
        ProximityField<2> field(grid, parameters, bottom_face);
        ProximityField<2> deep_field(deep_grid, parameters, 0);

        // The lattice goes on below the base: there the field is the same.
        const auto  points = block(Point<2>(1, 0), Point<2>(7, 2), h / 2);
        const auto &f      = field.field(points);
        const auto &deep =
          deep_field.field(block(Point<2>(1, -2), Point<2>(7, 2), h / 2));
        const unsigned int nx = grid.n_nodes_per_direction()[0];
        for (unsigned int i = 0; i < nx; ++i)
          for (unsigned int j = 1; j < 12; ++j)
            ASSERT_NEAR(f[j * nx + i], deep[(j + 12) * nx + i], 1e-12);

        // The sides meet the base, where they would without it: no inward curl.
        const Surface surface = field.detect(points);
        ASSERT_EQ(surface.chains.size(), 1u);
        const SurfaceChain &chain   = surface.chains[0];
        unsigned int        n_bases = 0;
        for (std::size_t k = 0; k < chain.vertices.size(); ++k)
          if (chain.on_face[k] >= 0)
            {
              ++n_bases;
              EXPECT_EQ(chain.on_face[k], 2);
              const Point<2> &a = chain.vertices[k];
              const Point<2> &b =
                chain.vertices[(k + 1) % chain.vertices.size()];
              EXPECT_EQ(a[1], 0.);
              EXPECT_EQ(b[1], 0.);
              EXPECT_NEAR(a[0], 1., 0.15 * h);
              EXPECT_NEAR(b[0], 7., 0.15 * h);
              // The next vertex up, half-way to the top, is above.
              for (const Point<2> &v : chain.vertices)
                if (v[1] < 1. && v[0] < 4)
                  {
                    EXPECT_NEAR(v[0], a[0], 1e-12);
                  }
            }
        EXPECT_EQ(n_bases, 1u);
        // Two corners are rounded.
        EXPECT_NEAR(chain.area(), 12., 0.2 * h * 10);

        parameters.mirror = false;
        ProximityField<2> halved(grid, parameters, bottom_face);
        const auto       &half = halved.field(points);
        EXPECT_NEAR(half[nx + nx / 2] / f[nx + nx / 2], 0.5, 1e-12);
      }
  }



  TEST(Surface, corner_of_two_closed_faces_is_filled)
  {
    const double            h = 0.5;
    const BackgroundGrid<2> grid(Point<2>(0, 0),
                                 Point<2>(5, 5),
                                 h,
                                 MPI_COMM_SELF);
    ProximityField<2>       field(grid, SurfaceParameters(), 1u | bottom_face);
    const auto    points  = block(Point<2>(0, 0), Point<2>(3, 2), h / 2);
    const Surface surface = field.detect(points);
    ASSERT_EQ(surface.chains.size(), 1u);
    const SurfaceChain &chain = surface.chains[0];
    bool                left = false, bottom = false, corner = false;
    for (std::size_t k = 0; k < chain.vertices.size(); ++k)
      {
        left   = left || chain.on_face[k] == 0;
        bottom = bottom || chain.on_face[k] == 2;
        corner = corner || chain.vertices[k] == Point<2>(0, 0);
      }
    EXPECT_TRUE(left && bottom && corner);
    EXPECT_NEAR(chain.area(), 6., 0.3);

    // The field at the corner (node 1, 1) is that inside, 5 cells up.
    ProximityField<2> inner(grid, SurfaceParameters(), 0);
    const double      corner_value = field.field(points)[14];
    EXPECT_NEAR(corner_value,
                inner.field(
                  block(Point<2>(1, 1), Point<2>(4, 4), h / 2))[6 * 14],
                1e-12);
  }



  TEST(Surface, chains_are_closed_oriented_and_sorted)
  {
    const double            h = 0.25;
    const BackgroundGrid<2> grid(Point<2>(0, 0),
                                 Point<2>(12, 6),
                                 h,
                                 MPI_COMM_SELF);
    ProximityField<2>       field(grid, SurfaceParameters(), bottom_face);

    // A small block, a large one with a hole, and a disc that floats.
    const auto points =
      lattice(Point<2>(0, 0),
              Point<2>(12, 6),
              h / 2,
              Point<2>(),
              [](const double x, const double y) {
                const bool small = x > 0.5 && x < 2.5 && y < 1.5;
                const bool large = x > 4 && x < 9 && y < 5 &&
                                   !(x > 6 && x < 7.5 && y > 2 && y < 3.5);
                const bool disc = std::hypot(x - 10.7, y - 3) < 1;
                return small || large || disc;
              });
    Surface surface;
    surface.chains.resize(7); // what was there before goes
    field.detect(points, surface);
    ASSERT_EQ(surface.chains.size(), 4u);
    EXPECT_NEAR(surface.chains[0].area(), 25., 0.2);
    EXPECT_NEAR(surface.chains[1].area(), numbers::PI, 0.15);
    EXPECT_NEAR(surface.chains[2].area(), 3., 0.1);
    EXPECT_NEAR(surface.chains[3].area(), -2.25, 0.2);
    for (const SurfaceChain &chain : surface.chains)
      {
        ASSERT_EQ(chain.on_face.size(), chain.vertices.size());
        for (std::size_t k = 0; k < chain.vertices.size(); ++k)
          {
            const Point<2> &a = chain.vertices[k];
            const Point<2> &b = chain.vertices[(k + 1) % chain.vertices.size()];
            EXPECT_GT(a.distance(b), 1e-9 * h);
            if (chain.on_face[k] < 0)
              {
                EXPECT_LT(a.distance(b), 1.4143 * h); // within one cell
              }
          }
      }

    // Nothing: no surface.
    field.detect(MaterialPoints<2>(), surface);
    EXPECT_TRUE(surface.chains.empty());
  }



  TEST(Surface, body_in_the_margin_closes)
  {
    const BackgroundGrid<2> grid(Point<2>(0, 0),
                                 Point<2>(4, 4),
                                 0.25,
                                 MPI_COMM_SELF);
    ProximityField<2>       field(grid, SurfaceParameters(), 0);
    const auto    points  = block(Point<2>(-0.25, 1), Point<2>(2, 3), 0.125);
    const Surface surface = field.detect(points);
    ASSERT_EQ(surface.chains.size(), 1u);
    EXPECT_NEAR(surface.chains[0].area(), 4.5, 0.15);
    for (const int face : surface.chains[0].on_face)
      EXPECT_EQ(face, -1);
  }



  TEST(Surface, slice_in_3d_has_the_field_of_2d)
  {
    const double            h = 0.5;
    const BackgroundGrid<2> grid_2(Point<2>(0, 0),
                                   Point<2>(5, 3),
                                   h,
                                   MPI_COMM_SELF);
    const BackgroundGrid<3> grid_3(Point<3>(0, 0, 1),
                                   Point<3>(5, 3, 2.5),
                                   h,
                                   MPI_COMM_SELF);
    ProximityField<2>       field_2(grid_2, SurfaceParameters(), bottom_face);
    ProximityField<3> field_3(grid_3, SurfaceParameters(), bottom_face | 48u);

    const auto        points_2 = block(Point<2>(1, 0), Point<2>(4, 2), h / 2);
    MaterialPoints<3> points_3;
    for (int k = 0; k < 6; ++k)
      for (std::size_t p = 0; p < points_2.n_points(); ++p)
        add_point(points_3,
                  Point<3>(points_2.position[p][0],
                           points_2.position[p][1],
                           1 + h / 2 * (k + 0.5)),
                  points_2.volume[p] * h / 2);

    const auto &f2 = field_2.field(points_2);
    const auto &f3 = field_3.field(points_3);
    ASSERT_EQ(f2.size(), f3.size());
    for (std::size_t i = 0; i < f2.size(); ++i)
      ASSERT_NEAR(f2[i], f3[i], 1e-13);
    EXPECT_NEAR(field_2.detect(points_2).chains.at(0).area(),
                field_3.detect(points_3).chains.at(0).area(),
                1e-12);
  }



  TEST(Surface, parameters_of_the_surface_are_read)
  {
    SurfaceParameters parameters;
    ParameterHandler  prm;
    parameters.add_parameters(prm);
    prm.parse_input_from_string("set Kernel radius = 1.5\nset Threshold = 0.4\n"
                                "set Mirror = false\n");
    EXPECT_EQ(parameters.kernel_radius, 1.5);
    EXPECT_EQ(parameters.threshold, 0.4);
    EXPECT_FALSE(parameters.mirror);
    using WrongValue = ParameterHandler::ExcInvalidEntryForPattern;
    EXPECT_THROW(prm.parse_input_from_string("set Kernel radius = 3\n"),
                 WrongValue);
    EXPECT_THROW(prm.parse_input_from_string("set Threshold = 0\n"),
                 WrongValue);
    EXPECT_EQ(parameters.kernel_radius, 1.5);
    EXPECT_EQ(parameters.threshold, 0.4);
  }
} // namespace surface_proximity_field
