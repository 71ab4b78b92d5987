// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/grid/background_grid.h>
#include <waker/measures/soil_at_sides.h>
#include <waker/particles/material_points.h>
#include <waker/particles/openings.h>

#include <gtest/gtest.h>

namespace measures_against_side
{
  using namespace Waker;

  namespace
  {
    constexpr double h = 0.5;

    /// A row of points with a quarter of a cell each, in a box of 10 x 4 m from
    /// x = -2 on.
    struct Row
    {
      Row()
        : grid(Point<2>(-2., -3.), Point<2>(8., 1.), h, MPI_COMM_SELF)
      {}

      void
      add(const double x, const double y = -2.9)
      {
        const std::size_t p = points.n_points();
        points.resize(p + 1);
        points.position[p] = points.initial_position[p] = Point<2>(x, y);
        points.volume[p]                                = 0.25 * h * h;
      }

      bool
      lies() const
      {
        return lies_against_side(
          grid, soil_at_sides(grid, points, Openings<2>(grid)));
      }

      /// With an opening in a side, from a height (m) on.
      bool
      lies(const BoxFace open, const double from) const
      {
        OutletParameters outlet;
        outlet.face = open;
        outlet.from = {0., from};
        Openings<2> openings(grid);
        openings.add(place_opening(grid, outlet, ""));
        return lies_against_side(grid, soil_at_sides(grid, points, openings));
      }

      BackgroundGrid<2> grid;
      MaterialPoints<2> points;
    };
  } // namespace


  TEST(Measures, soil_that_reaches_a_side_of_the_box)
  {
    for (const double side : {0., 1.})
      {
        const double sign = side > 0. ? 1. : -1.;
        Row          row;
        row.add(3.);
        row.add(3.1);
        EXPECT_FALSE(row.lies());
        const double last =
          3. + sign * 4.6; // in the last cell, 0.4 m from the end
        row.points.position[0][0] = last;
        EXPECT_FALSE(row.lies()); // a quarter of a cell is a crumb
        row.points.position[1][0] = 3. + sign * 4.4; // the last but one
        EXPECT_FALSE(row.lies());
        row.points.position[1][0] = last;
        EXPECT_TRUE(row.lies());
        EXPECT_DOUBLE_EQ(soil_at_sides(row.grid,
                                       row.points,
                                       Openings<2>(row.grid))
                           .volume[side > 0.],
                         0.5 * h * h);
        // What passes an open side lies against nothing: it lies at y = -2.9.
        EXPECT_EQ(row.lies(BoxFace::left, -3.), side > 0.);
        EXPECT_EQ(row.lies(BoxFace::right, -3.), side == 0.);
        EXPECT_TRUE(row.lies(BoxFace::left, -2.5));
        EXPECT_TRUE(row.lies(BoxFace::right, -2.5));
      }
  }


  TEST(Measures, a_foundation_that_reaches_the_side_is_no_slide)
  {
    Row row;
    for (double x = -1.875; x < 8.; x += 0.25)
      for (double y = -2.875; y < 0.; y += 0.25)
        row.add(x, y);
    EXPECT_FALSE(row.lies());
    // Pressed to the right by 0.4 cells: a column of points crosses the line.
    for (Point<2> &x : row.points.position)
      x[0] += 0.4 * h;
    EXPECT_FALSE(row.lies());
    // Carried over it by a whole cell, it lies against it.
    for (std::size_t p = 0; p < row.points.n_points(); ++p)
      row.points.position[p][0] = row.points.initial_position[p][0] + h;
    EXPECT_TRUE(row.lies());
  }
} // namespace measures_against_side
