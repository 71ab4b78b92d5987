// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/proximity_field.h>

#include "named.h"
#include "standing_water.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace loads_water_load
{
  using namespace Waker;

  namespace
  {
    constexpr unsigned int bottom_face = 1u << 2;

    // uGIMP function (Bardenhagen and Kober 2004) for half width l.
    double
    ugimp(const double d, const double h, const double l)
    {
      const double a = std::abs(d);
      if (a < l)
        return 1. - (d * d + l * l) / (2 * h * l);
      if (a < h - l)
        return 1. - a / h;
      if (a < h + l)
        return (h + l - a) * (h + l - a) / (4 * h * l);
      return 0.;
    }

    // Points of density 1, (h/2)^2 each, on a shifted lattice where `inside`.
    MaterialPoints<2>
    make_body(const BackgroundGrid<2>                               &grid,
              const Point<2>                                        &shift,
              const std::function<bool(const double, const double)> &inside)
    {
      MaterialPoints<2> points;
      const double      s = grid.cell_size() / 2;
      for (double y = (0.5 + shift[1]) * s; y < grid.upper_corner()[1]; y += s)
        for (double x = (0.5 + shift[0]) * s; x < grid.upper_corner()[0];
             x += s)
          if (inside(x, y))
            {
              points.id.push_back(points.id.size());
              points.position.emplace_back(x, y);
              points.volume.push_back(s * s);
            }
      return points;
    }

    std::vector<double>
    masses(const BackgroundGrid<2> &grid, const MaterialPoints<2> &points)
    {
      const double        h = grid.cell_size();
      std::vector<double> mass(grid.n_nodes(), 0.);
      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          const auto cell = grid.cell_index(points.position[p]);
          for (int j = -1; j < 3; ++j)
            for (int i = -1; i < 3; ++i)
              {
                const BackgroundGrid<2>::Index index = {
                  {cell[0] + i, cell[1] + j}};
                if (index[0] < 0 || index[1] < 0 ||
                    index[0] >= int(grid.n_nodes_per_direction()[0]) ||
                    index[1] >= int(grid.n_nodes_per_direction()[1]))
                  continue;
                const unsigned int node = grid.node(index);
                const auto d = points.position[p] - grid.node_position(node);
                mass[node] += points.volume[p] * ugimp(d[0], h, h / 4) *
                              ugimp(d[1], h, h / 4);
              }
        }
      return mass;
    }

    // Resultant of nodal forces in 2D.
    WaterResultant
    nodal_resultant(const BackgroundGrid<2> &grid, const NodalVector &force)
    {
      WaterResultant sum;
      for (unsigned int i = 0; i < grid.n_nodes(); ++i)
        {
          const Point<2> x  = grid.node_position(i);
          const double   fx = force.begin()[2 * i];
          const double   fy = force.begin()[2 * i + 1];
          sum.force[0] += fx;
          sum.force[1] += fy;
          sum.moment += x[0] * fy - x[1] * fx;
        }
      return sum;
    }

    WaterParameters
    water(const std::string &side, const double level)
    {
      WaterParameters parameters;
      parameters.side        = Named{side};
      parameters.level       = level;
      parameters.unit_weight = 9.81;
      return parameters;
    }
  } // namespace



  TEST(Loads, nodal_water_load_keeps_resultant_and_moment)
  {
    const double            h = 0.25;
    const BackgroundGrid<2> grid(Point<2>(0, 0),
                                 Point<2>(16, 5),
                                 h,
                                 MPI_COMM_SELF);
    ProximityField<2>       field(grid, SurfaceParameters(), bottom_face);
    std::mt19937            random(42);
    std::uniform_real_distribution<double> uniform(0., 1.);

    Surface     surface;
    NodalVector force(grid.n_dofs());
    double      largest_weight = 0., largest_miss = 0.;
    int         n_unsupported = 0, n_below_the_crest = 0;
    for (int k = 0; k < 1000; ++k)
      {
        // A dyke with slopes 1:1 to 1:3, its lattice anywhere in a cell.
        const Point<2> shift(2 * uniform(random) - 1, 2 * uniform(random) - 1);
        const double   toe   = 1. + h * uniform(random);
        const double   slope = 1. + 2. * uniform(random);
        const double   crest = 3. + h * uniform(random);
        const auto     points =
          make_body(grid, shift, [&](const double x, const double y) {
            return y > 0 && y < crest && y < (x - toe) / slope && y < 15.5 - x;
          });
        const std::vector<double> mass = masses(grid, points);

        const WaterParameters parameters = water("left", 4. * uniform(random));
        StandingWater<2>      load(grid, parameters);
        field.detect(points, surface);
        load.find(surface);
        force = 0.;
        load.add_nodal_forces(mass, h * h, force);

        const WaterResultant exact = load.resultant();
        const WaterResultant nodal = nodal_resultant(grid, force);
        const double         scale = 1e-12 * (exact.force.norm() + 1e-3);
        EXPECT_NEAR(nodal.force[0], exact.force[0], scale);
        EXPECT_NEAR(nodal.force[1], exact.force[1], scale);
        EXPECT_NEAR(nodal.moment, exact.moment, 10. * scale);

        // The pressure on the vertical projection of the surface.
        const double depth =
          load.segments().empty()
            ? 0.
            : parameters.level - load.segments()[0].vertices[0][1];
        if (depth > 0 && parameters.level < 2.5)
          {
            ++n_below_the_crest;
            EXPECT_NEAR(exact.force[0], 9.81 * depth * depth / 2, 1e-12);
          }

        const double minimum = parameters.minimum_support * h * h;
        for (unsigned int i = 0; i < grid.n_nodes(); ++i)
          if (mass[i] < minimum)
            {
              EXPECT_EQ(force.begin()[2 * i], 0.);
              EXPECT_EQ(force.begin()[2 * i + 1], 0.);
            }

        // How large do the weights get, near the surface?
        std::vector<SupportNode<2>> support;
        for (unsigned int i = 0; i < grid.n_nodes(); ++i)
          if (mass[i] < minimum && mass[i] > 0 &&
              grid.node_position(i)[1] > -h / 2)
            {
              ++n_unsupported;
              find_support<2>(
                mass.data(), minimum, grid.n_nodes_per_direction(), i, support);
              double sum = -1., x = 0., y = 0.;
              for (const SupportNode<2> &s : support)
                {
                  sum += s.weight;
                  x += s.weight * s.offset[0];
                  y += s.weight * s.offset[1];
                  largest_weight = std::max(largest_weight, std::abs(s.weight));
                }
              largest_miss = std::max(
                {largest_miss, std::abs(sum), std::abs(x), std::abs(y)});
            }
      }
    EXPECT_GT(n_unsupported, 1000);
    EXPECT_GT(n_below_the_crest, 400);
    EXPECT_LT(largest_miss, 1e-11);
    EXPECT_LE(largest_weight, 2.);
    RecordProperty("largest_weight", std::to_string(largest_weight));
    RecordProperty("unsupported_nodes", n_unsupported);
  }



  TEST(Loads, support_in_degenerate_cases)
  {
    const std::array<unsigned int, 2> n = {{6, 5}};
    std::vector<SupportNode<2>>       support;
    std::vector<double>               mass(30, 0.);
    find_support<2>(mass.data(), 0.5, n, 14, support);
    EXPECT_TRUE(support.empty());

    // One, then several on a line: the nearest, with the whole force.
    mass[0] = 1.;
    find_support<2>(mass.data(), 0.5, n, 14, support);
    ASSERT_EQ(support.size(), 1u);
    EXPECT_EQ(support[0].node, 0u);
    EXPECT_EQ(support[0].weight, 1.);
    mass.assign(30, 0.);
    for (const unsigned int i : {6, 7, 8, 9, 10})
      mass[i] = 1.;
    find_support<2>(mass.data(), 0.5, n, 14, support);
    ASSERT_EQ(support.size(), 1u);
    EXPECT_EQ(support[0].node, 8u);

    // Two rows: linear functions are reproduced.
    for (const unsigned int i : {0, 1, 2, 3, 4})
      mass[i] = 1.;
    find_support<2>(mass.data(), 0.5, n, 14, support);
    double sum = 0., x = 0., y = 0.;
    for (const SupportNode<2> &s : support)
      {
        sum += s.weight;
        x += s.weight * s.offset[0];
        y += s.weight * s.offset[1];
        EXPECT_LE(std::abs(s.weight), 2.);
      }
    EXPECT_NEAR(sum, 1., 1e-13);
    EXPECT_NEAR(x, 0., 1e-13);
    EXPECT_NEAR(y, 0., 1e-13);
  }



  TEST(Loads, mirrored_dyke_has_the_mirrored_load)
  {
    const double            h = 0.25, length = 12.;
    const BackgroundGrid<2> grid(Point<2>(0, 0),
                                 Point<2>(length, 5),
                                 h,
                                 MPI_COMM_SELF);
    ProximityField<2>       field(grid, SurfaceParameters(), bottom_face);
    auto                    points =
      make_body(grid, Point<2>(0.37, 0.61), [](const double x, const double y) {
        return y < 3.1 && y < (x - 1) / 1.7 && y < 11 - x;
      });

    StandingWater<2> left(grid, water("left", 2.3));
    left.find(field.detect(points));
    NodalVector force(grid.n_dofs());
    left.add_nodal_forces(masses(grid, points), h * h, force);

    for (Point<2> &x : points.position)
      x[0] = length - x[0];
    StandingWater<2> right(grid, water("right", 2.3));
    right.find(field.detect(points));
    NodalVector mirrored(grid.n_dofs());
    right.add_nodal_forces(masses(grid, points), h * h, mirrored);

    EXPECT_EQ(left.segments().size(), right.segments().size());
    EXPECT_GT(force.l2_norm(), 1.);
    const int nx = grid.n_nodes_per_direction()[0];
    for (unsigned int i = 0; i < grid.n_nodes(); ++i)
      {
        const unsigned int m = i - i % nx + (nx - 1 - i % nx);
        ASSERT_NEAR(force.begin()[2 * i], -mirrored.begin()[2 * m], 1e-11);
        ASSERT_NEAR(force.begin()[2 * i + 1],
                    mirrored.begin()[2 * m + 1],
                    1e-11);
      }
  }



  TEST(Loads, water_load_of_a_slice_in_3d)
  {
    const double            h = 0.5;
    const BackgroundGrid<2> grid_2(Point<2>(0, 0),
                                   Point<2>(8, 4),
                                   h,
                                   MPI_COMM_SELF);
    const BackgroundGrid<3> grid_3(Point<3>(0, 0, 0),
                                   Point<3>(8, 4, 3 * h),
                                   h,
                                   MPI_COMM_SELF);
    ProximityField<2>       field(grid_2, SurfaceParameters(), bottom_face);
    const auto              points =
      make_body(grid_2, Point<2>(0.2, 0.3), [](const double x, const double y) {
        return y < 3.1 && y < x - 1 && y < 7.3 - x;
      });
    const Surface             surface = field.detect(points);
    const std::vector<double> mass_2  = masses(grid_2, points);

    // Masses of a prismatic body: h inside, h / 2 at the ends.
    const unsigned int        n_plane = grid_2.n_nodes();
    std::vector<double>       mass_3(grid_3.n_nodes(), 0.);
    const std::vector<double> share = {0., 0.5, 1., 1., 0.5, 0.};
    for (unsigned int k = 0; k < share.size(); ++k)
      for (unsigned int i = 0; i < n_plane; ++i)
        mass_3[k * n_plane + i] = h * share[k] * mass_2[i];

    NodalVector      force_2(grid_2.n_dofs()), force_3(grid_3.n_dofs());
    StandingWater<2> load_2(grid_2, water("left", 2.2));
    StandingWater<3> load_3(grid_3, water("left", 2.2));
    load_2.find(surface);
    load_3.find(surface);
    load_2.add_nodal_forces(mass_2, h * h, force_2);
    load_3.add_nodal_forces(mass_3, h * h * h, force_3);
    EXPECT_GT(force_2.l2_norm(), 1.);
    EXPECT_NEAR(load_2.resultant().force[0],
                load_3.resultant().force[0],
                1e-14);
    for (unsigned int k = 0; k < share.size(); ++k)
      for (unsigned int i = 0; i < n_plane; ++i)
        {
          const unsigned int i3 = k * n_plane + i;
          for (unsigned int d = 0; d < 2; ++d)
            ASSERT_NEAR(force_3.begin()[3 * i3 + d],
                        h * share[k] * force_2.begin()[2 * i + d],
                        1e-12);
          ASSERT_EQ(force_3.begin()[3 * i3 + 2], 0.);
        }
  }
} // namespace loads_water_load
