// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/particles/plan.h>

#include <cmath>

namespace Waker
{
  namespace
  {
    using Corner = std::array<double, 2>;
  }


  Plan
  clip(const Plan &polygon, const Plane &plane)
  {
    Plan kept;
    for (std::size_t i = 0; i < polygon.size(); ++i)
      {
        const Corner &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double  g_p = plane.at(p[0], p[1]), g_q = plane.at(q[0], q[1]);
        if (g_p >= 0.)
          kept.push_back(p);
        if ((g_p > 0. && g_q < 0.) || (g_p < 0. && g_q > 0.))
          {
            const double s = g_p / (g_p - g_q);
            kept.push_back(
              {{p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])}});
          }
      }
    if (kept.size() < 3)
      kept.clear();
    return kept;
  }


  double
  area_of(const Plan &polygon)
  {
    double twice = 0.;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      {
        const Corner &a = polygon[0], &b = polygon[i], &c = polygon[i + 1];
        twice += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      }
    return std::abs(twice) / 2.;
  }
} // namespace Waker
