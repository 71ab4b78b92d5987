// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_output_data_array_h
#define waker_source_output_data_array_h

#include "joint_file.h"
#include <cstddef>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * Values of so many points are compressed together. On several ranks each
   * compresses its own, so their number must not depend on that of the ranks.
   * Numbers of 4 bytes fill half of the window of 32 kB in which zlib looks
   * back: a file of 790,528 points is 0.8 % longer than with one block an
   * array.
   */
  constexpr std::size_t points_per_block = 4096;

  /// Of an array.
  struct DataRows
  {
    std::size_t n_all;     // of all ranks together
    std::size_t per_block; // where a rank's rows begin is a multiple of it
    std::size_t size;      // of one, bytes
  };

  /**
   * Add a <DataArray> to a file: compressed (zlib), inline, in base64, as VTK
   * has it: a header (how many blocks, their size, that of the last one; sizes
   * when compressed), and the blocks. Without entries as text: some readers
   * take an empty compressed array for a damaged one. Private to the room.
   * Collective.
   *
   * @param attributes of the tag
   * @param values of the rows in this rank's range
   */
  void
  add_data_array(const std::string       &attributes,
                 const std::vector<char> &values,
                 const DataRows          &rows,
                 JointFile               &file);
} // namespace Waker

#endif
