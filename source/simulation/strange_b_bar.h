// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_strange_b_bar_h
#define waker_source_simulation_strange_b_bar_h

#include <waker/case/case.h>

#include <string>
#include <vector>

namespace Waker
{
  /// Warnings of B-bar in all cells, where B-bar would not need any.
  template <int dim>
  void
  warn_of_b_bar(const Case<dim> &the_case, std::vector<std::string> &warnings);
} // namespace Waker

#endif
