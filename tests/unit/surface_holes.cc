// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/loads/traction.h>
#include <waker/surface/surface_finder.h>

#include "named.h"
#include <cmath>
#include <gtest/gtest.h>

namespace surface_holes
{
  using namespace Waker;

  namespace
  {
    /// A block of side 5 m on a lattice of points, two per metre, perhaps with
    /// a hole of side 2 m in its middle, and a loose block of side 1 m in front
    /// of it.
    template <int dim>
    MaterialPoints<dim>
    two_blocks(const bool with_hole)
    {
      MaterialPoints<dim> points;
      const auto          fill = [&](const double from,
                            const double to,
                            const double x0,
                            const bool   hollow) {
        const int n = std::lround(2. * (to - from));
        for (int k = 0; k < (dim == 3 ? n : 1); ++k)
          for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
              {
                const int  index[3] = {i, j, k};
                Point<dim> x;
                bool       inside = hollow;
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    x[d]   = from + 0.5 * index[d] + 0.25;
                    inside = inside && x[d] > 3.5 && x[d] < 5.5;
                  }
                x[0] += x0;
                if (inside)
                  continue;
                Tensor<1, dim> half;
                for (unsigned int d = 0; d < dim; ++d)
                  half[d] = 0.25;
                points.position.push_back(x);
                points.half_size.push_back(half);
                points.volume.push_back(std::pow(0.5, dim));
                points.id.push_back(points.id.size());
              }
      };
      fill(2., 7., 0., with_hole);
      fill(2., 3., 7., false);
      return points;
    }


    template <int dim>
    void
    test_holes(const std::string &method)
    {
      Point<dim> upper;
      for (unsigned int d = 0; d < dim; ++d)
        upper[d] = d == 0 ? 12. : 9.;
      const BackgroundGrid<dim> grid(Point<dim>(), upper, 1., MPI_COMM_SELF);
      SurfaceParameters         surface_parameters;
      surface_parameters.method = Named{method};
      SurfaceFinder<dim> finder(grid,
                                surface_parameters,
                                ShapeFunctions::gimp,
                                0);
      const auto         volume = [&](const bool with_hole, const bool holes) {
        const MaterialPoints<dim> points = two_blocks<dim>(with_hole);
        finder.reset(points);
        TractionParameters parameters;
        parameters.kind  = TractionKind::pressure;
        parameters.value = "1";
        parameters.holes = holes;
        Traction<dim> traction(parameters, 1e-9);
        Facets<dim>   part;
        traction.select(finder.facets(found_by(surface_parameters.method),
                                      "test"),
                        part);
        return enclosed_volume(part);
      };

      // The hole does not reach the outside, so that is as without a hole.
      const double solid = volume(false, true);
      EXPECT_NEAR(volume(false, false), solid, 1e-10);
      EXPECT_NEAR(volume(true, false), solid, 1e-10);
      const double hole = solid - volume(true, true);
      if (method == name_of(SurfaceMethod::contour))
        {
          EXPECT_NEAR(solid, std::pow(5., dim) + 1., 1e-10);
          EXPECT_NEAR(hole, std::pow(2., dim), 1e-10);
        }
      else
        EXPECT_GT(hole, 0.);
    }
  } // namespace


  TEST(Surface, holes_are_known_in_the_plane)
  {
    test_holes<2>("contour");
    test_holes<2>("proximity field");
  }


  TEST(Surface, holes_are_known_in_space)
  {
    test_holes<3>("contour");
    test_holes<3>("proximity field");
  }
} // namespace surface_holes
