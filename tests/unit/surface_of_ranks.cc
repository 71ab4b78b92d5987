// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/grid/partition.h>
#include <waker/particles/point_exchange.h>
#include <waker/surface/proximity_field.h>

#include <cmath>
#include <gtest/gtest.h>
#include <random>

// Of one rank and, by tests/cases/ranks.py, of several.

namespace surface_of_ranks
{
  using namespace Waker;

  /// A hill on the bottom, and a ball above it that leaves the box on the left,
  /// with points anywhere.
  MaterialPoints<3>
  hill_and_ball()
  {
    std::mt19937                           random(5);
    std::uniform_real_distribution<double> number(0., 1.);
    MaterialPoints<3>                      points;
    while (points.n_points() < 12000)
      {
        const Point<3> x(4. * number(random),
                         2. * number(random),
                         3. * number(random));
        const bool     in_hill =
          x[1] < 0.7 + 0.4 * std::sin(1.7 * x[0]) * std::cos(x[2]);
        if (!in_hill && x.distance(Point<3>(0.3, 1.6, 1.4)) > 0.35)
          continue;
        points.id.push_back(points.n_points());
        points.position.push_back(x);
        points.volume.push_back(1e-3);
      }
    return points;
  }


  /// Each rank has all facets of the whole body, in the same order.
  void
  is_that_of_the_whole(const double radius, const unsigned int closed_faces)
  {
    const BackgroundGrid<3> grid(Point<3>(),
                                 Point<3>(4, 2, 3),
                                 0.25,
                                 MPI_COMM_WORLD);
    Partition<3>            partition(grid, MPI_COMM_WORLD);
    const MaterialPoints<3> whole = hill_and_ball();
    PointExchange<3>        exchange(partition, MPI_COMM_WORLD, whole);
    partition.balance(exchange.own().position);
    exchange.send_home(partition);

    SurfaceParameters parameters;
    parameters.kernel_radius            = radius;
    const std::array<double, 6> setback = {{0., 0., 0.02, 0., 0., 0.}};
    ProximityField<3>           one(grid, parameters, closed_faces, setback);
    ProximityField<3>           many(grid, parameters, closed_faces, setback);
    Facets<3>                   expected, found;
    one.detect(whole, expected);
    ASSERT_GT(expected.size(), 500u);
    const auto compare = [&]() {
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t f = 0; f < found.size(); ++f)
        {
          EXPECT_EQ(found[f].on_face, expected[f].on_face);
          EXPECT_NEAR((found[f].normal - expected[f].normal).norm(), 0., 1e-6);
          for (unsigned int k = 0; k < 3; ++k)
            EXPECT_NEAR(found[f].vertices[k].distance(expected[f].vertices[k]),
                        0.,
                        1e-11);
        }
    };
    const auto on_ranks = [&]() {
      return Body<3>(exchange.own(),
                     partition.make_window(),
                     [&]() -> const MaterialPoints<3> & { return whole; });
    };
    many.detect(on_ranks(), found);
    compare();
    // The field of the whole, for output; then on windows that are new.
    const std::vector<double> &field = many.nodal_values(whole);
    ASSERT_EQ(field.size(), grid.n_nodes());
    for (std::size_t node = 0; node < field.size(); ++node)
      EXPECT_NEAR(field[node], one.nodal_values(whole)[node], 1e-12);
    Partition<3> even(grid, MPI_COMM_WORLD);
    exchange.send_home(even);
    many.detect(Body<3>(exchange.own(),
                        even.make_window(),
                        [&]() -> const MaterialPoints<3> & { return whole; }),
                found);
    compare();
  }


  TEST(Ranks, SurfaceIsThatOfTheWhole)
  {
    for (const double radius : {1., 2.})
      for (const unsigned int closed_faces : {0u, 1u << 2, 63u})
        is_that_of_the_whole(radius, closed_faces);
  }
} // namespace surface_of_ranks
