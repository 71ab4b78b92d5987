// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_removal_h
#define waker_particles_removal_h

#include <waker/particles/material_points.h>
#include <waker/particles/openings.h>

#include <vector>

namespace Waker
{
  /// The points that have passed an opening of the grid's box, ascending.
  template <int dim>
  std::vector<std::size_t>
  points_beyond(const Openings<dim>       &openings,
                const MaterialPoints<dim> &points);

  /// Remove points; the others keep their order.
  /// @param list of their places in the arrays, ascending
  template <int dim>
  void
  remove_points(const std::vector<std::size_t> &list,
                MaterialPoints<dim>            &points);
} // namespace Waker

#endif
