// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_strengths_h
#define waker_simulation_strengths_h

#include <waker/materials/factory.h>
#include <waker/mechanics/stress_update.h>
#include <waker/nodes/wall_parameters.h>

#include <string>
#include <vector>

namespace Waker
{
  /// Divide all that the points' materials call a strength
  /// (MaterialVariable::Role).
  template <int dim>
  void
  divide_strengths(const Materials     &materials,
                   const double         factor,
                   MaterialPoints<dim> &points);

  /// Lines for the log: which materials have strengths, and which have none.
  /// @throws UserError "Materials/Names" if none has
  std::vector<std::string>
  described_strengths(const Materials                       &materials,
                      const std::vector<MaterialParameters> &parameters);

  /// Lines for the log: walls with friction or adhesion, which no factor
  /// divides, for they are properties of the wall.
  std::vector<std::string>
  kept_walls(const std::vector<WallParameters> &walls);
} // namespace Waker

#endif
