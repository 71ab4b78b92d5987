// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/grid/near_cells.h>
#include <waker/grid/partition.h>

#include "mapping_lattice.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

// Of one rank and, by tests/cases/ranks.py, of several.

namespace grid_near_cells
{
  using namespace Waker;

  namespace
  {
    struct Told
    {
      std::uint64_t id;
      double        x;
    };


    /// Each rank is told, once, of all points of others within reach of one of
    /// its own, and of none that is far away.
    template <int dim>
    void
    check(const double reach, const double moved)
    {
      const double        h    = 0.25;
      BackgroundGrid<dim> grid = Lattice::grid<dim>(dim == 2 ? 6. : 3., h);
      Partition<dim>      partition(grid, MPI_COMM_WORLD);
      const auto          window = partition.make_window();
      const unsigned int  rank =
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      // Known to each, and then moved by less than a cell, or by some.
      Lattice::Random         random(3);
      std::vector<Point<dim>> all, own;
      std::vector<int>        owner;
      std::vector<unsigned>   ids;
      for (unsigned int p = 0; p < 300; ++p)
        {
          Point<dim> x(
            random.vector<dim>(-0.9 * h, (dim == 2 ? 6. : 3.) + 0.9 * h));
          owner.push_back(partition.owner(x));
          for (unsigned int d = 0; d < dim; ++d)
            x[d] += moved * random(-1., 1.);
          all.push_back(x);
          if (owner.back() == static_cast<int>(rank))
            {
              own.push_back(x);
              ids.push_back(p);
            }
        }
      const std::vector<Told> told = window->near_cells().template gather<Told>(
        own, rank == 0 ? reach : 0., [&](const std::size_t p, Told &t) {
          t = {ids[p], own[p][0]};
          return ids[p] % 7 != 0;
        });
      std::set<std::uint64_t> known;
      for (const Told &t : told)
        {
          EXPECT_TRUE(known.insert(t.id).second);
          EXPECT_NE(owner[t.id], static_cast<int>(rank));
          EXPECT_EQ(t.x, all[t.id][0]);
        }
      for (unsigned int p = 0; p < all.size(); ++p)
        {
          if (owner[p] == static_cast<int>(rank) || p % 7 == 0)
            continue;
          double nearest = 1e9;
          for (const Point<dim> &x : own)
            {
              double distance = 0.;
              for (unsigned int d = 0; d < dim; ++d)
                distance = std::max(distance, std::abs(x[d] - all[p][d]));
              nearest = std::min(nearest, distance);
            }
          if (nearest <= reach)
            {
              EXPECT_EQ(known.count(p), 1u) << p;
            }
        }
      // None that is far from all own cells, where both may have moved.
      const double limit = reach + (2. + 2. * std::ceil(moved / h)) * h;
      for (const std::uint64_t id : known)
        {
          double nearest = 1e9;
          for (unsigned int node = 0; node < window->n_nodes(); ++node)
            if (window->exchange().owns(node))
              {
                double distance = 0.;
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    const double begin = window->node_position(node)[d];
                    distance           = std::max(
                      {distance, begin - all[id][d], all[id][d] - begin - h});
                  }
                nearest = std::min(nearest, distance);
              }
          EXPECT_LE(nearest, limit * (1. + 1e-12)) << id;
        }
      const unsigned int n_ranks =
        Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      const double n_told =
        Utilities::MPI::sum(static_cast<double>(known.size()), MPI_COMM_WORLD);
      if (n_ranks > 1 && reach >= h)
        {
          EXPECT_GT(n_told, 0.);
        }
    }
  } // namespace


  TEST(Ranks, WhatIsNearIsTold)
  {
    for (const double reach : {0., 0.25, 0.8, 100.})
      for (const double moved : {0., 0.7})
        {
          check<2>(reach, moved);
          check<3>(reach, moved);
        }
  }
} // namespace grid_near_cells
