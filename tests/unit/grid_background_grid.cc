// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe.h>

#include <waker/base/errors.h>
#include <waker/grid/background_grid.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>

namespace grid_background_grid
{
  using namespace Waker;

  namespace
  {
    /// A grid with other numbers of cells in each direction.
    template <int dim>
    BackgroundGrid<dim>
    oblong_grid()
    {
      Point<dim>   lower, upper;
      const double first[3] = {-0.75, 0.5, 2.}, cells[3] = {5., 3., 2.};
      for (unsigned int d = 0; d < dim; ++d)
        {
          lower[d] = first[d];
          upper[d] = first[d] + 0.25 * cells[d];
        }
      return BackgroundGrid<dim>(lower, upper, 0.25, MPI_COMM_SELF);
    }


    template <int dim>
    void
    check_numbering()
    {
      const auto grid = oblong_grid<dim>();
      EXPECT_EQ(grid.n_nodes(), dim == 2 ? 8u * 6u : 8u * 6u * 5u);
      EXPECT_EQ(grid.n_cells(), dim == 2 ? 7u * 5u : 7u * 5u * 4u);
      EXPECT_EQ(grid.n_dofs(), dim * grid.n_nodes());

      const auto                          &fe = grid.dof_handler().get_fe();
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      unsigned int                         n_cells = 0;
      for (const auto &cell : grid.dof_handler().active_cell_iterators())
        {
          ++n_cells;
          cell->get_dof_indices(dofs);
          const unsigned int base = grid.node(grid.cell_index(cell->center()));
          for (unsigned int i = 0; i < dofs.size(); ++i)
            {
              const auto [component, vertex] = fe.system_to_component_index(i);
              EXPECT_EQ(dofs[i] % dim, component);
              const unsigned int node = dofs[i] / dim;
              EXPECT_LT(grid.node_position(node).distance(cell->vertex(vertex)),
                        1e-14);
              unsigned int expected = base; // from the cell's lower left node
              for (unsigned int d = 0; d < dim; ++d)
                expected += (vertex >> d & 1) * grid.stride(d);
              EXPECT_EQ(node, expected);
            }
        }
      EXPECT_EQ(n_cells, grid.n_cells());
      for (unsigned int node = 0; node < grid.n_nodes(); ++node)
        ASSERT_EQ(grid.node(grid.node_index(node)), node);
    }


    template <int dim>
    void
    check_cells()
    {
      const auto      grid = oblong_grid<dim>();
      Lattice::Random random(1);
      for (unsigned int n = 0; n < 1000; ++n)
        {
          Point<dim> x = grid.origin();
          for (unsigned int d = 0; d < dim; ++d)
            x[d] += random(0., 0.25 * (grid.n_nodes_per_direction()[d] - 1));
          const auto corner = grid.node_position(grid.node(grid.cell_index(x)));
          for (unsigned int d = 0; d < dim; ++d)
            {
              ASSERT_GE(x[d], corner[d] - 1e-14);
              ASSERT_LE(x[d], corner[d] + 0.25 + 1e-14);
            }
        }
    }


    std::string
    complaint(const double length, const double cell_size)
    {
      try
        {
          const BackgroundGrid<2> grid(Point<2>(),
                                       Point<2>(1., length),
                                       cell_size,
                                       MPI_COMM_SELF);
        }
      catch (const UserError &error)
        {
          return error.where;
        }
      return "";
    }
  } // namespace


  TEST(Grid, nodes_are_numbered_as_the_dofs_of_deal_ii)
  {
    check_numbering<2>();
    check_numbering<3>();
  }


  TEST(Grid, a_point_lies_in_its_cell)
  {
    check_cells<2>();
    check_cells<3>();
  }


  TEST(Grid, the_box_has_a_margin_of_one_cell)
  {
    const auto grid = oblong_grid<2>();
    EXPECT_EQ(grid.origin(), Point<2>(-1., 0.25));
    EXPECT_EQ(grid.lower_corner(), Point<2>(-0.75, 0.5));
    EXPECT_EQ(grid.upper_corner(), Point<2>(0.5, 1.25));
    EXPECT_TRUE(grid.contains(Point<2>(-0.9, 0.3)));
    EXPECT_FALSE(grid.contains(Point<2>(-0.9, 0.3), 0.06));
    EXPECT_TRUE(grid.contains(Point<2>(-0.9, 0.3), 0.04));
    EXPECT_FALSE(grid.contains(Point<2>(0.76, 1.)));
    EXPECT_FALSE(grid.contains(Point<2>(0., std::nan(""))));
  }


  TEST(Grid, a_box_that_is_none_is_the_users_mistake)
  {
    EXPECT_EQ(complaint(1., 0.25), "");
    EXPECT_EQ(complaint(1.1, 0.25), "Grid/Upper corner");
    EXPECT_EQ(complaint(0., 0.25), "Grid/Upper corner");
    EXPECT_EQ(complaint(-1., 0.25), "Grid/Upper corner");
    EXPECT_EQ(complaint(1., 0.), "Grid/Cell size");
    EXPECT_EQ(complaint(1., -0.25), "Grid/Cell size");
  }
} // namespace grid_background_grid
