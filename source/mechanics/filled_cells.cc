// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/centre_stencil.h>
#include <waker/mechanics/filled_cells.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// Of each node of the grid: is the cell that begins there beyond the box?
    template <int dim>
    std::vector<unsigned char>
    cells_beyond(const BackgroundGrid<dim> &grid)
    {
      constexpr int              margin = BackgroundGrid<dim>::margin;
      std::vector<unsigned char> beyond(grid.n_nodes(), 0);
      for (unsigned int node = 0; node < grid.n_nodes(); ++node)
        {
          const auto index = grid.node_index(node);
          for (unsigned int d = 0; d < dim; ++d)
            {
              const int i = index[d] + grid.offset()[d];
              const int n = grid.lattice_nodes_per_direction()[d];
              if (i < margin || i >= n - 1 - margin)
                beyond[node] = 1;
            }
        }
      return beyond;
    }
  } // namespace


  template <int dim>
  void
  FilledCells<dim>::reinit(const MaterialPoints<dim> &points,
                           const Weights<dim>        &weights)
  {
    constexpr unsigned int     n_cells = 1u << dim;
    const BackgroundGrid<dim> &grid    = weights.background_grid();
    const double               h       = grid.cell_size();
    const std::size_t          n       = points.n_points();
    shares.assign(n, 1.);
    first.resize(n);
    for (std::size_t p = 0; p < n; ++p)
      first[p] = CentreWeights<dim>::shares(weights[p], h);
    if (which == BBarCells::all)
      return;

    // The lowest node of one of the domain's cells, and the share that lies in
    // it in direction d.
    const auto node = [&](const std::size_t p, const unsigned int cell) {
      unsigned int i = weights[p].base;
      for (unsigned int d = 0; d < dim; ++d)
        i += (cell >> d & 1) * grid.stride(d);
      return i;
    };
    const auto share =
      [&](const std::size_t p, const unsigned int cell, const unsigned int d) {
        return std::abs(weights[p].gradient[d][cell >> d & 1 ? 2 : 0]) * h;
      };

    cells.assign(grid.n_nodes(), 0.);
    for (std::size_t p = 0; p < n; ++p)
      for (unsigned int cell = 0; cell < n_cells; ++cell)
        {
          double volume = points.volume[p];
          for (unsigned int d = 0; d < dim; ++d)
            volume *= share(p, cell, d);
          cells[node(p, cell)] += volume;
        }
    grid.exchange().sum({{cells.data(), 1}});
    const double full = std::pow(h, dim);
    for (double &cell : cells)
      cell = share_of_cell(cell / full, which);
    if (beyond.size() != grid.n_nodes() || begin != grid.offset() ||
        extent != grid.n_nodes_per_direction())
      {
        beyond = cells_beyond(grid);
        begin  = grid.offset();
        extent = grid.n_nodes_per_direction();
      }

    for (std::size_t p = 0; p < n; ++p)
      {
        // B; and of what lies in cells whose centres count, all of it and the
        // part on the lower side in each direction.
        double mean = 0., counted = 0.;
        double lower[dim] = {};
        bool   is_at_edge = false;
        for (unsigned int cell = 0; cell < n_cells; ++cell)
          {
            const unsigned int i      = node(p, cell);
            double             volume = 1.;
            for (unsigned int d = 0; d < dim; ++d)
              volume *= share(p, cell, d);
            mean += cells[i] * volume;
            is_at_edge     = is_at_edge || beyond[i];
            const double c = beyond[i] ? cells[i] * volume : volume;
            counted += c;
            for (unsigned int d = 0; d < dim; ++d)
              if (!(cell >> d & 1))
                lower[d] += c;
          }
        shares[p] = std::max(2. * mean - 1., 0.);
        if (shares[p] > 0. && is_at_edge)
          for (unsigned int d = 0; d < dim; ++d)
            first[p][d] = lower[d] / counted;
      }
  }


  template class FilledCells<2>;
  template class FilledCells<3>;
} // namespace Waker
