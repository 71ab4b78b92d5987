// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/observers/failure_record.h>

#include <cmath>

namespace Waker
{
  void
  FailureRecord::update(const DykeGeometry         &measured,
                        const double                time,
                        const double                level,
                        const bool                  has_water,
                        const InitialFailureLimits &limits)
  {
    geometry = measured;
    if (!started)
      {
        started        = true;
        initial_width  = geometry.width;
        initial_height = geometry.height;
        return;
      }

    const bool floods =
      has_water && (geometry.height < level || geometry.width == 0.);
    if (floods && flooding_time < 0.)
      flooding_time = time;

    const double change = geometry.width - initial_width;
    if (initial_time_thesis < 0. && (change < -limits.width_change || floods))
      initial_time_thesis = time;
    if (initial_time < 0. &&
        (std::abs(change) > limits.width_change ||
         geometry.height < initial_height - limits.height_loss || floods))
      initial_time = time;
  }
} // namespace Waker
