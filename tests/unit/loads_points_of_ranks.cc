// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/grid/partition.h>
#include <waker/loads/riding_load.h>
#include <waker/loads/surface_points.h>
#include <waker/particles/point_exchange.h>
#include <waker/particles/removal.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>

// Of one rank and, by tests/cases/ranks.py, of several.

namespace loads_points_of_ranks
{
  using namespace Waker;

  constexpr double h = 0.25, size = 4.;

  /// Facets in and around a body that lies on the left, some of them far from
  /// any of its points, some that meet in a point.
  template <int dim>
  Facets<dim>
  make_facets(const unsigned int n)
  {
    Lattice::Random random(11);
    Facets<dim>     facets;
    for (unsigned int k = 0; k < n; ++k)
      {
        std::array<Point<dim>, dim> x;
        const Point<dim>            near(random.vector<dim>(0., size - 4. * h));
        for (Point<dim> &vertex : x)
          vertex = near + random.vector<dim>(0., k % 5 == 0 ? 4. * h : h);
        facets.push_back(make_facet<dim>(x));
      }
    return facets;
  }


  template <int dim>
  struct Loaded
  {
    Loaded()
      : grid(Lattice::grid<dim>(size, h))
      , whole(make_points())
      , partition(grid, MPI_COMM_WORLD)
      , exchange(partition, MPI_COMM_WORLD, whole)
    {
      partition.balance(exchange.own().position);
      exchange.send_home(partition);
      window = partition.make_window();
    }

    static MaterialPoints<dim>
    make_points()
    {
      MaterialPoints<dim> points =
        Lattice::box(Point<dim>(), dim == 2 ? 12 : 8, 0.5 * h);
      Lattice::Random random(7);
      for (unsigned int p = 0; p < points.n_points(); ++p)
        points.position[p] += random.vector<dim>(0., 0.2 * h);
      points.initial_position = points.position;
      return points;
    }

    BackgroundGrid<dim>                        grid;
    MaterialPoints<dim>                        whole;
    Partition<dim>                             partition;
    PointExchange<dim>                         exchange;
    std::shared_ptr<const BackgroundGrid<dim>> window;
  };


  template <int dim>
  void
  check_shares()
  {
    Loaded<dim>                loaded;
    const MaterialPoints<dim> &own    = loaded.exchange.own();
    const Facets<dim>          facets = make_facets<dim>(60);
    SurfacePoints<dim>         one(loaded.grid, loaded.grid);
    SurfacePoints<dim>         many(loaded.grid, *loaded.window);
    std::vector<double>        expected(loaded.whole.n_points(), 0.);
    std::vector<double>        found(own.n_points(), 0.);
    // The lists of two loads.
    const Facets<dim> first(facets.begin(), facets.begin() + 20);
    const Facets<dim> second(facets.begin() + 20, facets.end());
    one.find(loaded.whole, {&first, &second});
    many.find(own, {&first, &second});
    for (const Facet<dim> &facet : facets)
      {
        one.split(facet, [&](const Facet<dim> &piece, const std::uint32_t p) {
          expected[p] += piece.measure();
        });
        many.split(facet, [&](const Facet<dim> &piece, const std::uint32_t p) {
          found[p] += piece.measure();
        });
      }
    unsigned int n_loaded = 0;
    for (unsigned int p = 0; p < own.n_points(); ++p)
      EXPECT_EQ(found[p], expected[own.id[p]]);
    for (const double share : expected)
      n_loaded += share > 0.;
    EXPECT_GT(n_loaded, 20u);
  }


  TEST(Ranks, SharesOfPointsAreThoseOfTheWhole)
  {
    check_shares<2>();
    check_shares<3>();
  }


  template <int dim>
  void
  check_riding()
  {
    Loaded<dim>          loaded;
    PointShares<dim>     shares(loaded.grid);
    MaterialPoints<dim>  whole = loaded.whole;
    MaterialPoints<dim> &own   = loaded.exchange.own();
    shares.sort(whole.position);
    RidingLoad<dim> riding;
    riding.ride_on_points(make_facets<dim>(30), whole, shares);
    // It has moved, and one loaded point has left.
    for (MaterialPoints<dim> *const points : {&whole, &own})
      for (unsigned int p = 0; p < points->n_points(); ++p)
        {
          points->position[p][0] += 0.1 * std::sin(1. * points->id[p]);
          points->half_size[p] *= 1.1;
        }
    const std::uint32_t      gone = riding.pieces[5].point;
    std::vector<std::size_t> list;
    for (unsigned int p = 0; p < own.n_points(); ++p)
      if (own.id[p] == gone)
        list.push_back(p);
    remove_points(loaded.exchange.remove(list), whole);
    Facets<dim>                                   expected, found;
    std::vector<typename RidingLoad<dim>::Placed> placed, placed_found;
    riding.place(loaded.grid.exchange(), whole, {}, expected, placed);
    riding.place(loaded.window->exchange(), own, {}, found, placed_found);
    EXPECT_LT(found.size(), riding.pieces.size());
    EXPECT_GT(found.size(), 30u);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k)
      {
        EXPECT_EQ(placed_found[k].piece, placed[k].piece);
        EXPECT_EQ((placed_found[k].area - placed[k].area).norm(), 0.);
        for (unsigned int v = 0; v < dim; ++v)
          EXPECT_EQ(found[k].vertices[v].distance(expected[k].vertices[v]), 0.);
      }
  }


  TEST(Ranks, WhatRidesIsWhereItIsOnOneRank)
  {
    check_riding<2>();
    check_riding<3>();
  }
} // namespace loads_points_of_ranks
