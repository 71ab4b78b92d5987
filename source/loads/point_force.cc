// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/loads/point_force.h>

namespace Waker
{
  template <int dim>
  void
  add_point_force(const BackgroundGrid<dim> &grid,
                  const Point<dim>          &x,
                  const Tensor<1, dim>      &f,
                  NodalVector               &force)
  {
    Assert(grid.contains(x),
           ExcMessage("A load must lie inside the grid and its margin."));
    const auto cell = grid.cell_index(x);
    double     u[dim];
    for (unsigned int d = 0; d < dim; ++d)
      u[d] = (x[d] - grid.lattice_origin()[d]) * grid.inverse_cell_size() -
             (cell[d] + grid.offset()[d]);
    for (unsigned int i = 0; i < (1u << dim); ++i)
      {
        double N     = 1.;
        auto   index = cell;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const bool upper = i >> d & 1u;
            N *= upper ? u[d] : 1. - u[d];
            index[d] += upper;
          }
        if (N == 0.) // beyond the last node
          continue;
        const unsigned int node = grid.node(index);
        for (unsigned int d = 0; d < dim; ++d)
          force.local_element(dim * node + d) += N * f[d];
      }
  }


  template void
  add_point_force(const BackgroundGrid<2> &,
                  const Point<2> &,
                  const Tensor<1, 2> &,
                  NodalVector &);
  template void
  add_point_force(const BackgroundGrid<3> &,
                  const Point<3> &,
                  const Tensor<1, 3> &,
                  NodalVector &);
} // namespace Waker
