// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_seeds_h
#define waker_particles_seeds_h

#include <waker/particles/layer.h>
#include <waker/particles/soil_profile.h>

#include <cstdint>
#include <vector>

namespace Waker
{
  /// A point to be: its place in the order of creation and its part.
  template <int dim>
  struct Seed
  {
    std::uint64_t  order; // cells lexicographically, sub-cells likewise in them
    unsigned int   layer; // number
    double         volume;    // m^dim
    Point<dim>     position;  // m
    Tensor<1, dim> half_size; // m
  };


  /// The points of all layers, in their order; see make_material_points().
  /// @throws UserError ".../Polygon" of a layer that leaves no points, or
  /// others than it should
  template <int dim>
  std::vector<Seed<dim>>
  make_seeds(const BackgroundGrid<dim>     &grid,
             const std::vector<Layer<dim>> &layers,
             const MaterialPointParameters &parameters);
} // namespace Waker

#endif
