// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/surface/cell_surface.h>

#include <gtest/gtest.h>
#include <random>

namespace surface_cell_surface
{
  using namespace Waker;

  namespace
  {
    template <int dim>
    BackgroundGrid<dim>
    grid()
    {
      Point<dim> upper;
      for (unsigned int d = 0; d < dim; ++d)
        upper[d] = 5.;
      return BackgroundGrid<dim>(Point<dim>(), upper, 1., MPI_COMM_SELF);
    }


    /// A block of points with domains of half a cell.
    template <int dim>
    MaterialPoints<dim>
    block(const Point<dim> &lower, const std::array<unsigned int, dim> &n)
    {
      MaterialPoints<dim> points;
      unsigned int        total = 1;
      for (const unsigned int m : n)
        total *= m;
      points.resize(total);
      for (unsigned int p = 0; p < total; ++p)
        {
          unsigned int rest = p;
          points.volume[p]  = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            {
              points.position[p][d] = lower[d] + 0.25 + 0.5 * (rest % n[d]);
              rest /= n[d];
              points.half_size[p][d] = 0.25;
              points.volume[p] *= 0.5;
            }
        }
      return points;
    }


    template <int dim>
    double
    free_area(const Facets<dim> &facets)
    {
      double sum = 0.;
      for (const Facet<dim> &facet : facets)
        if (facet.on_face < 0)
          sum += facet.measure();
      return sum;
    }


    template <int dim>
    Tensor<1, dim>
    closing_error(const Facets<dim> &facets)
    {
      Tensor<1, dim> sum;
      for (const Facet<dim> &facet : facets)
        sum += facet.measure() * facet.normal;
      return sum;
    }
  } // namespace


  TEST(Surface, active_cells_are_those_that_a_point_or_a_domain_is_in)
  {
    const BackgroundGrid<2> g = grid<2>();
    CellSurface<2>          cells(g, 0);
    Facets<2>               facets;

    // From 1.3 to 2.8: two cells by GIMP, one row of them; by points as well.
    cells.find_active(block<2>(Point<2>(1.3, 2.), {{3, 2}}),
                      ShapeFunctions::gimp,
                      facets);
    EXPECT_EQ(enclosed_volume<2>(facets), 2.);
    EXPECT_EQ(free_area(facets), 6.);

    // From 1.8 to 3.3: three cells by GIMP; the outer ones hold points as
    // well: 2.05 is in the second.
    const MaterialPoints<2> points = block<2>(Point<2>(1.8, 2.), {{3, 2}});
    cells.find_active(points, ShapeFunctions::gimp, facets);
    EXPECT_EQ(enclosed_volume<2>(facets), 3.);
    cells.find_active(points, ShapeFunctions::linear, facets);
    EXPECT_EQ(enclosed_volume<2>(facets), 2.);

    // Domains that end on a line of the grid do not touch the cell behind it,
    // whatever the last digit says.
    std::mt19937                           random(1);
    std::uniform_real_distribution<double> noise(-1e-14, 1e-14);
    for (unsigned int k = 0; k < 100; ++k)
      {
        cells.find_active(
          block<2>(Point<2>(1. + noise(random), 2. + noise(random)), {{4, 2}}),
          ShapeFunctions::gimp,
          facets);
        ASSERT_EQ(enclosed_volume<2>(facets), 2.);
      }

    const BackgroundGrid<3> g3 = grid<3>();
    CellSurface<3>          cells_3(g3, 0);
    Facets<3>               facets_3;
    cells_3.find_active(block<3>(Point<3>(1.3, 2., 2.6), {{3, 2, 1}}),
                        ShapeFunctions::gimp,
                        facets_3);
    EXPECT_NEAR(enclosed_volume<3>(facets_3), 4., 1e-13);
    EXPECT_NEAR(free_area(facets_3), 16., 1e-13);
    EXPECT_LT(closing_error(facets_3).norm(), 1e-13);
  }


  TEST(Surface, closed_faces_are_marked)
  {
    const BackgroundGrid<2> g = grid<2>();
    CellSurface<2>          cells(g, 1u << 2); // the bottom
    Facets<2>               facets;
    cells.find_active(block<2>(Point<2>(1., 0.), {{4, 3}}),
                      ShapeFunctions::gimp,
                      facets);
    EXPECT_EQ(enclosed_volume<2>(facets), 4.);
    EXPECT_EQ(free_area(facets), 6.);
    for (const Facet<2> &facet : facets)
      EXPECT_EQ(facet.on_face, facet.normal[1] < 0. ? 2 : -1);
  }


  TEST(Surface, surface_by_volume_encloses_the_volume_of_the_points)
  {
    const BackgroundGrid<2> g = grid<2>();
    CellSurface<2>          cells(g, 0);
    Facets<2>               facets;
    // A block whose ends lie anywhere holds one or two columns of points in its
    // outermost cells.
    for (const double x : {1., 1.1, 1.24, 1.25, 1.4, 1.6, 1.75, 1.9})
      for (const double y : {0.5, 0.6, 0.75, 0.99, 1.})
        {
          const MaterialPoints<2> points = block<2>(Point<2>(x, y), {{5, 6}});
          cells.find_volume(points, "", facets);
          ASSERT_NEAR(enclosed_volume<2>(facets), 7.5, 1e-13) << x << " " << y;
          ASSERT_NEAR(free_area(facets), 2. * (2.5 + 3.), 1e-13);
          ASSERT_LT(closing_error(facets).norm(), 1e-13);
        }

    // One that leans on two closed faces.
    CellSurface<2> corner(g, 1u | 1u << 2);
    corner.find_volume(block<2>(Point<2>(0., 0.), {{5, 3}}), "", facets);
    EXPECT_NEAR(enclosed_volume<2>(facets), 2.5 * 1.5, 1e-13);
    EXPECT_NEAR(free_area(facets), 2.5 + 1.5, 1e-13);

    const BackgroundGrid<3> g3 = grid<3>();
    CellSurface<3>          cells_3(g3, 0);
    Facets<3>               facets_3;
    cells_3.find_volume(block<3>(Point<3>(0.6, 1.3, 0.9), {{5, 4, 6}}),
                        "",
                        facets_3);
    EXPECT_NEAR(enclosed_volume<3>(facets_3), 2.5 * 2. * 3., 1e-13);
    EXPECT_NEAR(free_area(facets_3),
                2. * (2.5 * 2. + 2. * 3. + 2.5 * 3.),
                1e-12);
  }


  TEST(Surface, surface_by_volume_is_refused_where_it_is_not_determined)
  {
    const BackgroundGrid<2> g = grid<2>();
    CellSurface<2>          cells(g, 0);
    Facets<2>               facets;
    const auto              refuses = [&](const MaterialPoints<2> &points) {
      try
        {
          cells.find_volume(points, "Tractions/a/Method", facets);
        }
      catch (const UserError &error)
        {
          EXPECT_EQ(error.where, "Tractions/a/Method");
          EXPECT_NE(error.allowed.find("contour"), std::string::npos);
          return true;
        }
      return false;
    };
    // Thinner than a cell; a slope of points; a hole.
    EXPECT_TRUE(refuses(block<2>(Point<2>(1., 1.), {{6, 1}})));
    EXPECT_FALSE(refuses(block<2>(Point<2>(1., 1.), {{6, 2}})));
    MaterialPoints<2> slope = block<2>(Point<2>(1., 1.), {{6, 6}});
    for (std::size_t p = 0; p < slope.n_points(); ++p)
      if (slope.position[p][0] + slope.position[p][1] > 5.1)
        slope.position[p] = Point<2>(1.25, 1.25);
    EXPECT_TRUE(refuses(slope));
  }
} // namespace surface_cell_surface
