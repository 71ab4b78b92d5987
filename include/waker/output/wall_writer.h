// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_wall_writer_h
#define waker_output_wall_writer_h

#include <waker/nodes/wall.h>

#include <string>

namespace Waker
{
  /**
   * Write the spots of the walls to a .vtu file, as points.
   *
   * Fields: wall (number, in the order of Walls/Names), touches (soil: 1),
   * area (m^(dim-1)), traction on the soil (kPa, a vector) and pressure (kPa,
   * into the soil).
   *
   * @param time of the state (s), stored in the file
   * @return checksum_of_text() of the file, for PvdSeries::add()
   */
  template <int dim>
  std::string
  write_walls(const Walls<dim>                     &walls,
              const typename Walls<dim>::Tractions &tractions,
              const double                          time,
              const std::string                    &path);
} // namespace Waker

#endif
