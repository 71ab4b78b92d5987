// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/sizes.h>
#include <waker/fields/lattice.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  std::array<double, 3>
  FieldLattice::centre(const std::size_t cell) const
  {
    const std::array<unsigned int, 3> i = index(cell);
    std::array<double, 3>             x{{0., 0., 0.}};
    for (unsigned int d = 0; d < dim; ++d)
      x[d] = origin[d] + (i[d] + 0.5) * cell_size[d];
    return x;
  }


  std::size_t
  FieldLattice::cell_of(const std::array<double, 3> &x) const
  {
    std::array<std::size_t, 3> i{{0, 0, 0}};
    for (unsigned int d = 0; d < dim; ++d)
      i[d] = static_cast<std::size_t>(std::clamp(
        std::floor((x[d] - origin[d]) / cell_size[d]), 0., n_cells[d] - 1.));
    return i[0] + n_cells[0] * (i[1] + n_cells[1] * i[2]);
  }


  void
  check_lattice_size(const FieldLattice &lattice, const std::string &path)
  {
    double      n = 1.;
    std::string cells;
    for (unsigned int d = 0; d < lattice.dim; ++d)
      {
        n *= lattice.n_cells[d];
        cells += (d > 0 ? " x " : "") + std::to_string(lattice.n_cells[d]);
      }
    checked_count(path + "/Cell size",
                  n,
                  "cells of the field (" + cells + ")",
                  largest_lattice,
                  "larger cells");
    // Two numbers per cell, whatever makes them: score and covariance.
    require_memory(path + "/Cell size",
                   "makes a field of " + cells + " cells",
                   16. * n,
                   "larger cells");
  }
} // namespace Waker
