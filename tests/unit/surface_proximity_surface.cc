// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/proximity_field.h>

#include "verification_data.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace surface_proximity_surface
{
  using namespace Waker;

  namespace
  {
    constexpr unsigned int bottom_face = 1u << 2;
    constexpr unsigned int side_faces  = 16u | 32u; // along z

    // Points at (k + 1/2 + offset) s in [from, to], s^3 each.
    MaterialPoints<3>
    make_body(const Point<3>                              &from,
              const Point<3>                              &to,
              const double                                 s,
              const Point<3>                              &offset,
              const std::function<bool(const Point<3> &)> &inside)
    {
      MaterialPoints<3> points;
      for (double z = from[2] + (0.5 + offset[2]) * s; z < to[2]; z += s)
        for (double y = from[1] + (0.5 + offset[1]) * s; y < to[1]; y += s)
          for (double x = from[0] + (0.5 + offset[0]) * s; x < to[0]; x += s)
            if (inside(Point<3>(x, y, z)))
              {
                points.id.push_back(points.id.size());
                points.position.emplace_back(x, y, z);
                points.volume.push_back(s * s * s);
              }
      return points;
    }
  } // namespace



  TEST(Surface, kernel_in_3d_integrates_to_one)
  {
    const double            h = 0.25;
    const BackgroundGrid<3> grid(Point<3>(-1, -1, -1),
                                 Point<3>(1, 1, 1),
                                 h,
                                 MPI_COMM_SELF);
    for (const double radius : {0.5, 0.8, 1., 1.25, 2.})
      {
        SurfaceParameters parameters;
        parameters.kernel_radius = radius;
        ProximitySurface field(grid, parameters, 0);
        double           sum = 0;
        const int        n   = 12;
        for (int k = 0; k < n * n * n; ++k)
          {
            MaterialPoints<3> points;
            points.id.push_back(0);
            points.position.emplace_back(h * (k % n + 0.5) / n,
                                         h * (k / n % n + 0.5) / n,
                                         h * (k / n / n + 0.5) / n);
            points.volume.push_back(3.);
            for (const double f : field.field(points))
              sum += f * h * h * h;
          }
        EXPECT_NEAR(sum / (n * n * n), 3., 0.03) << "radius " << radius;
      }
  }



  // Height of a flat top, minus the edge of the support domains, over offsets
  // of the points in a cell. References: an independent computation in Python.
  // The data of doc/verification/surface_3d.md.
  TEST(Surface, flat_face_in_3d_has_no_mean_offset)
  {
    struct Reference
    {
      double radius, inward, outward;
    };
    const double            h = 1.;
    const BackgroundGrid<3> grid(Point<3>(0, 0, 0),
                                 Point<3>(6, 7, 6),
                                 h,
                                 MPI_COMM_SELF);
    for (const Reference &r : {Reference{0.75, -0.1551, 0.1498},
                               Reference{1., -0.0939, 0.0906},
                               Reference{1.5, -0.0409, 0.0392},
                               Reference{2., -0.0209, 0.0226}})
      {
        SurfaceParameters parameters;
        parameters.kernel_radius = r.radius;
        ProximityField<3> field(grid, parameters, bottom_face);

        double       sum = 0., lowest = 1., highest = -1.;
        unsigned int n        = 0;
        const int    n_offset = 20;
        Facets<3>    facets;
        for (int j = 0; j < n_offset; ++j)
          {
            double       row_sum = 0., row_lowest = 1., row_highest = -1.;
            unsigned int row_n = 0;
            for (int k = 0; k < n_offset / 2 * n_offset / 2; ++k)
              {
                const Point<3> shift((k % (n_offset / 2) + 0.5) / n_offset,
                                     (j + 0.5) / n_offset,
                                     (k / (n_offset / 2) + 0.5) / n_offset);
                const double   top = 3. + shift[1];
                const auto     points =
                  make_body(Point<3>(-1, 0, -1),
                            Point<3>(7, top, 7),
                            0.5 * h,
                            2. * shift,
                            [](const Point<3> &) { return true; });
                field.detect(points, facets);
                for (const Facet<3> &facet : facets)
                  for (const Point<3> &v : facet.vertices)
                    // crossings of vertical edges, away from the sides
                    if (v[1] > 2 && std::abs(v[0] - 3) < 1e-9 &&
                        std::abs(v[2] - 3) < 1e-9)
                      {
                        row_sum += v[1] - top;
                        row_lowest  = std::min(row_lowest, v[1] - top);
                        row_highest = std::max(row_highest, v[1] - top);
                        ++row_n;
                      }
              }
            Verification::row("surface_3d_flat_face",
                              "radius_h,offset_h,crossings,mean_h,inward_h,"
                              "outward_h",
                              r.radius,
                              (j + 0.5) / n_offset,
                              row_n,
                              row_sum / row_n,
                              row_lowest,
                              row_highest);
            sum += row_sum;
            n += row_n;
            lowest  = std::min(lowest, row_lowest);
            highest = std::max(highest, row_highest);
          }
        ASSERT_GE(n, 1000u);
        EXPECT_NEAR(sum / n, 0., 0.002) << "radius " << r.radius;
        EXPECT_NEAR(lowest, r.inward, 1e-3) << "radius " << r.radius;
        EXPECT_NEAR(highest, r.outward, 1e-3) << "radius " << r.radius;
      }
  }



  // The detected volume and area of a ball of points, over places of the ball
  // and of the points in a cell, against the cell size: an error of second
  // order. The data of doc/verification/surface_3d.md.
  TEST(Surface, detected_volume_of_a_ball_converges)
  {
    std::mt19937                           random(3);
    std::uniform_real_distribution<double> uniform(0., 1.);
    const int                              sizes[4] = {4, 6, 9, 13};
    double                                 errors[4];
    for (int k = 0; k < 4; ++k)
      {
        const double            h = 1. / sizes[k]; // cells to a radius
        const double            l = std::ceil(1.3 * sizes[k]) * h;
        const BackgroundGrid<3> grid(Point<3>(-l, -l, -l),
                                     Point<3>(l, l, l),
                                     h,
                                     MPI_COMM_SELF);
        ProximityField<3>       field(grid, SurfaceParameters(), 0);
        double                  volume = 0., area = 0., scatter = 0.;
        const int               n = 50;
        for (int position = 0; position < n; ++position)
          {
            Point<3> centre, offset;
            for (unsigned int d = 0; d < 3; ++d)
              {
                centre[d] = h * (uniform(random) - 0.5);
                offset[d] = uniform(random);
              }
            const auto points =
              make_body(Point<3>(-l, -l, -l),
                        Point<3>(l, l, l),
                        h / 2,
                        offset,
                        [&](const Point<3> &x) {
                          return x.distance_square(centre) < 1.;
                        });
            Facets<3> facets;
            field.detect(points, facets);
            const double error =
              enclosed_volume(facets) / (4. / 3. * numbers::PI) - 1.;
            volume += error / n;
            scatter += error * error / n;
            double sum = 0.;
            for (const Facet<3> &facet : facets)
              sum += facet.measure();
            area += (sum / (4. * numbers::PI) - 1.) / n;
          }
        scatter   = std::sqrt(scatter - volume * volume);
        errors[k] = std::abs(volume);
        Verification::row("surface_3d_ball",
                          "cells_per_radius,positions,volume_error,scatter,"
                          "area_error",
                          sizes[k],
                          n,
                          volume,
                          scatter,
                          area);
      }
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(std::log(errors[k] / errors[k + 1]) /
                    std::log(double(sizes[k + 1]) / sizes[k]),
                  2.,
                  0.25);
    EXPECT_LT(errors[3], 0.007);
  }



  TEST(Surface, mirrors_in_3d)
  {
    const double            h = 0.25;
    const BackgroundGrid<3> grid(Point<3>(0, 0, 0),
                                 Point<3>(3, 2, 1),
                                 h,
                                 MPI_COMM_SELF);
    const BackgroundGrid<3> deep_grid(Point<3>(-1, -1, -1),
                                      Point<3>(3, 2, 2),
                                      h,
                                      MPI_COMM_SELF);
    for (const double radius : {0.75, 1., 1.6, 2.})
      {
        SurfaceParameters parameters;
        parameters.kernel_radius = radius;
        ProximitySurface field(grid, parameters, 1u | bottom_face | side_faces);
        ProximitySurface deep_field(deep_grid, parameters, 0);

        // The lattice goes on beyond the faces: there the field is the same.
        const auto whole = [](const Point<3> &) { return true; };
        const auto points =
          make_body(Point<3>(), Point<3>(2, 1.5, 1), h / 2, Point<3>(), whole);
        const auto &f    = field.field(points);
        const auto &deep = deep_field.field(make_body(
          Point<3>(-1, -1, -1), Point<3>(2, 1.5, 2), h / 2, Point<3>(), whole));
        for (unsigned int i = 0; i < grid.n_nodes(); ++i)
          {
            BackgroundGrid<3>::Index index     = grid.node_index(i);
            bool                     is_in_box = true;
            for (unsigned int d = 0; d < 3; ++d)
              {
                is_in_box = is_in_box && index[d] > 0;
                index[d] += 4;
              }
            is_in_box = is_in_box && index[2] < 9 + 1;
            if (!is_in_box)
              continue;
            ASSERT_NEAR(f[i], deep[deep_grid.node(index)], 1e-12);
          }

        // Closed along the faces; the free ones meet them squarely.
        Facets<3> facets;
        field.detect(points, facets);
        double area[6] = {}, top = 0.;
        for (const Facet<3> &facet : facets)
          if (facet.on_face >= 0)
            area[facet.on_face] += facet.measure();
          else if (facet.normal[1] > 0.99)
            top = facet.vertices[0][1];
        EXPECT_NEAR(area[0], top * 1., 0.02) << radius;
        EXPECT_NEAR(area[2], 2., 0.05) << radius;
        EXPECT_NEAR(area[4], area[5], 1e-12);
        EXPECT_NEAR(enclosed_volume(facets), area[4] * 1., 1e-10) << radius;
        EXPECT_EQ(area[1] + area[3], 0.);
      }
  }



  // A slice between closed sides: how near is its section to that in 2D? The
  // kernel of 3D, integrated along z, is narrower than that of 2D.
  TEST(Surface, slice_in_3d_is_near_the_contour_in_2d)
  {
    const double            h = 0.5;
    const BackgroundGrid<3> grid(Point<3>(0, 0, 0),
                                 Point<3>(10, 4, 4 * h),
                                 h,
                                 MPI_COMM_SELF);
    ProximityField<3>       field(grid,
                            SurfaceParameters(),
                            bottom_face | side_faces);
    double                  largest = 0., mean = 0.;
    for (int k = 0; k < 50; ++k)
      {
        const Point<3> offset(0.02 * k, 0.38 * k - std::floor(0.38 * k), 0.);
        const auto     points = make_body(Point<3>(0, 0, 0),
                                      Point<3>(10, 4, 4 * h),
                                      h / 2,
                                      offset,
                                      [](const Point<3> &x) {
                                        return x[1] < 3.1 && x[1] < x[0] - 1 &&
                                               x[1] < (9.3 - x[0]) / 1.5;
                                      });
        Surface        section;
        Facets<3>      facets;
        field.detect(points, section);
        field.detect(points, facets);
        const double error = enclosed_volume(facets) / (4 * h) /
                               enclosed_volume(to_facets(section)) -
                             1.;
        largest = std::max(largest, std::abs(error));
        mean += error / 50;
        for (const Facet<3> &facet : facets)
          ASSERT_NEAR(facet.on_face < 0 ? facet.normal[2] : 0., 0., 1e-12);
      }
    // Some 15 m round 17 m^2: 0.02 h on the mean.
    EXPECT_NEAR(mean, 0., 0.008);
    EXPECT_LT(largest, 0.03);
    RecordProperty("mean", std::to_string(mean));
    RecordProperty("largest", std::to_string(largest));
  }
} // namespace surface_proximity_surface
