// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/particles/rows.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Waker
{
  std::vector<double>
  divide(const double begin, const double end, const double largest)
  {
    Assert(end > begin && largest >= 1., dealii::ExcInternalError());
    const double length = end - begin;
    const double n      = std::max(
      {1., std::round(length), std::ceil(length / largest * (1. - 1e-12))});
    std::vector<double> ends;
    for (unsigned int k = 0; k < n; ++k)
      ends.push_back(begin + length * (k / n));
    ends.push_back(end);
    return ends;
  }


  std::vector<RowRectangle>
  fill_rows(const Polygon &corners, const double largest)
  {
    double low  = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    for (const auto &corner : corners)
      {
        low  = std::min(low, corner[1]);
        high = std::max(high, corner[1]);
      }

    std::vector<RowRectangle> rectangles;
    std::vector<double>       crossings;
    for (int row = static_cast<int>(std::floor(low)); row < high; ++row)
      {
        const double y = row + 0.5;
        crossings.clear();
        for (std::size_t k = 0; k < corners.size(); ++k)
          {
            const auto &a = corners[k], &b = corners[(k + 1) % corners.size()];
            // An edge has its lower end, but not its upper one: a corner at
            // mid-height counts once, or twice where the polygon turns back.
            if ((a[1] <= y) == (b[1] <= y))
              continue;
            const double s = (y - a[1]) / (b[1] - a[1]);
            crossings.push_back(a[0] + s * (b[0] - a[0]));
          }
        std::sort(crossings.begin(), crossings.end());
        Assert(crossings.size() % 2 == 0, dealii::ExcInternalError());
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
          {
            if (crossings[k + 1] - crossings[k] < 1e-6)
              continue;
            const std::vector<double> ends =
              divide(crossings[k], crossings[k + 1], largest);
            for (std::size_t i = 0; i + 1 < ends.size(); ++i)
              rectangles.push_back({row, ends[i], ends[i + 1]});
          }
      }
    return rectangles;
  }
} // namespace Waker
