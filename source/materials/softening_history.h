// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_materials_softening_history_h
#define waker_source_materials_softening_history_h

#include <waker/materials/material.h>

#include <algorithm>
#include <vector>

namespace Waker
{
  /// What nonlocal softening remembers, behind all else: "nonlocal plastic
  /// strain", the sum of the measure's increments, and "softening strain", the
  /// most it has been.
  inline void
  append_softening_history(std::vector<MaterialVariable> &list)
  {
    using Role = MaterialVariable::Role;
    list.push_back({"nonlocal plastic strain", "-", 0., Role::history});
    list.push_back({"softening strain", "-", 0., Role::history});
  }


  /// The measure goes down where a point strains more than its surroundings:
  /// lost strength does not come back, and more is lost only beyond the most
  /// that it has been.
  /// @param history these two variables
  /// @return the growth of the softening strain
  inline double
  grow_softening_strain(const double increment, double *history)
  {
    history[0] += increment;
    const double before = history[1];
    history[1]          = std::max(before, history[0]);
    return history[1] - before;
  }
} // namespace Waker

#endif
