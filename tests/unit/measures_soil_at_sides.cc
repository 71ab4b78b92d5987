// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/grid/background_grid.h>
#include <waker/measures/soil_at_sides.h>
#include <waker/particles/material_points.h>
#include <waker/particles/openings.h>

#include <gtest/gtest.h>

namespace measures_soil_at_sides
{
  namespace
  {
    using namespace Waker;


    template <int dim>
    void
    add_point(const Point<dim>    &from,
              const Point<dim>    &to,
              const double         volume,
              MaterialPoints<dim> &points)
    {
      points.id.push_back(points.id.size());
      points.volume.push_back(volume);
      points.initial_position.push_back(from);
      points.position.push_back(to);
    }


    TEST(SoilAtSides, counts_what_has_come_into_the_last_cells)
    {
      const BackgroundGrid<2> grid({-2., 0.}, {8., 3.}, 0.5, MPI_COMM_SELF);
      MaterialPoints<2>       points;
      EXPECT_EQ(soil_at_sides(grid, points, Openings<2>(grid)).worst_face(),
                -1);
      add_point<2>({0., 1.}, {7.4, 1.}, 4., points); // not there yet
      EXPECT_EQ(soil_at_sides(grid, points, Openings<2>(grid)).worst_face(),
                -1);
      add_point<2>({0., 1.}, {7.6, 1.}, 3., points);   // the right face
      add_point<2>({7.7, 1.}, {7.8, 0.1}, 2., points); // was there before
      add_point<2>({0., 1.}, {8.1, 1.}, 1., points);   // in the margin
      add_point<2>({0., 1.}, {0., -0.1}, 5., points);  // the base is no side
      add_point<2>({0., 1.}, {-1.7, 1.}, 5., points);  // the left face
      const SoilAtSides<2> sides =
        soil_at_sides(grid, points, Openings<2>(grid));
      EXPECT_EQ(sides.n_points, (std::array<std::size_t, 4>{{1, 2, 0, 0}}));
      EXPECT_DOUBLE_EQ(sides.share[0], 0.25);
      EXPECT_DOUBLE_EQ(sides.share[1], 0.2);
      EXPECT_EQ(sides.share[2], 0.);
      EXPECT_EQ(sides.worst_face(), 0);
    }


    TEST(SoilAtSides, has_four_sides_in_three_dimensions)
    {
      const BackgroundGrid<3> grid({0., 0., 0.},
                                   {4., 4., 4.},
                                   1.,
                                   MPI_COMM_SELF);
      MaterialPoints<3>       points;
      add_point<3>({2., 2., 2.}, {2., 3.9, 3.5}, 1., points);
      add_point<3>({2., 2., 2.}, {2., 2., 2.}, 3., points);
      const SoilAtSides<3> sides =
        soil_at_sides(grid, points, Openings<3>(grid));
      EXPECT_EQ(sides.n_points,
                (std::array<std::size_t, 6>{{0, 0, 0, 0, 0, 1}}));
      EXPECT_DOUBLE_EQ(sides.share[5], 0.25);
      EXPECT_EQ(sides.worst_face(), 5);
    }
  } // namespace
} // namespace measures_soil_at_sides
