// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_strange_softening_h
#define waker_source_simulation_strange_softening_h

#include <waker/case/parameters.h>

#include <string>
#include <vector>

namespace Waker
{
  /// Softening that is nearly, or under pressure, as steep as unloading, and
  /// averages that regularise nothing, or take long.
  void
  check_softening(const MaterialParameters &material,
                  const GridParameters     &grid,
                  const unsigned int        points_per_direction,
                  std::vector<std::string> &warnings);
} // namespace Waker

#endif
