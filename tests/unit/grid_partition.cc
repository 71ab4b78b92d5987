// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/grid/partition.h>
#include <waker/particles/point_exchange.h>
#include <waker/particles/removal.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <set>
#include <vector>

// Of one rank and, by tests/cases/ranks.py, of several.

namespace Waker
{
  namespace grid_partition
  {
    template <int dim>
    Point<dim>
    corner(const double x)
    {
      Point<dim> p;
      for (unsigned int d = 0; d < dim; ++d)
        p[d] = x * (d + 1);
      return p;
    }


    template <int dim>
    BackgroundGrid<dim>
    make_grid()
    {
      return BackgroundGrid<dim>(Point<dim>(),
                                 corner<dim>(2.),
                                 0.25,
                                 MPI_COMM_WORLD);
    }


    /// A number of a node and a rank that nobody guesses.
    double
    value(const std::size_t node, const unsigned int rank)
    {
      return std::sin(1. + 0.7 * static_cast<double>(node) + 3. * rank);
    }


    /// The ranks' sums are those of the nodes; gather() tells them to all.
    template <int dim>
    void
    sums_are_those_of_all_ranks()
    {
      const BackgroundGrid<dim> grid = make_grid<dim>();
      const Partition<dim>      partition(grid, MPI_COMM_WORLD);
      const auto                window = partition.make_window();
      const NodeExchange       &ranks  = window->exchange();
      const unsigned int        rank =
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);

      // Each rank puts something on what its cells reach.
      const auto whole_node = [&](const unsigned int node) {
        auto index = window->node_index(node);
        for (unsigned int d = 0; d < dim; ++d)
          index[d] += window->offset()[d];
        return grid.node(index);
      };
      std::vector<double> mine(2 * window->n_nodes(), 0.);
      std::vector<double> expected(2 * grid.n_nodes(), 0.);
      for (unsigned int node = 0; node < window->n_nodes(); ++node)
        {
          if (!ranks.owns(node))
            continue;
          // The stencils of the two points that reach furthest.
          for (const int shift : {-1, 2})
            {
              auto index = window->node_index(node);
              bool is_on = true;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  index[d] += shift;
                  is_on = is_on && index[d] >= 0 &&
                          index[d] < static_cast<int>(
                                       window->n_nodes_per_direction()[d]);
                }
              if (!is_on)
                continue;
              const unsigned int reached = window->node(index);
              for (unsigned int c = 0; c < 2; ++c)
                {
                  const double v = value(2 * whole_node(node) + c, rank);
                  mine[2 * reached + c] += v;
                  expected[2 * whole_node(reached) + c] += v;
                }
            }
        }
      MPI_Allreduce(MPI_IN_PLACE,
                    expected.data(),
                    expected.size(),
                    MPI_DOUBLE,
                    MPI_SUM,
                    MPI_COMM_WORLD);
      const std::vector<double> partial = mine;
      ranks.sum({{mine.data(), 2}});
      unsigned int n_seen = 0;
      for (unsigned int node = 0; node < window->n_nodes(); ++node)
        for (unsigned int c = 0; c < 2; ++c)
          if (partial[2 * node + c] != 0. || ranks.owns(node))
            {
              ++n_seen;
              EXPECT_NEAR(mine[2 * node + c],
                          expected[2 * whole_node(node) + c],
                          1e-13);
            }
      EXPECT_GE(n_seen, 2 * partition.n_owned());

      std::vector<double> all(2 * grid.n_nodes());
      partition.gather(*window, mine.data(), 2, all.data());
      for (std::size_t k = 0; k < all.size(); ++k)
        EXPECT_NEAR(all[k], expected[k], 1e-13);
      std::vector<double> back(mine.size());
      partition.restrict_to(*window, all.data(), 2, back.data());
      for (unsigned int node = 0; node < window->n_nodes(); ++node)
        if (ranks.owns(node))
          {
            EXPECT_EQ(back[2 * node], mine[2 * node]);
          }

      EXPECT_EQ(ranks.sum(static_cast<double>(partition.n_owned())),
                grid.n_nodes());
    }


    TEST(Ranks, SumsAreThoseOfAllRanks)
    {
      sums_are_those_of_all_ranks<2>();
      sums_are_those_of_all_ranks<3>();
    }


    template <int dim>
    MaterialPoints<dim>
    row_of_points(const unsigned int n)
    {
      MaterialPoints<dim> points;
      points.resize(n);
      points.scalar("number");
      for (unsigned int p = 0; p < n; ++p)
        {
          points.id[p]               = 100 + p;
          points.position[p]         = corner<dim>(0.01 + 0.002 * p);
          points.velocity[p][0]      = p;
          points.scalar("number")[p] = 3. * p;
          points.stress[p][0][0]     = -1. * p;
          points.volume[p]           = 1. + p;
          points.half_size[p]        = Tensor<1, dim>();
        }
      return points;
    }


    /// A cloud that flies across the grid, several cells a step, and leaves
    /// ranks empty: nothing is lost, and what belongs to a point stays with it.
    template <int dim>
    void
    points_fly_through_all_ranks()
    {
      const BackgroundGrid<dim> grid = make_grid<dim>();
      Partition<dim>            partition(grid, MPI_COMM_WORLD);
      MaterialPoints<dim>       whole = row_of_points<dim>(50);
      PointExchange<dim>        exchange(partition, MPI_COMM_WORLD, whole);
      const unsigned int        rank =
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      std::set<unsigned int> owners;
      std::size_t            n_moved = 0;
      for (unsigned int step = 0; step < 8; ++step)
        {
          MaterialPoints<dim> &own = exchange.own();
          for (std::size_t p = 0; p < own.n_points(); ++p)
            {
              EXPECT_EQ(partition.owner(own.position[p]), rank);
              own.position[p] += corner<dim>(0.23);
              own.scalar("number")[p] += 1.;
            }
          n_moved += exchange.send_home(partition);
          exchange.gather(whole);
          for (unsigned int p = 0; p < 50; ++p)
            {
              EXPECT_EQ(whole.id[p], 100 + p);
              EXPECT_NEAR(whole.position[p][0],
                          0.01 + 0.002 * p + 0.23 * (step + 1),
                          1e-12);
              EXPECT_EQ(whole.velocity[p][0], p);
              EXPECT_EQ(whole.scalar("number")[p], 3. * p + step + 1.);
              EXPECT_EQ(whole.stress[p][0][0], -1. * p);
              EXPECT_EQ(whole.volume[p], 1. + p);
              owners.insert(partition.owner(whole.position[p]));
            }
          if (step == 4)
            {
              // All of them go to those who have to compute them.
              partition.balance(exchange.own().position);
              exchange.send_home(partition);
            }
        }
      const unsigned int n_ranks =
        Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      EXPECT_GE(owners.size(), std::min(n_ranks, 2u));
      EXPECT_GE(n_moved, n_ranks > 1 ? 50u : 0u);
      if (n_ranks == 1)
        {
          EXPECT_EQ(n_moved, 0u);
        }
    }


    TEST(Ranks, PointsFlyThroughAllRanks)
    {
      points_fly_through_all_ranks<2>();
      points_fly_through_all_ranks<3>();
    }


    /// The copy of the whole body goes, and comes again as far as it is asked
    /// for; points may have left in between.
    TEST(Ranks, CopyOfTheWholeIsThereWhenItIsAskedFor)
    {
      const BackgroundGrid<3> grid = make_grid<3>();
      Partition<3>            partition(grid, MPI_COMM_WORLD);
      MaterialPoints<3>       whole = row_of_points<3>(50);
      for (double &mass : whole.mass)
        mass = 4.;
      PointExchange<3> exchange(partition, MPI_COMM_WORLD, whole);
      PointExchange<3>::forget(whole);
      EXPECT_EQ(whole.n_points(), 50u);
      EXPECT_EQ(whole.id[49], 149u);
      EXPECT_EQ(whole.position.capacity(), 0u);
      EXPECT_EQ(whole.scalar("number").capacity(), 0u);

      std::vector<std::size_t> leaving; // every second one
      for (std::size_t p = 0; p < exchange.own().n_points(); ++p)
        if (exchange.own().id[p] % 2 == 0)
          leaving.push_back(p);
      remove_points(exchange.remove(leaving), whole);
      ASSERT_EQ(whole.n_points(), 25u);

      exchange.gather_places(whole, {"mass", "load"});
      EXPECT_TRUE(whole.stress.empty());
      EXPECT_TRUE(whole.load.empty()); // which no point has
      EXPECT_TRUE(whole.scalar("number").empty());
      ASSERT_EQ(whole.mass, std::vector<double>(25, 4.));
      // What is constant is not told again.
      whole.mass[0] = 5.;
      exchange.gather_places(whole, {"mass"});
      EXPECT_EQ(whole.mass[0], 5.);
      exchange.gather(whole);
      EXPECT_EQ(whole.mass[0], 4.);
      for (unsigned int k = 0; k < 25; ++k)
        {
          const unsigned int p = 2 * k + 1;
          EXPECT_EQ(whole.id[k], 100u + p);
          EXPECT_EQ(whole.volume[k], 1. + p);
          EXPECT_EQ(whole.scalar("number")[k], 3. * p);
        }
    }


    /// Points in one corner: balance() deals them out.
    TEST(Ranks, BalanceDealsOutPoints)
    {
      const BackgroundGrid<2> grid = make_grid<2>();
      Partition<2>            partition(grid, MPI_COMM_WORLD);
      MaterialPoints<2>       whole = row_of_points<2>(400);
      for (unsigned int p = 0; p < 400; ++p)
        whole.position[p] =
          Point<2>(0.02 + 0.05 * (p % 20), 0.02 + 0.05 * (p / 20));
      PointExchange<2> exchange(partition, MPI_COMM_WORLD, whole);
      partition.balance(exchange.own().position);
      exchange.send_home(partition);
      const unsigned int n_ranks =
        Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      // A cell has 25 points: one more or less of 400 / n.
      EXPECT_LE(exchange.imbalance(), 1. + 25. * n_ranks / 400. + 0.2);
    }
  } // namespace grid_partition
} // namespace Waker
