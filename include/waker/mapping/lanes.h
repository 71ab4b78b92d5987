// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mapping_lanes_h
#define waker_mapping_lanes_h

namespace Waker
{
  /**
   * Eight numbers of single precision, one per material point of a group, as a
   * vector of the processor (GCC's and Clang's vector extension): one register
   * of AVX, two of SSE2.
   */
  using Lanes = float __attribute__((vector_size(32)));

  constexpr unsigned int n_lanes = 8;

  /// Entry i of the result: the sum over the lanes of v[i].
  inline Lanes
  sums_over_lanes(const Lanes *const v)
  {
    const auto pairs = [](const Lanes a, const Lanes b) {
      return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14) +
             __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    };
    const auto fours = [](const Lanes ab, const Lanes cd) {
      return __builtin_shufflevector(ab, cd, 0, 1, 8, 9, 4, 5, 12, 13) +
             __builtin_shufflevector(ab, cd, 2, 3, 10, 11, 6, 7, 14, 15);
    };
    const Lanes low  = fours(pairs(v[0], v[1]), pairs(v[2], v[3]));
    const Lanes high = fours(pairs(v[4], v[5]), pairs(v[6], v[7]));
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 8, 9, 10, 11) +
           __builtin_shufflevector(low, high, 4, 5, 6, 7, 12, 13, 14, 15);
  }
} // namespace Waker

#endif
