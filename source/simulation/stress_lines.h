// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_stress_lines_h
#define waker_source_simulation_stress_lines_h

#include <waker/case/case.h>

#include <string>
#include <vector>

namespace Waker
{
  /// What is said of the stress at t = 0, if it is more than a gravity step:
  /// how each stage came into balance; and by material, if strengths or K0
  /// follow from it, least, mean and largest stress, strength and
  /// overconsolidation.
  template <int dim>
  std::vector<std::string>
  stress_lines(const Case<dim> &the_case);
} // namespace Waker

#endif
