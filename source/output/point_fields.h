// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_output_point_fields_h
#define waker_source_output_point_fields_h

#include <waker/output/particle_writer.h>

#include "vtu.h"

namespace Waker
{
  /// The fields that write_particles() lists, for all files with them; private
  /// to the room.
  template <int dim>
  void
  add_point_fields(VtuFile                   &file,
                   const MaterialPoints<dim> &points,
                   const PointVectors<dim>   &vectors);

  /// Their values of a point, by its place in the arrays.
  template <int dim>
  void
  add_point_values(VtuFile                   &file,
                   const MaterialPoints<dim> &points,
                   const PointVectors<dim>   &vectors,
                   const std::size_t          p);
} // namespace Waker

#endif
