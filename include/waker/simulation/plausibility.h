// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_plausibility_h
#define waker_simulation_plausibility_h

#include <waker/case/case.h>

#include <string>
#include <vector>

namespace Waker
{
  /**
   * What is allowed, but is likely not meant: values far from those of soils
   * and of water (a unit that is not the one asked for), gaps between layers,
   * one point per cell. A text each, that begins with the path of the
   * parameter and has the value and what is usual.
   */
  std::vector<std::string>
  strange_parameters(const Parameters &parameters);

  /// These, and what only shows in the case: waves or soil that cross many
  /// cells in a step, cells of two stiffnesses, loads of more than 1000 kPa or
  /// of several times the weight of all soil.
  template <int dim>
  std::vector<std::string>
  strange_things(const Case<dim> &the_case);
} // namespace Waker

#endif
