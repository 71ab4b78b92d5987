// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_grid_writer_h
#define waker_output_grid_writer_h

#include <waker/nodes/nodal_vector.h>

#include <string>
#include <vector>

namespace Waker
{
  template <int dim>
  class BackgroundGrid;

  /// Names and units of fields on the background grid, and where they stand.
  /// The pointers are borrowed: the fields must outlive the call that writes.
  struct GridFields
  {
    struct Scalar
    {
      std::string                name;
      std::string                unit;
      const std::vector<double> *values; // n_nodes long
    };

    struct Vector
    {
      std::string        name;
      std::string        unit;
      const NodalVector *values; // n_dofs long
    };

    std::vector<Scalar> scalars;
    std::vector<Vector> vectors;
  };

  /**
   * Write nodal fields to a .vtu file, only on cells that have mass on at least
   * one of their nodes.
   *
   * @param node_mass mass of each node (Mg), n_nodes long; it is written as
   *        the field "mass" as well
   * @param time of the state (s), stored in the file
   * @return checksum_of_text() of the file, for PvdSeries::add()
   */
  template <int dim>
  std::string
  write_grid(const BackgroundGrid<dim> &grid,
             const std::vector<double> &node_mass,
             const GridFields          &fields,
             const double               time,
             const std::string         &path);
} // namespace Waker

#endif
