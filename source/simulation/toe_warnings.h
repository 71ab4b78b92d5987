// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_toe_warnings_h
#define waker_source_simulation_toe_warnings_h

#include <waker/case/case.h>

#include <string>
#include <vector>

namespace Waker
{
  /**
   * A toe under water that ends on a firm base in a feather edge which hardly
   * fills its cell: where the water weighs several times the strength, its
   * points fly to and fro there ("boil"). Both limits are those between runs
   * that do and runs that do not (doc/manual.md, section 7).
   */
  template <int dim>
  void
  warn_of_feather_edge(const Case<dim>          &the_case,
                       std::vector<std::string> &warnings);
} // namespace Waker

#endif
