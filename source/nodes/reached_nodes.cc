// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/nodes/reached_nodes.h>

#include <algorithm>

namespace Waker
{
  template <int dim>
  ReachedNodes::ReachedNodes(const BackgroundGrid<dim> &grid)
    : n{1, 1, 1}
    , exchange(&grid.exchange())
  {
    for (unsigned int d = 0; d < dim; ++d)
      n[d] = grid.n_nodes_per_direction()[d];
    first.resize(n[1] * n[2]);
    last.resize(n[1] * n[2]);
  }


  void
  ReachedNodes::reinit(const std::vector<double> &mass)
  {
    for (std::size_t line = 0; line < first.size(); ++line)
      {
        const double *const m     = mass.data() + line * n[0];
        unsigned int        begin = 0, end = n[0];
        while (begin < end && m[begin] == 0.)
          ++begin;
        while (end > begin && m[end - 1] == 0.)
          --end;
        first[line] = begin < end ? begin : n[0];
        last[line]  = begin < end ? end - 1 : 0;
      }

    runs.clear();
    for (unsigned int k = 0; k < n[2]; ++k)
      for (unsigned int j = 0; j < n[1]; ++j)
        {
          unsigned int begin = n[0], end = 0; // of this and all lines beside it
          for (unsigned int kk = k - (k > 0); kk <= std::min(k + 1, n[2] - 1);
               ++kk)
            for (unsigned int jj = j - (j > 0); jj <= std::min(j + 1, n[1] - 1);
                 ++jj)
              {
                begin = std::min(begin, first[kk * n[1] + jj]);
                end   = std::max(end, last[kk * n[1] + jj]);
              }
          if (begin == n[0])
            continue;
          const std::size_t line = (std::size_t(k) * n[1] + j) * n[0];
          runs.push_back(
            {line + begin - (begin > 0), line + std::min(end + 2, n[0])});
        }

    if (exchange->is_one_rank())
      return;
    owned_runs.clear();
    for (const Run &run : runs)
      {
        bool is_open = false;
        for (std::size_t node = run.begin; node < run.end; ++node)
          {
            const bool is_own = exchange->owns(node);
            if (is_own && !is_open)
              owned_runs.push_back({node, node});
            if (is_own)
              owned_runs.back().end = node + 1;
            is_open = is_own;
          }
      }
  }


  template ReachedNodes::ReachedNodes(const BackgroundGrid<2> &);
  template ReachedNodes::ReachedNodes(const BackgroundGrid<3> &);
} // namespace Waker
