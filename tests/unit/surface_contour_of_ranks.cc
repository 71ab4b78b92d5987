// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/grid/partition.h>
#include <waker/particles/point_exchange.h>
#include <waker/surface/cell_surface.h>
#include <waker/surface/domain_contour.h>

#include "user_errors.h"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

// Of one rank and, by tests/cases/ranks.py, of several.

namespace surface_contour_of_ranks
{
  using namespace Waker;

  constexpr double h = 0.3; // no binary fraction

  template <int dim>
  BackgroundGrid<dim>
  make_grid()
  {
    Point<dim> upper;
    for (unsigned int d = 0; d < dim; ++d)
      upper[d] = h * (d == 0 ? 14 : 7);
    return {Point<dim>(), upper, h, MPI_COMM_WORLD};
  }


  /// A hill on the bottom, whose domains lie in rows with gaps that are filled
  /// and others that are not, and a few stones above it.
  template <int dim>
  MaterialPoints<dim>
  hill(const double noise)
  {
    std::mt19937                           random(5);
    std::uniform_real_distribution<double> number(-1., 1.);
    MaterialPoints<dim>                    points;
    const double                           spacing = h / 2.;
    const unsigned int                     n_z     = dim == 3 ? 14 : 1;
    for (unsigned int i = 0; i < 28; ++i)
      for (unsigned int j = 0; j < 14; ++j)
        for (unsigned int k = 0; k < n_z; ++k)
          {
            Point<dim> x;
            x[0]                  = (i + 0.5) * spacing;
            x[1]                  = (j + 0.5) * spacing;
            x[dim - 1]            = dim == 3 ? (k + 0.5) * spacing : x[1];
            const double z        = dim == 3 ? x[2] : 0.;
            const bool   is_stone = (7 * i + 5 * j + 3 * k) % 41 == 0;
            const bool   is_soil =
              x[1] < 1. + 0.6 * std::sin(2.1 * x[0]) * std::cos(z);
            if (!is_soil && !is_stone)
              continue;
            Tensor<1, dim> l;
            for (unsigned int d = 0; d < dim; ++d)
              {
                x[d] += noise * spacing * number(random);
                l[d] = 0.5 * spacing * (1. + 0.3 * noise * number(random));
                x[d] = std::max(x[d], 1e-3);
              }
            // One among them is much larger, on a part of the ranks.
            if (dim == 2 && points.n_points() == 100)
              l[0] *= 6.;
            points.id.push_back(points.n_points());
            points.position.push_back(x);
            points.half_size.push_back(l);
            points.volume.push_back(std::pow(spacing, dim));
          }
    return points;
  }


  /// Points dealt out to the ranks.
  template <int dim>
  struct Parts
  {
    explicit Parts(const MaterialPoints<dim> &whole)
      : grid(make_grid<dim>())
      , partition(grid, MPI_COMM_WORLD)
      , exchange(partition, MPI_COMM_WORLD, whole)
    {
      partition.balance(exchange.own().position);
      exchange.send_home(partition);
    }

    /// Nobody sees the whole one.
    Body<dim>
    body()
    {
      return Body<dim>(exchange.own(),
                       partition.make_window(),
                       []() -> const MaterialPoints<dim> & {
                         throw std::logic_error("the whole body is asked for");
                       });
    }

    BackgroundGrid<dim> grid;
    Partition<dim>      partition;
    PointExchange<dim>  exchange;
  };


  template <int dim>
  void
  are_the_same(const Facets<dim> &found, const Facets<dim> &expected)
  {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t f = 0; f < found.size(); ++f)
      {
        EXPECT_EQ(found[f].on_face, expected[f].on_face);
        for (unsigned int k = 0; k < dim; ++k)
          EXPECT_NEAR(found[f].vertices[k].distance(expected[f].vertices[k]),
                      0.,
                      1e-14);
      }
  }


  template <int dim>
  void
  check_contour(const double noise, const unsigned int closed_faces)
  {
    const MaterialPoints<dim> whole = hill<dim>(noise);
    Parts<dim>                parts(whole);
    SurfaceParameters         parameters;
    parameters.minimum_gap_width  = 0.5;
    parameters.minimum_gap_height = 0.4;
    DomainContour<dim> one(parts.grid, parameters, closed_faces);
    DomainContour<dim> many(parts.grid, parameters, closed_faces);
    Facets<dim>        expected, found;
    one.detect(whole, expected);
    many.detect(parts.body(), found);
    EXPECT_GT(found.size(), 50u);
    are_the_same(found, expected);
    // The section; and on an even partition, some ranks of which have no point.
    const Partition<dim> even(parts.grid, MPI_COMM_WORLD);
    parts.exchange.send_home(even);
    const Body<dim> other(parts.exchange.own(), even.make_window(), nullptr);
    Surface         chains, chains_found;
    one.detect(whole, chains);
    many.detect(other, chains_found);
    many.detect(other, found);
    are_the_same(found, expected);
    are_the_same(to_facets(chains_found), to_facets(chains));
  }


  TEST(Ranks, ContourIsThatOfTheWhole)
  {
    for (const double noise : {0., 0.7})
      for (const unsigned int closed_faces : {0u, 1u << 2})
        {
          check_contour<2>(noise, closed_faces);
          check_contour<3>(noise, closed_faces);
        }
    check_contour<3>(0.1, 63u);
  }


  template <int dim>
  void
  check_cells(const unsigned int closed_faces)
  {
    const MaterialPoints<dim> whole = hill<dim>(0.3);
    Parts<dim>                parts(whole);
    CellSurface<dim>          one(parts.grid, closed_faces);
    CellSurface<dim>          many(parts.grid, closed_faces);
    Facets<dim>               expected, found;
    for (const auto functions : {ShapeFunctions::linear, ShapeFunctions::gimp})
      {
        one.find_active(whole, functions, expected);
        many.find_active(parts.body(), functions, found);
        EXPECT_GT(found.size(), 30u);
        are_the_same(found, expected);
      }
    // Each rank hears the same of the same cell.
    std::string said;
    try
      {
        one.find_volume(whole, "Tractions/a/Method", expected);
      }
    catch (const UserError &error)
      {
        said = error.what();
      }
    EXPECT_USER_ERROR(many.find_volume(parts.body(),
                                       "Tractions/a/Method",
                                       found),
                      "Tractions/a/Method",
                      "cannot be placed by volume");
    try
      {
        many.find_volume(parts.body(), "Tractions/a/Method", found);
      }
    catch (const UserError &error)
      {
        EXPECT_EQ(said, error.what());
      }

    // A block along the grid, which ends within cells.
    const double        spacing = h / 2.;
    MaterialPoints<dim> block;
    for (unsigned int i = 0; i < 9; ++i)
      for (unsigned int j = 0; j < 7; ++j)
        for (unsigned int k = 0; k < (dim == 3 ? 5 : 1); ++k)
          {
            const unsigned int index[] = {i + 10, j, k + 4};
            Point<dim>         x;
            Tensor<1, dim>     l;
            for (unsigned int d = 0; d < dim; ++d)
              {
                x[d] = (index[d] + 0.5) * spacing;
                l[d] = 0.5 * spacing;
              }
            block.id.push_back(block.n_points());
            block.position.push_back(x);
            block.half_size.push_back(l);
            block.volume.push_back(std::pow(spacing, dim));
          }
    Parts<dim> of_block(block);
    one.find_volume(block, "", expected);
    many.find_volume(of_block.body(), "", found);
    EXPECT_GT(found.size(), 9u);
    are_the_same(found, expected);
  }


  TEST(Ranks, SurfacesAlongTheGridAreThoseOfTheWhole)
  {
    for (const unsigned int closed_faces : {0u, 1u << 2})
      {
        check_cells<2>(closed_faces);
        check_cells<3>(closed_faces);
      }
  }
} // namespace surface_contour_of_ranks
