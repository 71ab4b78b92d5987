// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_grid_cell_owners_h
#define waker_grid_cell_owners_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Waker
{
  /// Which rank owns which cells of a grid. A cell has the number of its lower
  /// left node.
  struct CellOwners
  {
    /// Cells [begin, end) of the whole grid that are one rank's.
    struct Interval
    {
      std::size_t   begin, end;
      unsigned int  rank;
      std::uint64_t number; // of the first, counted rank by rank
    };

    std::vector<Interval> intervals; // of all ranks, ascending, without gaps

    std::vector<Interval>::const_iterator
    interval_of(const std::size_t cell) const
    {
      return std::upper_bound(intervals.begin(),
                              intervals.end(),
                              cell,
                              [](const std::size_t n,
                                 const Interval   &interval) {
                                return n < interval.begin;
                              }) -
             1;
    }

    unsigned int
    owner(const std::size_t cell) const
    {
      return interval_of(cell)->rank;
    }
  };
} // namespace Waker

#endif
