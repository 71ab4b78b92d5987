// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_wall_warnings_h
#define waker_simulation_wall_warnings_h

#include <waker/case/case.h>

#include <string>
#include <vector>

namespace Waker
{
  /// Friction that is none, that no soil reaches, or that is not used.
  void
  warn_of_friction(const Parameters &p, std::vector<std::string> &warnings);

  /// Walls that no soil touches at the start, that boundary conditions keep it
  /// from, and frictional ones along a line of the grid.
  template <int dim>
  void
  warn_of_walls(const Case<dim> &the_case, std::vector<std::string> &warnings);
} // namespace Waker

#endif
