// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_strengths_h
#define waker_simulation_strengths_h

#include <waker/materials/factory.h>
#include <waker/mechanics/stress_update.h>

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
} // namespace Waker

#endif
