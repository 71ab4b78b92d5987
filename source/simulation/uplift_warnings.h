// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_uplift_warnings_h
#define waker_source_simulation_uplift_warnings_h

#include <waker/case/case.h>

#include <string>
#include <vector>

namespace Waker
{
  /// Water in the ground that comes to carry more than the soil above weighs,
  /// as it follows the water outside, which rises by Water/Rise, by a load
  /// programme, or both: when at the soonest, at which level, where, and by
  /// which line.
  template <int dim>
  void
  warn_of_uplift_to_come(const Case<dim>          &the_case,
                         std::vector<std::string> &warnings);
} // namespace Waker

#endif
