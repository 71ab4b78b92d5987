// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_fields_measurements_h
#define waker_fields_measurements_h

#include <waker/fields/lattice.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace Waker
{
  /// A value of the property at a place, of a cone penetration test say.
  struct Measurement
  {
    std::array<double, 3> position = {{0., 0., 0.}}; // m
    double                value    = 0.;             // the property's own unit
    std::size_t           cell     = 0;              // of the lattice
    unsigned int          line     = 0;              // of the file
  };

  /**
   * Reads "x, y[, z], value" (1D: "x, value"; m and the property's unit), one
   * measurement a line. What follows a '#' is a comment, empty lines are
   * skipped, the first line with content may be a header of words.
   *
   * @throws UserError file:line: not dim + 1 finite numbers, or a place
   * outside the lattice; the file cannot be read or has no measurements
   */
  std::vector<Measurement>
  read_measurements(const std::string &file, const FieldLattice &lattice);
} // namespace Waker

#endif
