// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_layer_parts_h
#define waker_particles_layer_parts_h

#include <waker/grid/background_grid.h>
#include <waker/particles/layer_body.h>

#include <vector>

namespace Waker
{
  /// A coordinate of a corner (m) in units of the sub-cells, put on a line
  /// of the lattice where only round-off keeps it off.
  template <int dim>
  double
  to_lattice(const BackgroundGrid<dim> &grid,
             const unsigned int         d,
             const unsigned int         points_per_direction,
             const double               x);

  /// The cross-section of a body, its corners in units of the sub-cells.
  template <int dim>
  Polygon
  corners_in_lattice(const BackgroundGrid<dim> &grid,
                     const LayerBody           &body,
                     const unsigned int         points_per_direction);

  /// The parts of the sub-cells in a body (m), lexicographically; none is given
  /// to a neighbour.
  template <int dim>
  std::vector<LatticePart<dim>>
  all_parts(const BackgroundGrid<dim> &grid,
            const LayerBody           &body,
            const unsigned int         points_per_direction);
} // namespace Waker

#endif
