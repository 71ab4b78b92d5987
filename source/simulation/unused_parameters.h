// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_unused_parameters_h
#define waker_source_simulation_unused_parameters_h

#include <waker/case/parameters.h>

#include <string>
#include <vector>

namespace Waker
{
  /// Append what is set, but of no effect with what has been chosen.
  void
  warn_of_unused(const Parameters         &parameters,
                 std::vector<std::string> &warnings);
} // namespace Waker

#endif
