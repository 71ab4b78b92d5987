// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_boxes_box_union_coordinates_h
#define waker_surface_boxes_box_union_coordinates_h

#include <array>
#include <cstdint>
#include <vector>

namespace Waker
{
  /**
   * Coordinates by rank. Those that follow each other more closely than a
   * tolerance get one rank and one value, the smallest: edges that meet, but
   * for round-off, meet exactly.
   */
  class SnappedCoordinates
  {
  public:
    struct Entry
    {
      double        x; // m
      std::uint32_t tag;
      std::uint32_t rank; // while they are sorted: bucket
    };

    void
    clear()
    {
      unsorted.clear();
    }

    /// @param tag what the coordinate stands for
    void
    add(const double x, const std::uint32_t tag)
    {
      unsorted.push_back({x, tag, 0});
    }

    /// Sort and rank. Linear in the number of entries if they are spread
    /// evenly.
    void
    rank(const double tolerance);

    /// All entries, in ascending order, those of one rank in any.
    const std::vector<Entry> &
    sorted() const
    {
      return entries;
    }

    /// The coordinate of each rank (m).
    std::vector<double> values;

  private:
    std::vector<Entry>         unsorted;
    std::vector<Entry>         entries;
    std::vector<std::uint32_t> bucket_ends;
  };



  /// A set of numbers below a limit, with the next smaller one found in a few
  /// operations: a tree of bits with 64 branches at each node.
  class RankSet
  {
  public:
    /// Make it empty, for numbers below `size`.
    void
    reinit(const unsigned int limit);

    bool
    contains(const unsigned int r) const
    {
      return levels[0][r >> 6] >> (r & 63u) & 1u;
    }

    void
    insert(unsigned int r)
    {
      for (unsigned int l = 0; l < n_levels; ++l, r >>= 6)
        levels[l][r >> 6] |= std::uint64_t(1) << (r & 63u);
    }

    void
    erase(unsigned int r)
    {
      for (unsigned int l = 0; l < n_levels; ++l, r >>= 6)
        if ((levels[l][r >> 6] &= ~(std::uint64_t(1) << (r & 63u))) != 0)
          return;
    }

    /// The largest number below r. There must be one.
    unsigned int
    previous(unsigned int r) const
    {
      for (unsigned int l = 0;; ++l, r >>= 6)
        {
          const std::uint64_t below =
            levels[l][r >> 6] & ((std::uint64_t(1) << (r & 63u)) - 1);
          if (below == 0)
            continue;
          r = (r & ~63u) | (63 - __builtin_clzll(below));
          while (l-- > 0)
            r = r << 6 | (63 - __builtin_clzll(levels[l][r]));
          return r;
        }
    }

  private:
    static constexpr unsigned int max_levels = 5;

    std::array<std::vector<std::uint64_t>, max_levels> levels;
    unsigned int                                       n_levels = 0;
  };
} // namespace Waker

#endif
