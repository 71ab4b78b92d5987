// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/top_view.h>

#include <algorithm>
#include <gtest/gtest.h>

namespace Waker::measures_top_view
{
  namespace
  {
    constexpr double h    = 0.5; // cells; squares of 0.25 m
    constexpr double side = 0.5 * h;
    constexpr double base = -1.; // the grid's lower face

    template <int dim>
    BackgroundGrid<dim>
    make_grid()
    {
      Point<dim> lower, upper;
      lower[0] = 10.;
      lower[1] = base;
      upper[0] = 12.; // 8 squares
      upper[1] = 2.;
      if (dim == 3)
        {
          lower[dim - 1] = 5.;
          upper[dim - 1] = 6.; // 4 squares
        }
      return {lower, upper, h, MPI_COMM_SELF};
    }


    /// A point in the middle of square (i, k), the n-th from the base.
    template <int dim>
    void
    add_point(MaterialPoints<dim> &points,
              const double         i,
              const double         n,
              const double         k,
              const std::uint64_t  id)
    {
      points.resize(points.n_points() + 1);
      Point<dim> x;
      x[0] = 10. + (i + 0.5) * side;
      x[1] = base + (n + 0.5) * side;
      if (dim == 3)
        x[dim - 1] = 5. + (k + 0.5) * side;
      points.id.back()       = id;
      points.position.back() = points.initial_position.back() = x;
      for (unsigned int d = 0; d < dim; ++d)
        points.half_size.back()[d] = 0.5 * side;
    }


    /// Number of points above each other.
    unsigned int
    layers(const unsigned int i, const unsigned int k)
    {
      return (3 * i + 5 * k) % 4;
    }


    template <int dim>
    void
    test_columns()
    {
      const BackgroundGrid<dim> grid = make_grid<dim>();
      const unsigned int        n_z  = dim == 3 ? 4 : 1;
      MaterialPoints<dim>       points;
      for (unsigned int k = 0; k < n_z; ++k)
        for (unsigned int i = 0; i < 8; ++i)
          for (unsigned int n = 0; n < layers(i, k); ++n)
            add_point(points, i, n, k, 1000 * k + 10 * i + n);

      const TopView<dim> view(grid, points);
      ASSERT_EQ(view.n_x, 8u);
      ASSERT_EQ(view.n_z, n_z);
      EXPECT_EQ(view.side, side);
      EXPECT_EQ(view.x, 10.);
      EXPECT_EQ(view.z, dim == 3 ? 5. : 0.);
      unsigned int n_empty = 0;
      for (unsigned int k = 0; k < n_z; ++k)
        for (unsigned int i = 0; i < 8; ++i)
          {
            const unsigned int n = layers(i, k);
            EXPECT_EQ(view.has_soil(i, k), n > 0);
            EXPECT_NEAR(view.height[8 * k + i], base + n * side, 1e-14);
            if (n > 0)
              EXPECT_EQ(points.id[view.point[8 * k + i]],
                        1000 * k + 10 * i + n - 1);
            else
              ++n_empty;
          }
      EXPECT_EQ(n_empty, dim == 3 ? 8u : 2u);
    }
  } // namespace


  TEST(TopView, shows_the_top_of_each_column)
  {
    test_columns<2>();
    test_columns<3>();
  }


  TEST(TopView, a_point_is_seen_where_it_covers_the_middle_or_else_reaches_to)
  {
    const BackgroundGrid<3> grid = make_grid<3>();
    // 0.4 of a square further along x, 0.6 along z: over the middle of square
    // (3, 2), and a part of each neighbour at one side.
    MaterialPoints<3> points;
    add_point(points, 3.4, 0, 1.6, 7);
    const auto seen = [&](const unsigned int i, const unsigned int k) {
      const TopView<3> view(grid, points);
      return view.has_soil(i, k) ? points.id[view.point[k * 8 + i]]
                                 : std::uint64_t(0);
    };
    for (unsigned int k = 0; k < 4; ++k)
      for (unsigned int i = 0; i < 8; ++i)
        EXPECT_EQ(seen(i, k),
                  (i == 3 || i == 4) && (k == 1 || k == 2) ? 7u : 0u);

    // A lower one is seen where it covers a middle, a higher one of which
    // only a part is there is not.
    points.position[0][1] += side;
    add_point(points, 4., 0, 2., 8);
    EXPECT_EQ(seen(3, 2), 7u);
    EXPECT_EQ(seen(4, 2), 8u);
    EXPECT_EQ(seen(4, 1), 7u);
  }


  TEST(TopView, soil_outside_of_the_box_is_not_seen)
  {
    MaterialPoints<3> points;
    add_point(points, -1., 0, 0, 1);
    add_point(points, 8., 0, 0, 2);
    add_point(points, 0., 0, 4., 3);
    add_point(points, 7., 0, 3., 4);
    const TopView<3> view(make_grid<3>(), points);
    EXPECT_EQ(std::count_if(view.point.begin(),
                            view.point.end(),
                            [](const int p) { return p >= 0; }),
              1);
    EXPECT_EQ(view.point[3 * 8 + 7], 3);
  }


  TEST(TopView, does_not_depend_on_the_order_of_the_points)
  {
    for (const bool reversed : {false, true})
      {
        MaterialPoints<3> points;
        // Two that reach equally high, and one below.
        std::vector<std::pair<std::uint64_t, double>> list = {{5, 2.},
                                                              {6, 1.},
                                                              {4, 2.}};
        if (reversed)
          std::reverse(list.begin(), list.end());
        for (const auto &[id, n] : list)
          add_point(points, 2, n, 1, id);
        const TopView<3> view(make_grid<3>(), points);
        ASSERT_TRUE(view.has_soil(2, 1));
        EXPECT_EQ(points.id[view.point[1 * 8 + 2]], 4u);
      }
  }
} // namespace Waker::measures_top_view
