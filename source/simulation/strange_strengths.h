// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_strange_strengths_h
#define waker_source_simulation_strange_strengths_h

#include <waker/case/case.h>

#include <string>
#include <vector>

namespace Waker
{
  /// Of the points: strengths that are expressions, the least and the largest;
  /// what softening leaves; a cut-off that has no effect; stress at rest.
  template <int dim>
  void
  check_strengths_of_points(const Case<dim>          &the_case,
                            std::vector<std::string> &warnings);
} // namespace Waker

#endif
