// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_traction_writer_h
#define waker_output_traction_writer_h

#include <string>

namespace Waker
{
  template <int dim>
  class Tractions;

  /**
   * Write the surfaces that are under load to a .vtu file: lines in 2D,
   * triangles in 3D, of equivalent point loads the surface that they stand for.
   *
   * Fields: number (of the traction, in the order of Tractions/Names), traction
   * (kPa, a vector) and pressure (kPa, against the outward normal).
   *
   * @param time of the state (s), stored in the file
   * @return checksum_of_text() of the file, for PvdSeries::add()
   */
  template <int dim>
  std::string
  write_tractions(const Tractions<dim> &tractions,
                  const double          time,
                  const std::string    &path);
} // namespace Waker

#endif
