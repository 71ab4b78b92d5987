// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/particles/rows.h>
#include <waker/particles/soil_profile.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace particles_rows
{
  namespace
  {
    using namespace Waker;

    LayerParameters
    layer(const std::string &polygon)
    {
      LayerParameters l;
      l.name     = "bar";
      l.material = "clay";
      l.polygon  = polygon;
      return l;
    }

    template <int dim>
    MaterialPoints<dim>
    make(const BackgroundGrid<dim>          &grid,
         const std::vector<LayerParameters> &layers,
         const unsigned int                  n = 2)
    {
      MaterialPointParameters parameters;
      parameters.placement            = Placement::rows;
      parameters.points_per_direction = n;
      return make_material_points(grid, layers, parameters, {"clay"}, {2.});
    }

    BackgroundGrid<2>
    plane(const double h = 1.)
    {
      return BackgroundGrid<2>(Point<2>(-1., 0.),
                               Point<2>(9., 4.),
                               h,
                               MPI_COMM_SELF);
    }

    /// The path of the error, "" if there is none.
    template <int dim>
    std::string
    where_it_fails(const BackgroundGrid<dim> &grid, const LayerParameters &l)
    {
      try
        {
          make(grid, {l});
        }
      catch (const UserError &e)
        {
          return e.where;
        }
      return "";
    }

    template <int dim>
    double
    volume(const MaterialPoints<dim> &points)
    {
      double sum = 0.;
      for (const double v : points.volume)
        sum += v;
      return sum;
    }

    /// Do any two support domains have an area in common?
    template <int dim>
    bool
    domains_overlap(const MaterialPoints<dim> &points)
    {
      for (std::size_t p = 0; p < points.n_points(); ++p)
        for (std::size_t q = 0; q < p; ++q)
          {
            bool apart = false;
            for (unsigned int d = 0; d < dim; ++d)
              apart = apart ||
                      std::abs(points.position[p][d] - points.position[q][d]) >
                        points.half_size[p][d] + points.half_size[q][d] - 1e-12;
            if (!apart)
              return true;
          }
      return false;
    }
  } // namespace


  TEST(Rows, slope_cuts_the_middle_of_the_outermost_sides)
  {
    const auto   grid   = plane();
    const double offset = 0.37, tangent = 0.5;
    // Left edge x = offset + y tan(theta), right edge upright.
    const auto points = make(grid, {layer("0.37,0; 6.37,0; 6.37,3; 1.87,3")});
    for (unsigned int row = 0; row < 6; ++row)
      {
        const double y     = 0.25 + 0.5 * row;
        const double left  = offset + tangent * y;
        double       begin = 100., end = -100.;
        unsigned int n = 0;
        for (std::size_t p = 0; p < points.n_points(); ++p)
          if (std::abs(points.position[p][1] - y) < 1e-12)
            {
              ++n;
              const double x = points.position[p][0],
                           l = points.half_size[p][0];
              begin          = std::min(begin, x - l);
              end            = std::max(end, x + l);
              EXPECT_NEAR(l,
                          (6.37 - left) / std::round((6.37 - left) / .5) / 2.,
                          1e-13);
              EXPECT_EQ(points.half_size[p][1], 0.25);
            }
        EXPECT_EQ(n, std::round((6.37 - left) / 0.5));
        EXPECT_NEAR(begin, left, 1e-12);
        EXPECT_NEAR(end, 6.37, 1e-12);
      }
    EXPECT_FALSE(domains_overlap(points));
    EXPECT_NEAR(volume(points), 3. * 6. - 0.5 * 1.5 * 3., 1e-12);
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        EXPECT_DOUBLE_EQ(points.volume[p],
                         4. * points.half_size[p][0] * points.half_size[p][1]);
        EXPECT_DOUBLE_EQ(points.mass[p], 2. * points.volume[p]);
        EXPECT_EQ(points.id[p], p);
        EXPECT_EQ(points.position[p], points.initial_position[p]);
      }
  }


  TEST(Rows, a_block_on_the_lattice_is_as_with_sub_cells)
  {
    const auto              grid = plane(0.5);
    const LayerParameters   l    = layer("0,0; 5,0; 5,2; 0,2");
    const auto              rows = make(grid, {l});
    MaterialPointParameters sub_cells;
    const auto              points =
      make_material_points(grid, {l}, sub_cells, {"clay"}, {2.});
    ASSERT_EQ(rows.n_points(), points.n_points());
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        EXPECT_LT(rows.position[p].distance(points.position[p]), 1e-13);
        EXPECT_LT((rows.half_size[p] - points.half_size[p]).norm(), 1e-13);
      }
  }


  TEST(Rows, layers_that_are_not_convex_have_several_stretches)
  {
    // A U, of which the arms are 1.3 and 0.2 m wide, the gap 2.5 m.
    const auto points =
      make(plane(),
           {layer("0,0; 4,0; 4,2; 3.8,2; 3.8,0.5; 1.3,0.5; 1.3,2; 0,2")});
    EXPECT_NEAR(volume(points), 2. + 1.5 * 1.5, 1e-12);
    EXPECT_FALSE(domains_overlap(points));
    unsigned int thin = 0;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const Point<2> x = points.position[p];
        EXPECT_TRUE(x[1] < 0.5 || x[0] < 1.3 || x[0] > 3.8);
        thin += std::abs(points.half_size[p][0] - 0.1) < 1e-13;
      }
    EXPECT_EQ(thin, 3u);
  }


  TEST(Rows, no_domain_is_wider_than_a_cell)
  {
    // One point per cell and a row of 1.4 cells: one rectangle would be wider.
    for (const unsigned int n : {1, 2, 3})
      for (const char *const width : {"1.4", "1.02", "0.3", "2.45"})
        {
          const std::string x(width);
          const auto        points =
            make(plane(), {layer("0,0; " + x + ",0; " + x + ",1; 0,1")}, n);
          EXPECT_NEAR(volume(points), std::stod(x), 1e-12);
          for (std::size_t p = 0; p < points.n_points(); ++p)
            EXPECT_LE(points.half_size[p][0], 0.5 + 1e-14);
        }
  }


  TEST(Rows, corners_inside_rows_are_told)
  {
    // The top lies 0.05 m into a row whose middle is 0.25 m up: the row is
    // empty.
    EXPECT_EQ(where_it_fails(plane(), layer("0,0; 4,0; 4,1.05; 0,1.05")),
              "Material points/Placement");
    // 0.02 of 3 m are missed: less than 1 %.
    const auto points = make(plane(), {layer("0,0; 4,0; 4,3.02; 0,3.02")});
    EXPECT_NEAR(volume(points), 12., 1e-12);
    // Filled above its middle.
    EXPECT_NEAR(volume(make(plane(), {layer("0,0; 4,0; 4,2.98; 0,2.98")})),
                12.,
                1e-12);
  }


  TEST(Rows, corner_at_mid_height)
  {
    // Corners at the mid-height of rows, where edges turn back or go on.
    const Polygon       diamond = {{{2., 0.5}},
                                   {{4., 2.5}},
                                   {{2., 4.5}},
                                   {{0., 2.5}}};
    const auto          rows    = fill_rows(diamond, 2.);
    std::vector<double> width(5, 0.);
    for (const RowRectangle &r : rows)
      width[r.row] += r.end - r.begin;
    EXPECT_EQ(width, std::vector<double>({0., 2., 4., 2., 0.}));
  }


  TEST(Rows, layers_side_by_side_meet)
  {
    const auto points =
      make(plane(),
           {layer("0,0; 3,0; 4.7,2; 0,2"), layer("3,0; 7,0; 7,2; 4.7,2")});
    EXPECT_NEAR(volume(points), 14., 1e-12);
    EXPECT_FALSE(domains_overlap(points));
  }


  TEST(Rows, extruded_in_3d)
  {
    const BackgroundGrid<3> grid(Point<3>(-1., 0., 0.),
                                 Point<3>(7., 4., 2.),
                                 1.,
                                 MPI_COMM_SELF);
    const BackgroundGrid<2> flat(Point<2>(-1., 0.),
                                 Point<2>(7., 4.),
                                 1.,
                                 MPI_COMM_SELF);
    LayerParameters         l = layer("0.37,0; 6.37,0; 6.37,3; 1.87,3");
    l.extent                  = {0.1, 1.5};
    const auto points         = make(grid, {l});
    EXPECT_EQ(points.n_points(), 3 * make(flat, {layer(l.polygon)}).n_points());
    EXPECT_NEAR(volume(points), 1.4 * (18. - 2.25), 1e-12);
    EXPECT_FALSE(domains_overlap(points));
    for (std::size_t p = 0; p < points.n_points(); ++p)
      EXPECT_NEAR(points.half_size[p][2], 1.4 / 6., 1e-14);
  }


  TEST(Particles, initial_stress_follows_its_expressions)
  {
    LayerParameters l = layer("0,0; 4,0; 4,2; 0,2");
    l.initial_stress  = "-1; -20*(2 - y); if(x < 2, 3, 4); x*y";
    const auto points = make(plane(), {l});
    ASSERT_GT(points.n_points(), 0u);
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const Point<2> x = points.position[p];
        EXPECT_EQ(points.stress[p][0][0], -1.);
        EXPECT_DOUBLE_EQ(points.stress[p][1][1], -20. * (2. - x[1]));
        EXPECT_EQ(points.stress[p][2][2], x[0] < 2. ? 3. : 4.);
        EXPECT_DOUBLE_EQ(points.stress[p][0][1], x[0] * x[1]);
        EXPECT_EQ(points.stress[p][0][2], 0.);
        EXPECT_EQ(points.stress[p][1][2], 0.);
      }

    const BackgroundGrid<3> block(Point<3>(0., 0., 0.),
                                  Point<3>(2., 2., 2.),
                                  1.,
                                  MPI_COMM_SELF);
    l                = layer("0,0; 2,0; 2,2; 0,2");
    l.initial_stress = "1; 2; 3; 4; 5; z";
    const auto q     = make(block, {l});
    for (std::size_t p = 0; p < q.n_points(); ++p)
      {
        const SymmetricTensor<2, 3> &s = q.stress[p];
        EXPECT_EQ(s[0][0], 1.);
        EXPECT_EQ(s[1][1], 2.);
        EXPECT_EQ(s[2][2], 3.);
        EXPECT_EQ(s[0][1], 4.);
        EXPECT_EQ(s[0][2], 5.);
        EXPECT_EQ(s[1][2], q.position[p][2]);
      }
  }


  TEST(Particles, wrong_initial_stress_is_told)
  {
    for (const char *const wrong : {"1",
                                    "1; 2; 3",
                                    "1; 2; 3; 4; 5; 6",
                                    "1; ; 3; 4",
                                    "1; 2; 3; t",
                                    "1; 2; 3; a",
                                    "1; 2; 3; 1/(y - y)"})
      {
        LayerParameters l = layer("0,0; 4,0; 4,2; 0,2");
        l.initial_stress  = wrong;
        EXPECT_EQ(where_it_fails(plane(), l), "Soil profile/bar/Initial stress")
          << wrong;
      }
  }
} // namespace particles_rows
