// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/mapping/stencil.h>
#include <waker/surface/domain_contour.h>

#include "mapping_lattice.h"
#include "user_errors.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace loads_contour_load
{
  // The load q on the contour of support domains that do not overlap is the
  // internal force of the stress q I in them, node by node: the divergence
  // theorem, for GIMP functions inside and linear ones on the contour.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.5;


    /// The linear function of a node at x, whose coordinate is x_node.
    double
    hat(const double x, const double x_node)
    {
      return std::max(0., 1. - std::abs(x - x_node) / h);
    }


    /// Domains of random sizes, each somewhere in its own place of a lattice:
    /// they touch or have gaps, but do not overlap.
    template <int dim>
    MaterialPoints<dim>
    scattered_domains(Lattice::Random &random, const double extent)
    {
      MaterialPoints<dim> points;
      const double        place = h / 2.;
      const int           n     = std::round(extent / place);
      int                 total = 1;
      for (int d = 0; d < dim; ++d)
        total *= n;
      const Tensor<1, dim> offset = random.vector<dim>(0., h);
      for (int p = 0; p < total; ++p)
        {
          if (random(0., 1.) < 0.3)
            continue;
          Point<dim>     x;
          Tensor<1, dim> l;
          double         volume = 1.;
          const bool     fills  = random(0., 1.) < 0.7;
          for (int d = 0, rest = p; d < dim; ++d, rest /= n)
            {
              l[d] = fills ? place / 2. : random(0.1, 0.5) * place;
              const double slack = place / 2. - l[d];
              x[d] =
                offset[d] + (rest % n + 0.5) * place + random(-1., 1.) * slack;
              volume *= 2. * l[d];
            }
          Lattice::add_point(points, x, volume, 0.);
          points.half_size.back() = l;
        }
      return points;
    }


    /// The integral of N_i n over the facets, per node. N_i is linear along a
    /// piece of an axis-parallel segment within a cell, and on such a rectangle
    /// in each direction: its mean over the corners is exact.
    std::vector<Tensor<1, 2>>
    nodal_areas(const BackgroundGrid<2> &grid, const Facets<2> &facets)
    {
      std::vector<Tensor<1, 2>> sum(grid.n_nodes());
      for (const Facet<2> &facet : facets)
        {
          const unsigned int d = std::abs(facet.normal[0]) > 0.5 ? 1 : 0;
          Point<2>           a = facet.vertices[0], end = facet.vertices[1];
          if (a[d] > end[d])
            std::swap(a, end);
          while (a[d] < end[d])
            {
              Point<2> b = a;
              b[d] = std::min(end[d], h * (std::floor(a[d] / h + 1e-12) + 1.));
              for (unsigned int i = 0; i < grid.n_nodes(); ++i)
                for (const Point<2> &x : {a, b})
                  {
                    const Point<2> node = grid.node_position(i);
                    sum[i] += 0.5 * (b[d] - a[d]) * hat(x[0], node[0]) *
                              hat(x[1], node[1]) * facet.normal;
                  }
              a = b;
            }
        }
      return sum;
    }


  } // namespace



  TEST(Loads, load_on_the_contour_is_the_internal_force)
  {
    const auto        grid = Lattice::grid<2>(4., h);
    SurfaceParameters parameters;
    parameters.minimum_gap_width  = 0.;
    parameters.minimum_gap_height = 0.;
    DomainContour<2> contour(grid, parameters, 0);
    Weights<2>       weights(grid, ShapeFunctions::gimp);
    const Stencil<2> stencil(grid);
    Lattice::Random  random(6);
    for (unsigned int set = 0; set < 50; ++set)
      {
        const MaterialPoints<2> points = scattered_domains<2>(random, 3.);
        weights.reinit(points);
        std::vector<Tensor<1, 2>> internal(grid.n_nodes());
        double                    volume = 0.;
        for (std::size_t p = 0; p < points.n_points(); ++p)
          {
            volume += points.volume[p];
            stencil.for_each_node(
              weights[p],
              [&](const unsigned int node, const double, const auto &gradient) {
                internal[node] += points.volume[p] * gradient;
              });
          }

        Facets<2> facets;
        contour.detect(points, facets);
        ASSERT_NEAR(enclosed_volume(facets), volume, 1e-12);
        ASSERT_GT(volume, 1.);
        const std::vector<Tensor<1, 2>> external = nodal_areas(grid, facets);
        for (unsigned int i = 0; i < grid.n_nodes(); ++i)
          ASSERT_LT((internal[i] - external[i]).norm(), 1e-13);
      }
  }



  TEST(Loads, contour_is_the_same_in_a_slice)
  {
    // Projected on the plane, a prismatic body in 3D has the chains of 2D, and
    // its true surface encloses their area times its thickness.
    const auto        plane = Lattice::grid<2>(4., h);
    const auto        space = Lattice::grid<3>(4., h);
    SurfaceParameters parameters;
    parameters.symmetric_filling = true;    // as it always is in 3D
    const unsigned int closed    = 1u | 4u; // left and bottom
    DomainContour<2>   contour_2d(plane, parameters, closed);
    DomainContour<3>   contour_3d(space, parameters, closed);
    Lattice::Random    random(7);
    for (unsigned int set = 0; set < 20; ++set)
      {
        MaterialPoints<2>  points = scattered_domains<2>(random, 2.5);
        MaterialPoints<3>  slice;
        const unsigned int n_layers = 3;
        for (std::size_t p = 0; p < points.n_points(); ++p)
          for (unsigned int layer = 0; layer < n_layers; ++layer)
            {
              Point<3>     x;
              Tensor<1, 3> l;
              for (unsigned int d = 0; d < 2; ++d)
                {
                  x[d] = points.position[p][d];
                  l[d] = points.half_size[p][d];
                }
              l[2] = 0.25 * h;
              x[2] = 1. + 0.5 * h * layer;
              Lattice::add_point(slice, x, 1., 0.);
              slice.half_size.back() = l;
            }

        Surface flat;
        Surface projected;
        contour_2d.detect(points, flat);
        contour_3d.detect(slice, projected);
        ASSERT_EQ(flat.chains.size(), projected.chains.size());
        for (std::size_t c = 0; c < flat.chains.size(); ++c)
          {
            ASSERT_EQ(flat.chains[c].on_face, projected.chains[c].on_face);
            ASSERT_EQ(flat.chains[c].vertices, projected.chains[c].vertices);
          }

        Facets<2> line;
        Facets<3> surface;
        contour_2d.detect(points, line);
        contour_3d.detect(slice, surface);
        ASSERT_NEAR(enclosed_volume(surface),
                    enclosed_volume(line) * 0.5 * h * n_layers,
                    1e-12);
      }
  }



  TEST(Loads, contour_refuses_gaps_as_large_as_a_domain)
  {
    const auto        grid = Lattice::grid<2>(1., h);
    SurfaceParameters parameters;
    parameters.minimum_gap_width = 1.;
    EXPECT_USER_ERROR(DomainContour<2>(grid, parameters, 0),
                      "Surface/Minimum gap width",
                      "is 1: gaps as large");
    parameters.minimum_gap_width  = 0.99;
    parameters.minimum_gap_height = 1.5;
    EXPECT_USER_ERROR(DomainContour<2>(grid, parameters, 0),
                      "Surface/Minimum gap height",
                      "is 1.5: gaps as large");
    parameters.minimum_gap_height = 0.;
    EXPECT_NO_THROW(DomainContour<2>(grid, parameters, 0));
  }
} // namespace loads_contour_load
