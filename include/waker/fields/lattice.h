// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_fields_lattice_h
#define waker_fields_lattice_h

#include <array>
#include <cstddef>

namespace Waker
{
  /**
   * The cells of a random field: a box of n_cells[0] x n_cells[1] x n_cells[2]
   * equal ones. Unused directions have one cell. Cell (i, j, k) has the number
   * i + n_cells[0] * (j + n_cells[1] * k).
   */
  struct FieldLattice
  {
    unsigned int                dim       = 2; // 1 to 3
    std::array<unsigned int, 3> n_cells   = {{1, 1, 1}};
    std::array<double, 3>       cell_size = {{1., 1., 1.}}; // m
    std::array<double, 3>       origin    = {{0., 0., 0.}}; // lower corner, m

    std::size_t
    n() const
    {
      return std::size_t(n_cells[0]) * n_cells[1] * n_cells[2];
    }

    std::array<unsigned int, 3>
    index(const std::size_t cell) const
    {
      return {{static_cast<unsigned int>(cell % n_cells[0]),
               static_cast<unsigned int>(cell / n_cells[0] % n_cells[1]),
               static_cast<unsigned int>(cell / n_cells[0] / n_cells[1])}};
    }

    /// Centre of a cell (m); 0 in unused directions.
    std::array<double, 3>
    centre(const std::size_t cell) const;

    /// The cell that holds x, or the nearest one (m).
    std::size_t
    cell_of(const std::array<double, 3> &x) const;
  };
} // namespace Waker

#endif
