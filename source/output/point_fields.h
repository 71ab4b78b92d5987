// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_output_point_fields_h
#define waker_source_output_point_fields_h

#include <waker/output/particle_writer.h>

#include "vtu.h"

namespace Waker
{
  /// The fields that write_particles() lists, for all files with them; private
  /// to the room. Points and vectors are kept by reference.
  template <int dim>
  class PointFields
  {
  public:
    PointFields(const MaterialPoints<dim> &points,
                const PointVectors<dim>   &vectors = {});

    void
    declare(VtuFile &file) const;

    /// The values of a point, by its place in the arrays.
    void
    add_values(const std::size_t p, VtuFile &file) const;

  private:
    const MaterialPoints<dim> &points;
    const PointVectors<dim>    vectors;
    /// Numbers of the scalars whose product is the yield stress, which goes
    /// with the soil, and with the random fields of what decides on it; or -1.
    const int vertical_stress, overconsolidation_ratio;
  };
} // namespace Waker

#endif
