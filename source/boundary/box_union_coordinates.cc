// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/boundary/box_union_coordinates.h>

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

    // Into n buckets of equal width, and each bucket for itself.
    const auto by_x = [](const Entry &a, const Entry &b) { return a.x < b.x; };
    const auto range =
      std::minmax_element(unsorted.begin(), unsorted.end(), by_x);
    const double lowest = range.first->x;
    const double extent = range.second->x - lowest;
    const double scale  = extent > 0. ? (n - 1) / extent : 0.;
    const auto   bucket = [=](const double x) {
      return std::min<std::size_t>((x - lowest) * scale, n - 1);
    };
    bucket_ends.assign(n + 1, 0);
    for (const Entry &entry : unsorted)
      ++bucket_ends[bucket(entry.x) + 1];
    for (std::size_t b = 0; b < n; ++b)
      bucket_ends[b + 1] += bucket_ends[b];
    for (const Entry &entry : unsorted)
      entries[bucket_ends[bucket(entry.x)]++] = entry;
    for (std::size_t b = 0, begin = 0; b < n; begin = bucket_ends[b++])
      if (bucket_ends[b] - begin > 1)
        std::sort(entries.begin() + begin,
                  entries.begin() + bucket_ends[b],
                  by_x);

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
