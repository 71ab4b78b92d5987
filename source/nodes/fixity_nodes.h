// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_nodes_fixity_nodes_h
#define waker_source_nodes_fixity_nodes_h

#include <waker/nodes/fixities.h>

#include <vector>

namespace Waker
{
  /// The nodes of a condition's region, ascending.
  /// @throws UserError "Boundary conditions/<name>" if there is none
  template <int dim>
  std::vector<unsigned int>
  nodes_of(const BackgroundGrid<dim> &grid, const FixityParameters &fixity);
} // namespace Waker

#endif
