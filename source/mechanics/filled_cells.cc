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
    template <typename Function>
    void
    for_each_cell(const BackgroundGrid<2> &grid,
                  const PointWeights<2>   &w,
                  const Function          &f)
    {
      // The shares are in the slopes, those of the first and second cell.
      const double h    = grid.cell_size();
      const double x[2] = {-w.gradient[0][0] * h, w.gradient[0][2] * h};
      const double y[2] = {-w.gradient[1][0] * h, w.gradient[1][2] * h};
      for (unsigned int j = 0; j < 2; ++j)
        for (unsigned int i = 0; i < 2; ++i)
          f(w.base + j * grid.stride(1) + i, x[i] * y[j]);
    }


    template <typename Function>
    void
    for_each_cell(const BackgroundGrid<3> &grid,
                  const PointWeights<3>   &w,
                  const Function          &f)
    {
      const double h    = grid.cell_size();
      const double x[2] = {-w.gradient[0][0] * h, w.gradient[0][2] * h};
      const double y[2] = {-w.gradient[1][0] * h, w.gradient[1][2] * h};
      const double z[2] = {-w.gradient[2][0] * h, w.gradient[2][2] * h};
      for (unsigned int k = 0; k < 2; ++k)
        for (unsigned int j = 0; j < 2; ++j)
          for (unsigned int i = 0; i < 2; ++i)
            f(w.base + k * grid.stride(2) + j * grid.stride(1) + i,
              x[i] * y[j] * z[k]);
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
