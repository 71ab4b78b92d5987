// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_case_pore_water_checks_h
#define waker_source_case_pore_water_checks_h

#include <waker/case/parameters.h>

namespace Waker
{
  /// Water in the ground, and soils whose grains the water outside would press
  /// together if it were not there.
  /// @throws UserError "Pore water/...", or what does not go with it
  void
  check_pore_water(const Parameters &p);
} // namespace Waker

#endif
