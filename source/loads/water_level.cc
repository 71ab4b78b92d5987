// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/loads/water_level.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  double
  WaterLevel::longest_step(const double t,
                           const double longest,
                           const double most,
                           const double least) const
  {
    if (!moves())
      return longest;
    // Round-off in the sum of the steps must not make one of nearly nothing.
    const double round_off = 1e-9 * (1. + std::abs(t));
    double       step = std::min(longest, rise.next_corner(t + round_off) - t);
    const double now  = rise.value(t);
    while (step > least)
      {
        constexpr unsigned int n     = 16;
        double                 worst = 0.;
        for (unsigned int i = 1; i <= n; ++i)
          worst = std::max(worst, std::abs(rise.value(t + step * i / n) - now));
        if (!(worst > most * (1. + 1e-9)))
          return step;
        // Of a straight line this is it; an expression is asked again.
        step *= std::clamp(most / worst, 1. / n, 1. - 1e-3);
      }
    return std::min(longest, std::max(step, least));
  }
} // namespace Waker
