// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_strange_b_bar_h
#define waker_source_simulation_strange_b_bar_h

#include <waker/case/parameters.h>

#include <string>
#include <vector>

namespace Waker
{
  /// Warnings of B-bar in all cells, where B-bar would not need any.
  void
  strange_b_bar(const Parameters &p, std::vector<std::string> &warnings);
} // namespace Waker

#endif
