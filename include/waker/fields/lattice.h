// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_fields_lattice_h
#define waker_fields_lattice_h

#include <array>
#include <cstddef>
#include <string>

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

  /// Cells of a lattice in one direction, and of all of it, at most: an
  /// embedding has 2^dim times as many, and still has to be numbered.
  constexpr double largest_lattice = 268435456.; // 2^28

  /**
   * @param path of the field, "Random fields/strength"
   * @throws UserError (Cell size) if there are too many cells in all, or for
   *         the memory that is there
   */
  void
  check_lattice_size(const FieldLattice &lattice, const std::string &path);
} // namespace Waker

#endif
