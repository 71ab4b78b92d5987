// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_fragility_points_h
#define waker_tests_fragility_points_h

#include <waker/statistics/fragility.h>

namespace Waker::FragilityPoints
{
  /// 5 m of crest: `count` of n flooded, ten more failed.
  inline FragilityPoint
  point(const double level, const std::uint64_t count, const std::uint64_t n)
  {
    return {level, 5. - level, proportion(count + 10, n), proportion(count, n)};
  }
} // namespace Waker::FragilityPoints

#endif
