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
   * So many rows of an array are compressed together. On several ranks each
   * compresses its own, so their number must not depend on that of the ranks.
   * Numbers of 4 bytes fill the window of 32 kB in which zlib looks back half:
   * a file of 790,528 points is 0.8 % longer than with one block an array.
   */
  constexpr std::size_t rows_per_block = 4096;

  /**
   * Add a <DataArray> to a file: compressed (zlib), inline, in base64, as VTK
   * has it: a header (how many blocks, their size, that of the last one; sizes
   * when compressed), and the blocks. Without entries as text: some readers
   * take an empty compressed array for a damaged one. Private to the room.
   * Collective.
   *
   * @param attributes of the tag
   * @param values of the rows in this rank's range
   * @param n_all of the rows of all ranks
   * @param size of a row, bytes
   */
  void
  add_data_array(const std::string       &attributes,
                 const std::vector<char> &values,
                 const std::size_t        n_all,
                 const std::size_t        size,
                 JointFile               &file);
} // namespace Waker

#endif
