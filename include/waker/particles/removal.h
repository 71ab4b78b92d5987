// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_removal_h
#define waker_particles_removal_h

#include <waker/grid/background_grid.h>
#include <waker/particles/material_points.h>

#include <vector>

namespace Waker
{
  /// The points that lie beyond an open face of the grid's box, ascending.
  /// @param open one flag per face (2d lower, 2d + 1 upper in direction d)
  template <int dim>
  std::vector<std::size_t>
  points_beyond(const BackgroundGrid<dim> &grid,
                const std::vector<bool>   &open,
                const MaterialPoints<dim> &points);

  /// Remove points; the others keep their order.
  /// @param list of their places in the arrays, ascending
  template <int dim>
  void
  remove_points(const std::vector<std::size_t> &list,
                MaterialPoints<dim>            &points);
} // namespace Waker

#endif
