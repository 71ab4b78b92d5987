// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_prismatic_warnings_h
#define waker_source_simulation_prismatic_warnings_h

#include <waker/case/parameters.h>
#include <waker/particles/layer_body.h>

#include <string>
#include <vector>

namespace Waker
{
  /// With Surface/Prismatic: the layers that do not reach from one end of the
  /// box to the other along z (alone, or with others of the same polygon behind
  /// them), and the height maps that vary along z.
  /// @param bodies of the layers
  std::vector<std::string>
  prismatic_warnings(const Parameters &p, const std::vector<LayerBody> &bodies);
} // namespace Waker

#endif
