// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_layer_gaps_h
#define waker_particles_layer_gaps_h

#include <waker/particles/layer_body.h>
#include <waker/particles/soil_profile.h>

#include <string>
#include <vector>

namespace Waker
{
  /// Air between two layers that are likely meant to touch.
  struct LayerGap
  {
    std::string           one, other; // names of the layers
    double                width;      // m, in the middle of the widest part
    double                length;     // m, over all facing edges
    std::array<double, 2> middle;     // m, of the widest part
  };

  /**
   * Edges of two layers that face each other with nothing between: at most
   * `largest` (m) apart, or one above the other at any distance. Layers that
   * do not overlap along z, in 3D, do not face each other.
   *
   * One gap per pair of layers; pairs with a height map are for body_gaps().
   */
  std::vector<LayerGap>
  layer_gaps(const std::vector<LayerParameters> &layers, const double largest);


  /// Air between two layers one above the other, of which a height map bounds
  /// one.
  struct BodyGap
  {
    std::size_t           lower, upper; // numbers of the layers
    double                height;       // m, of the widest place
    double                area;         // m^2, in plan
    std::array<double, 3> middle;       // m, of the widest place
  };

  /// One gap per pair of layers, from vertical lines `spacing` (m) apart.
  std::vector<BodyGap>
  body_gaps(const std::vector<LayerBody> &bodies, const double spacing);
} // namespace Waker

#endif
