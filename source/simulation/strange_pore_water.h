// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_strange_pore_water_h
#define waker_source_simulation_strange_pore_water_h

#include <waker/case/case.h>

#include <string>
#include <vector>

namespace Waker
{
  /// Water in the ground that lifts the soil up, soil in it without a law.
  template <int dim>
  void
  warn_of_soil_in_water(const Case<dim>          &the_case,
                        std::vector<std::string> &warnings);

  /// Head lines that cross, undrained soil in cells that lock.
  void
  warn_of_pore_water(const Parameters &p, std::vector<std::string> &warnings);
} // namespace Waker

#endif
