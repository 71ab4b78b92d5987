// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mapping_lanes_h
#define waker_mapping_lanes_h

#include <waker/mapping/node_row.h>

namespace Waker
{
  /// Numbers of some material points, one per lane of a vector of the processor
  /// (GCC's and Clang's vector extension): one register of AVX, two of SSE2.
  using SingleLanes = float __attribute__((vector_size(32)));
  using DoubleLanes = Four;

  template <typename Lanes>
  struct LaneTraits;

  template <>
  struct LaneTraits<SingleLanes>
  {
    using Number                    = float;
    static constexpr unsigned int n = 8;
  };

  template <>
  struct LaneTraits<DoubleLanes>
  {
    using Number                    = double;
    static constexpr unsigned int n = 4;
  };

  /// Entry i of the result: the sum over the lanes of v[i], for as many as
  /// there are lanes.
  inline SingleLanes
  sums_over_lanes(const SingleLanes *const v)
  {
    const auto pairs = [](const SingleLanes a, const SingleLanes b) {
      return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14) +
             __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    };
    const auto fours = [](const SingleLanes ab, const SingleLanes cd) {
      return __builtin_shufflevector(ab, cd, 0, 1, 8, 9, 4, 5, 12, 13) +
             __builtin_shufflevector(ab, cd, 2, 3, 10, 11, 6, 7, 14, 15);
    };
    const SingleLanes low  = fours(pairs(v[0], v[1]), pairs(v[2], v[3]));
    const SingleLanes high = fours(pairs(v[4], v[5]), pairs(v[6], v[7]));
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 8, 9, 10, 11) +
           __builtin_shufflevector(low, high, 4, 5, 6, 7, 12, 13, 14, 15);
  }

  inline DoubleLanes
  sums_over_lanes(const DoubleLanes *const v)
  {
    const auto pairs = [](const DoubleLanes a, const DoubleLanes b) {
      return __builtin_shufflevector(a, b, 0, 4, 2, 6) +
             __builtin_shufflevector(a, b, 1, 5, 3, 7);
    };
    const DoubleLanes low = pairs(v[0], v[1]), high = pairs(v[2], v[3]);
    return __builtin_shufflevector(low, high, 0, 1, 4, 5) +
           __builtin_shufflevector(low, high, 2, 3, 6, 7);
  }
} // namespace Waker

#endif
