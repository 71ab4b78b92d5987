// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_storm_warnings_h
#define waker_source_simulation_storm_warnings_h

#include <waker/case/parameters.h>

#include <string>
#include <vector>

namespace Waker
{
  /// Of water that rises and falls: a run that ends before the peak, and hours
  /// in short steps.
  std::vector<std::string>
  storm_warnings(const Parameters &parameters);
} // namespace Waker

#endif
