// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/point_groups.h>

#include <algorithm>

namespace Waker
{
  template <typename Lanes>
  void
  PointGroups<Lanes>::reinit(const Weights<3> &weights)
  {
    const std::size_t  n_points = weights.size();
    const unsigned int n_nodes  = weights.background_grid().n_nodes();
    // First the number of points of each base, then the place of its next one.
    next_place.assign(n_nodes, 0);
    for (std::size_t p = 0; p < n_points; ++p)
      ++next_place[weights[p].base];
    groups.clear();
    for (unsigned int node = 0; node < n_nodes; ++node)
      {
        unsigned int n   = next_place[node];
        next_place[node] = n_lanes * groups.size();
        while (n > 0)
          {
            groups.emplace_back();
            groups.back().base     = node;
            groups.back().n_points = std::min(n, n_lanes);
            n -= groups.back().n_points;
          }
      }

    // The weights of lanes without a point stay 0, as they were made.
    places.resize(n_points);
    for (std::size_t p = 0; p < n_points; ++p)
      {
        const PointWeights<3> &w     = weights[p];
        const std::uint32_t    place = next_place[w.base]++;
        places[p]                    = place;
        PointGroup<Lanes> &group     = groups[place / n_lanes];
        const unsigned int lane      = place % n_lanes;
        for (unsigned int d = 0; d < 3; ++d)
          for (unsigned int i = 0; i < 3; ++i)
            {
              group.value[d][i][lane]    = w.value[d][i];
              group.gradient[d][i][lane] = w.gradient[d][i];
            }
      }
  }


  template class PointGroups<SingleLanes>;
  template class PointGroups<DoubleLanes>;
} // namespace Waker
