// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_near_points_h
#define waker_particles_near_points_h

#include <waker/particles/body.h>
#include <waker/particles/material_points.h>

namespace Waker
{
  /**
   * The points of this rank and, on several ranks, those of others that may lie
   * within a distance of its own cells, in the order of their ids: what one
   * rank alone sees there. Of those of others, only id, position, half_size and
   * volume are known. Collective.
   *
   * @param reach in each direction (m); the largest of all ranks counts
   * @param around where they are, if they are not just the own ones
   */
  template <int dim>
  const MaterialPoints<dim> &
  own_and_near(const Body<dim>     &body,
               const double         reach,
               MaterialPoints<dim> &around);

  /// Largest half size of the domains of the own points, in any direction (m).
  template <int dim>
  double
  largest_half_size(const MaterialPoints<dim> &points);
} // namespace Waker

#endif
