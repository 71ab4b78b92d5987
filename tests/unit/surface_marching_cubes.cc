// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/marching_cubes.h>
#include <waker/surface/marching_squares.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace surface_marching_cubes
{
  using namespace Waker;

  namespace
  {
    using Coordinates = std::array<std::vector<double>, 3>;
    using Values      = std::vector<double>;

    Coordinates
    lattice(const std::array<int, 3> &n, const double h, const Point<3> &origin)
    {
      Coordinates x;
      for (unsigned int d = 0; d < 3; ++d)
        for (int i = 0; i < n[d]; ++i)
          x[d].push_back(origin[d] + h * i);
      return x;
    }

    Values
    sample(const Coordinates                             &x,
           const std::function<double(const Point<3> &)> &f)
    {
      Values values;
      for (const double z : x[2])
        for (const double y : x[1])
          for (const double x_i : x[0])
            values.push_back(f(Point<3>(x_i, y, z)));
      return values;
    }

    TriangleMesh
    trace(const Coordinates &x,
          const Values      &values,
          const double       threshold,
          const unsigned int closed_faces = 0)
    {
      MarchingCubes      contour(x, closed_faces);
      TriangleMesh       mesh;
      const unsigned int row = x[0].size();
      contour.trace(values.data(),
                    {{row, row * static_cast<unsigned int>(x[1].size())}},
                    threshold,
                    mesh);
      return mesh;
    }

    Facets<3>
    all_facets(const TriangleMesh &mesh)
    {
      Facets<3> facets;
      to_facets(mesh, -1., facets);
      return facets;
    }

    double
    area(const Facets<3> &facets)
    {
      double sum = 0.;
      for (const Facet<3> &facet : facets)
        sum += facet.measure();
      return sum;
    }

    // The edges that are passed unequally often in the two directions, and
    // those with more than two triangles.
    std::pair<int, int>
    count_open_and_multiple_edges(const TriangleMesh &mesh)
    {
      std::map<std::pair<unsigned int, unsigned int>, std::pair<int, int>>
        edges;
      for (const auto &t : mesh.triangles)
        for (unsigned int k = 0; k < 3; ++k)
          {
            const unsigned int a = t[k], b = t[(k + 1) % 3];
            auto              &edge = edges[std::minmax({a, b})];
            edge.first += a < b ? 1 : -1;
            ++edge.second;
          }
      std::pair<int, int> n(0, 0);
      for (const auto &[key, edge] : edges)
        {
          n.first += edge.first != 0;
          n.second += edge.second > 2;
        }
      return n;
    }
  } // namespace



  // Every edge in two triangles, once in each direction: on fields where all
  // 256 cells and all saddles occur, with closed and open sides.
  TEST(Surface, marching_cubes_is_closed_and_oriented)
  {
    const Coordinates x = lattice({{12, 11, 10}}, 0.5, Point<3>(-1, 2, 0));
    std::mt19937      random(5);
    std::uniform_real_distribution<double> uniform(0., 1.);
    std::size_t                            n_triangles = 0, n_closed = 0;
    for (int k = 0; k < 200; ++k)
      {
        const double       share  = uniform(random);
        Values             values = sample(x, [&](const Point<3> &) {
          const double f = uniform(random);
          // Exact ties with the threshold and with each other.
          return k % 2 == 0 ? f : std::round(4 * (f + share - 0.5)) / 4;
        });
        const unsigned int closed = random() % 64;
        const TriangleMesh mesh   = trace(x, values, 0.5, closed);
        const auto         n      = count_open_and_multiple_edges(mesh);
        ASSERT_EQ(n.first, 0) << "field " << k;
        ASSERT_EQ(n.second, 0) << "field " << k;
        ASSERT_EQ(mesh.triangles.size(), mesh.on_face.size());
        n_triangles += mesh.triangles.size();

        // Oriented outwards: the body has a positive volume, and at a node
        // inside the surface goes round it once.
        const Facets<3> facets = all_facets(mesh);
        ASSERT_TRUE(facets.empty() || enclosed_volume(facets) > 0.);
        for (const Facet<3> &facet : facets)
          if (facet.on_face >= 0 && facet.measure() > 1e-12)
            {
              const unsigned int d    = facet.on_face / 2;
              const bool         up   = facet.on_face % 2 == 1;
              const double       wall = up ? x[d].back() : x[d].front();
              ++n_closed;
              ASSERT_TRUE(closed >> facet.on_face & 1u);
              for (const Point<3> &v : facet.vertices)
                ASSERT_NEAR(v[d], wall, 1e-14);
              ASSERT_NEAR(facet.normal[d], up ? 1. : -1., 1e-12);
            }
      }
    EXPECT_GT(n_triangles, 100000u);
    EXPECT_GT(n_closed, 1000u);
  }



  TEST(Surface, sphere_by_marching_cubes_converges_with_second_order)
  {
    // A field that is not linear along the edges; the sphere anywhere in a
    // cell.
    const double   radius = 1.;
    const Point<3> centre(0.137, -0.061, 0.219);
    double         volume_error[3], area_error[3];
    for (int k = 0; k < 3; ++k)
      {
        const double      h = 0.2 / (1 << k);
        const int         n = std::lround(2.8 / h) + 1;
        const Coordinates x =
          lattice({{n, n, n}}, h, Point<3>(-1.4, -1.4, -1.4));
        const Facets<3> facets = all_facets(
          trace(x,
                sample(x,
                       [&](const Point<3> &p) {
                         return std::max(0.,
                                         1. - p.distance_square(centre) / 2. /
                                                (radius * radius));
                       }),
                0.5));
        volume_error[k] =
          std::abs(enclosed_volume(facets) / (4. / 3. * numbers::PI) - 1.);
        area_error[k] = std::abs(area(facets) / (4. * numbers::PI) - 1.);
        for (const Facet<3> &facet : facets)
          ASSERT_TRUE(facet.measure() < 1e-9 ||
                      facet.normal * (facet.vertices[0] - centre) > 0.);
      }
    for (int k = 0; k < 2; ++k)
      {
        EXPECT_NEAR(std::log2(volume_error[k] / volume_error[k + 1]), 2., 0.03);
        EXPECT_NEAR(std::log2(area_error[k] / area_error[k + 1]), 2., 0.03);
      }
    EXPECT_LT(volume_error[2], 2e-3);
    EXPECT_LT(area_error[2], 2e-3);
    RecordProperty("volume_error", std::to_string(volume_error[2]));
    RecordProperty("area_error", std::to_string(area_error[2]));
  }



  // The surface of a prismatic field is that of marching squares, saddles
  // included.
  TEST(Surface, prismatic_field_has_the_section_of_marching_squares)
  {
    const Coordinates x = lattice({{9, 8, 4}}, 0.25, Point<3>());
    std::mt19937      random(8);
    std::uniform_real_distribution<double> uniform(0., 1.);
    for (int k = 0; k < 100; ++k)
      {
        Values plane(x[0].size() * x[1].size());
        for (double &f : plane)
          f = uniform(random);
        Values values;
        for (std::size_t i = 0; i < x[2].size(); ++i)
          values.insert(values.end(), plane.begin(), plane.end());

        const unsigned int closed = random() % 16;
        MarchingSquares    squares({{x[0], x[1]}}, closed);
        Surface            section;
        squares.trace(plane.data(), x[0].size(), 0.5, section);

        const Facets<3> facets =
          all_facets(trace(x, values, 0.5, closed | 16u | 32u));
        const double length = x[2].back() - x[2].front();
        double       free = 0., closed_area = 0., in_section = 0., faces = 0.;
        for (const Facet<3> &facet : facets)
          if (facet.on_face < 0)
            {
              free += facet.measure();
              ASSERT_NEAR(facet.measure() * facet.normal[2], 0., 1e-12);
            }
          else if (facet.on_face < 4)
            closed_area += facet.measure();
        for (const SurfaceChain &chain : section.chains)
          for (std::size_t i = 0; i < chain.vertices.size(); ++i)
            (chain.on_face[i] < 0 ? in_section : faces) +=
              chain.vertices[i].distance(
                chain.vertices[(i + 1) % chain.vertices.size()]);
        EXPECT_NEAR(free, length * in_section, 1e-12);
        EXPECT_NEAR(closed_area, length * faces, 1e-12);
        EXPECT_NEAR(enclosed_volume(facets),
                    length * enclosed_volume(to_facets(section)),
                    1e-12);
      }
  }



  TEST(Surface, mirrored_field_has_the_mirrored_surface)
  {
    const Coordinates x = lattice({{8, 8, 8}}, 1., Point<3>(-3.5, -3.5, -3.5));
    std::mt19937      random(13);
    std::uniform_real_distribution<double> uniform(0., 1.);
    Values                                 values =
      sample(x, [&](const Point<3> &) { return uniform(random); });
    const Facets<3> facets = all_facets(trace(x, values, 0.5));

    // Of loops in space, the fan from their mean has no handedness.
    for (unsigned int d = 0; d < 3; ++d)
      {
        Values mirrored(values.size());
        for (int k = 0; k < 8; ++k)
          for (int j = 0; j < 8; ++j)
            for (int i = 0; i < 8; ++i)
              mirrored[(k * 8 + j) * 8 + i] =
                values[((d == 2 ? 7 - k : k) * 8 + (d == 1 ? 7 - j : j)) * 8 +
                       (d == 0 ? 7 - i : i)];
        const Facets<3> others = all_facets(trace(x, mirrored, 0.5));
        EXPECT_NEAR(enclosed_volume(others), enclosed_volume(facets), 1e-12);
        EXPECT_NEAR(area(others), area(facets), 1e-11);
        EXPECT_EQ(others.size(), facets.size());
      }
  }
} // namespace surface_marching_cubes
