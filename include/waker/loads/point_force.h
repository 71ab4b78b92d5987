// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_point_force_h
#define waker_loads_point_force_h

#include <waker/grid/background_grid.h>
#include <waker/nodes/nodal_vector.h>

namespace Waker
{
  /// Add a force f at x (kN) to the nodes: F_i = N_i(x) f (eq. 3.2 of
  /// Remmerswaal 2023), with linear functions N_i also under GIMP.
  /// @param x in a cell of the grid (m); on several ranks in one of this rank's
  template <int dim>
  void
  add_point_force(const BackgroundGrid<dim> &grid,
                  const Point<dim>          &x,
                  const Tensor<1, dim>      &f,
                  NodalVector               &force);
} // namespace Waker

#endif
