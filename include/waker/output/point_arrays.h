// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_point_arrays_h
#define waker_output_point_arrays_h

#include <waker/base/own_rows.h>
#include <waker/particles/material_points.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace Waker
{
  class JointFile;

  /**
   * The arrays of points as bytes, one after the other, in the order of
   * MaterialPoints::for_each_array(): what a checkpoint has of them. Exact, for
   * the same machine. How many values each has is kept beside them.
   */

  /// Of each array how many values it has on all ranks together; a rank without
  /// points is told by the others. Collective.
  template <int dim>
  std::vector<std::uint64_t>
  array_sizes(const MaterialPoints<dim> &own, const OwnRows &rows);

  /// Bytes of arrays of these sizes.
  template <int dim>
  std::uint64_t
  n_bytes_of_arrays(const MaterialPoints<dim>        &points,
                    const std::vector<std::uint64_t> &sizes);

  /// The values, points in the order of the rows, whatever rank has them.
  /// Collective.
  /// @param sizes array_sizes()
  template <int dim>
  void
  add_arrays(const MaterialPoints<dim>        &own,
             const OwnRows                    &rows,
             const std::vector<std::uint64_t> &sizes,
             JointFile                        &file);

  /// At the end of a text, on one rank.
  template <int dim>
  void
  append_arrays(const MaterialPoints<dim> &points, std::string &bytes);

  /// The other way.
  /// @param points their arrays have the sizes that are in the bytes
  /// @throws std::runtime_error if there are not as many bytes
  template <int dim>
  void
  read_arrays(const std::string_view bytes, MaterialPoints<dim> &points);
} // namespace Waker

#endif
