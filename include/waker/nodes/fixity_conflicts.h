// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_fixity_conflicts_h
#define waker_nodes_fixity_conflicts_h

#include <waker/nodes/fixities.h>

#include <string>
#include <vector>

namespace Waker
{
  /**
   * Conditions that want different movements of the same nodes in the same
   * direction: a text for each two, with the number of nodes and which of them
   * counts. Where faces meet in an edge that is usual, and not told; so are
   * conditions that want the same.
   */
  template <int dim>
  std::vector<std::string>
  fixity_conflicts(const BackgroundGrid<dim>           &grid,
                   const std::vector<FixityParameters> &parameters);
} // namespace Waker

#endif
