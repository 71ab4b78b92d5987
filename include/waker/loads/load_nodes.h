// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_load_nodes_h
#define waker_loads_load_nodes_h

#include <waker/grid/background_grid.h>

#include <algorithm>
#include <array>

namespace Waker
{
  /**
   * The nodes that take loads: those of a grid, or of the window that one of
   * several ranks has of it; for a load that is the same along z, those of each
   * plane of nodes of such a grid.
   */
  template <int dim>
  struct LoadNodes
  {
    /// Not explicit: a grid is its nodes.
    /// @param grid must outlive this object
    template <int grid_dim>
    LoadNodes(const BackgroundGrid<grid_dim> &grid)
      : inverse_h(grid.inverse_cell_size())
      , h(grid.cell_size())
      , n_components(grid_dim)
      , ranks(&grid.exchange())
    {
      static_assert(grid_dim >= dim,
                    "a plane of a grid in space, or all of it");
      for (unsigned int d = 0; d < dim; ++d)
        {
          origin[d]  = grid.lattice_origin()[d];
          n_whole[d] = grid.lattice_nodes_per_direction()[d];
          n[d]       = grid.n_nodes_per_direction()[d];
          first[d]   = grid.offset()[d];
        }
      if (grid_dim > dim)
        {
          n_planes    = grid.n_nodes_per_direction()[grid_dim - 1];
          first_plane = grid.offset()[grid_dim - 1];
        }
    }

    /// In a plane.
    unsigned int
    n_nodes() const
    {
      unsigned int product = 1;
      for (unsigned int d = 0; d < dim; ++d)
        product *= n[d];
      return product;
    }

    /// Does this rank know all nodes of a cell of the whole lattice?
    bool
    has_cell(const std::array<int, dim> &cell) const
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (cell[d] < first[d] ||
            cell[d] + 1 >= first[d] + static_cast<int>(n[d]))
          return false;
      return true;
    }

    Point<dim>                    origin; // of the whole lattice, m
    double                        inverse_h, h;
    std::array<unsigned int, dim> n_whole, n;   // nodes: of all, and here
    std::array<int, dim>          first;        // the first one here
    unsigned int                  n_components; // of a node's force
    unsigned int                  n_planes    = 1;
    unsigned int                  first_plane = 0;
    const NodeExchange           *ranks;
  };
} // namespace Waker

#endif
