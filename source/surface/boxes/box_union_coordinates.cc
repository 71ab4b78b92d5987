// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/boxes/box_union_coordinates.h>

#include <algorithm>

namespace Waker
{
  void
  SnappedCoordinates::rank(const double tolerance)
  {
    const std::size_t n = unsorted.size();
    entries.resize(n);
    values.clear();
    if (n == 0)
      return;

    double lowest  = unsorted[0].x;
    double highest = lowest;
    for (const Entry &entry : unsorted)
      {
        lowest  = std::min(lowest, entry.x);
        highest = std::max(highest, entry.x);
      }

    // Into two buckets for each entry, of equal width.
    const std::size_t n_buckets = 2 * n;
    const double      extent    = highest - lowest;
    const double      scale     = extent > 0. ? (n_buckets - 1) / extent : 0.;
    bucket_ends.assign(n_buckets + 1, 0);
    for (Entry &entry : unsorted)
      {
        entry.rank =
          std::min(static_cast<std::uint32_t>((entry.x - lowest) * scale),
                   static_cast<std::uint32_t>(n_buckets - 1));
        ++bucket_ends[entry.rank + 1];
      }
    constexpr std::uint32_t many    = 16;
    bool                    crowded = false;
    for (std::size_t b = 0; b < n_buckets; ++b)
      {
        crowded |= bucket_ends[b + 1] > many;
        bucket_ends[b + 1] += bucket_ends[b];
      }
    for (const Entry &entry : unsorted)
      entries[bucket_ends[entry.rank]++] = entry;

    // Within the buckets by insertion, unless there are many in one.
    if (crowded)
      for (std::size_t b = 0, begin = 0; b < n_buckets;
           begin = bucket_ends[b++])
        if (bucket_ends[b] - begin > many)
          std::sort(entries.begin() + begin,
                    entries.begin() + bucket_ends[b],
                    [](const Entry &a, const Entry &b) { return a.x < b.x; });
    for (std::size_t k = 1; k < n; ++k)
      {
        if (!(entries[k].x < entries[k - 1].x))
          continue;
        const Entry entry = entries[k];
        std::size_t i     = k;
        for (; i > 0 && entry.x < entries[i - 1].x; --i)
          entries[i] = entries[i - 1];
        entries[i] = entry;
      }

    double last = entries[0].x;
    values.push_back(last);
    for (Entry &entry : entries)
      {
        if (entry.x - last > tolerance)
          values.push_back(entry.x);
        last       = entry.x;
        entry.rank = values.size() - 1;
      }
  }



  void
  RankSet::reinit(const unsigned int limit)
  {
    n_levels       = 0;
    unsigned int n = std::max(limit, 1u);
    do
      {
        n = (n + 63) / 64;
        levels[n_levels++].assign(n, 0);
    } while (n > 1);
  }
} // namespace Waker
