// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/filled_cells.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// f(lowest node of the cell, the support domain's share in it) for the
    /// 2^dim cells of a stencil.
    template <int dim, typename Function>
    void
    for_each_cell(const BackgroundGrid<dim> &grid,
                  const PointWeights<dim>   &w,
                  const Function            &f)
    {
      const double h = grid.cell_size();
      for (unsigned int cell = 0; cell < (1u << dim); ++cell)
        {
          unsigned int node  = w.base;
          double       share = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            {
              // The shares are in the slopes, those of the first and second
              // cell.
              const unsigned int side = cell >> d & 1;
              node += side * grid.stride(d);
              share *= std::abs(w.gradient[d][2 * side]) * h;
            }
          f(node, share);
        }
    }
  } // namespace


  template <int dim>
  void
  FilledCells<dim>::reinit(const MaterialPoints<dim> &points,
                           const Weights<dim>        &weights)
  {
    if (which == BBarCells::all)
      {
        shares.assign(points.n_points(), 1.);
        return;
      }
    const BackgroundGrid<dim> &grid = weights.background_grid();
    cells.assign(grid.n_nodes(), 0.);
    for (std::size_t p = 0; p < points.n_points(); ++p)
      for_each_cell(grid,
                    weights[p],
                    [&](const unsigned int cell, const double share) {
                      cells[cell] += share * points.volume[p];
                    });

    grid.exchange().sum({{cells.data(), 1}});

    const double full = std::pow(grid.cell_size(), dim);
    for (double &cell : cells)
      cell = share_of_cell(cell / full, which);

    shares.resize(points.n_points());
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        double sum = 0.;
        for_each_cell(grid,
                      weights[p],
                      [&](const unsigned int cell, const double share) {
                        sum += share * cells[cell];
                      });
        shares[p] = std::max(2. * sum - 1., 0.);
      }
  }


  template class FilledCells<2>;
  template class FilledCells<3>;
} // namespace Waker
