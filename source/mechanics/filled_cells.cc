// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/centre_stencil.h>
#include <waker/mechanics/filled_cells.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
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

    for (std::size_t p = 0; p < n; ++p)
      {
        // B, and the part of it on the lower side in each direction.
        double mean       = 0.;
        double lower[dim] = {};
        for (unsigned int cell = 0; cell < n_cells; ++cell)
          {
            double b = cells[node(p, cell)];
            for (unsigned int d = 0; d < dim; ++d)
              b *= share(p, cell, d);
            mean += b;
            for (unsigned int d = 0; d < dim; ++d)
              if (!(cell >> d & 1))
                lower[d] += b;
          }
        shares[p] = std::max(2. * mean - 1., 0.);
        if (shares[p] > 0.)
          for (unsigned int d = 0; d < dim; ++d)
            first[p][d] = lower[d] / mean;
      }
  }


  template class FilledCells<2>;
  template class FilledCells<3>;
} // namespace Waker
