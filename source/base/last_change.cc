// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/last_change.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  bool
  varies(const std::function<double(const double)> &f,
         const double                               from,
         const double                               to)
  {
    constexpr unsigned int n_intervals = 1000;
    constexpr double       tolerance   = 1e-6;
    double                 lowest = f(to), highest = lowest;
    for (unsigned int i = 0; i < n_intervals; ++i)
      {
        const double value = f(from + (to - from) * i / n_intervals);
        if (!std::isfinite(value))
          return true;
        lowest  = std::min(lowest, value);
        highest = std::max(highest, value);
      }
    return !(highest - lowest <=
             tolerance * std::max(std::abs(lowest), std::abs(highest)));
  }
} // namespace Waker
