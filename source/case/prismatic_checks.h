// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_case_prismatic_checks_h
#define waker_source_case_prismatic_checks_h

#include <waker/case/parameters.h>
#include <waker/particles/layer_body.h>

#include <vector>

namespace Waker
{
  /// With Surface/Prismatic: that each polygon reaches from one end of the box
  /// to the other along z, in one layer or in several behind each other.
  /// @throws UserError "Surface/Prismatic"
  void
  check_prismatic(const Parameters &p);

  /// With Surface/Prismatic: that no height map varies along z.
  /// @param bodies of the layers
  /// @throws UserError "Surface/Prismatic"
  void
  check_prismatic(const Parameters &p, const std::vector<LayerBody> &bodies);
} // namespace Waker

#endif
