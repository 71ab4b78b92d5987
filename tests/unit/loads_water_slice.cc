// SPDX-License-Identifier: LGPL-2.1-or-later
// One surface type: a body in the plane, a slice of it that is called prismatic
// and one that is not stand in the same water.
#include <waker/loads/water_load.h>
#include <waker/surface/surface_finder.h>

#include <cmath>
#include <gtest/gtest.h>

namespace loads_water_slice
{
  using namespace Waker;

  namespace
  {
    constexpr double h = 0.5, length = 1.5; // along z

    /// A dyke from x = 1 to 7 m, 2 m high, with steps of half a cell.
    template <int dim>
    MaterialPoints<dim>
    dyke()
    {
      MaterialPoints<dim> points;
      for (double z = h / 4; z < (dim == 3 ? length : h / 2); z += h / 2)
        for (double y = h / 4; y < 2.; y += h / 2)
          for (double x = 1. + h / 4; x < 7.; x += h / 2)
            {
              if (y > x - 1. || y > 7. - x)
                continue;
              Point<dim>     place;
              Tensor<1, dim> half;
              const double   all[3] = {x, y, z};
              for (unsigned int d = 0; d < dim; ++d)
                {
                  place[d] = all[d];
                  half[d]  = h / 4;
                }
              points.id.push_back(points.id.size());
              points.position.push_back(place);
              points.half_size.push_back(half);
              points.volume.push_back(std::pow(h / 2, dim));
            }
      return points;
    }


    /// What is found of the dyke, and what the water does to it.
    template <int dim>
    struct Seen
    {
      Seen(const SurfaceMethod method,
           const bool          prismatic,
           const WaterSide     side,
           const double        level)
        : grid(Point<dim>(),
               dim == 2 ? upper(0.) : upper(length),
               h,
               MPI_COMM_SELF)
        , points(dyke<dim>())
      {
        SurfaceParameters parameters;
        parameters.method    = method;
        parameters.prismatic = prismatic;
        SurfaceFinder<dim> finder(grid,
                                  parameters,
                                  ShapeFunctions::gimp,
                                  dim == 2 ? 0x04 : 0x34);
        finder.reset(points);
        section = finder.section();
        surface = finder.facets();
        WaterParameters water;
        water.side  = side;
        water.level = level;
        WaterLoad<dim> load(grid, water, parameters);
        load.find(finder, 0.);
        touches   = load.touches();
        wetted    = load.wetted();
        resultant = load.resultant();
        NodalVector force(grid.n_dofs());
        load.add_nodal_forces(std::vector<double>(grid.n_nodes(), 1.),
                              1.,
                              force);
        for (unsigned int i = 0; i < grid.n_nodes(); ++i)
          for (unsigned int d = 0; d < 2; ++d)
            nodal[d] += force.begin()[dim * i + d];
      }

      static Point<dim>
      upper(const double z)
      {
        Point<dim> x;
        x[0] = 8.;
        x[1] = 3.;
        if (dim == 3)
          x[dim - 1] = z;
        return x;
      }

      static double
      area(const Facets<dim> &facets)
      {
        double sum = 0.;
        for (const Facet<dim> &facet : facets)
          sum += facet.measure();
        return sum;
      }

      /// Of what facets enclose, by their sides alone.
      double
      volume() const
      {
        double sum = 0.;
        for (const Facet<dim> &facet : surface)
          for (const Point<dim> &x : facet.vertices)
            sum += x[0] * facet.normal[0] * facet.measure() / dim;
        return sum;
      }

      const BackgroundGrid<dim> grid;
      const MaterialPoints<dim> points;
      Facets<2>                 section;
      Facets<dim>               surface, wetted;
      WaterResultant            resultant;
      Tensor<1, 2>              nodal;
      bool                      touches;
    };


    void
    compare(const SurfaceMethod method, const WaterSide side)
    {
      const Seen<2> plane(method, false, side, 1.4);
      const Seen<3> slice(method, true, side, 1.4);
      const Seen<3> body(method, false, side, 1.4);

      // The section is the same, and is the surface or becomes it.
      ASSERT_EQ(plane.section.size(), slice.section.size());
      ASSERT_EQ(plane.section.size(), plane.surface.size());
      ASSERT_EQ(2 * slice.section.size(), slice.surface.size());
      for (std::size_t k = 0; k < plane.section.size(); ++k)
        for (unsigned int i = 0; i < 2; ++i)
          {
            const Point<2> &x = plane.section[k].vertices[i];
            EXPECT_EQ(x, plane.surface[k].vertices[i]);
            EXPECT_LT(x.distance(slice.section[k].vertices[i]), 1e-12);
            EXPECT_EQ(plane.section[k].chain, 0);
            EXPECT_EQ(slice.surface[2 * k + i].chain, 0);
            EXPECT_EQ(slice.surface[2 * k + i].on_face,
                      plane.section[k].on_face);
          }
      EXPECT_GT(plane.volume(), 7.);
      EXPECT_NEAR(slice.volume(), length * plane.volume(), 1e-12);

      // Water reaches the same, and presses alike.
      EXPECT_TRUE(plane.touches && slice.touches && body.touches);
      const double wet = length * plane.area(plane.wetted);
      EXPECT_GT(wet, length * 1.4);
      EXPECT_NEAR(slice.area(slice.wetted), wet, 1e-12);
      const Tensor<1, 2> force = plane.resultant.force;
      const double       sign  = side == WaterSide::left ? 1. : -1.;
      EXPECT_NEAR(force[0], sign * 10. * 1.4 * 1.4 / 2., 0.1);
      EXPECT_LT((slice.resultant.force - force).norm(), 1e-12);
      EXPECT_NEAR(slice.resultant.moment, plane.resultant.moment, 1e-12);
      EXPECT_LT((plane.nodal - force).norm(), 1e-12);
      EXPECT_LT((slice.nodal - length * force).norm(), 1e-12);
      EXPECT_LT((body.nodal - length * body.resultant.force).norm(), 1e-12);
      if (method != SurfaceMethod::contour)
        return; // the kernel of three dimensions is another one
      EXPECT_NEAR(body.area(body.wetted), wet, 1e-12);
      EXPECT_LT((body.resultant.force - force).norm(), 1e-12);
      EXPECT_NEAR(body.resultant.moment, plane.resultant.moment, 1e-11);
      for (const Facet<3> &facet : body.surface)
        EXPECT_EQ(facet.chain, -1);
    }
  } // namespace


  TEST(Loads, water_in_the_plane_is_that_on_a_slice)
  {
    for (const WaterSide side : {WaterSide::left, WaterSide::right})
      {
        compare(SurfaceMethod::contour, side);
        compare(SurfaceMethod::proximity_field, side);
      }
  }


  TEST(Loads, without_water_nothing_is_wet)
  {
    const Seen<2> none(SurfaceMethod::contour, false, WaterSide::none, 1.4);
    EXPECT_FALSE(none.touches);
    EXPECT_TRUE(none.wetted.empty());
    EXPECT_EQ(none.nodal.norm(), 0.);
    const Seen<3> below(SurfaceMethod::contour, true, WaterSide::left, -0.1);
    EXPECT_FALSE(below.touches);
    EXPECT_TRUE(below.wetted.empty());
  }
} // namespace loads_water_slice
