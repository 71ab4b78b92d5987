// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_layer_body_h
#define waker_particles_layer_body_h

#include <waker/particles/height_map.h>
#include <waker/particles/polygon.h>
#include <waker/particles/sub_cells.h>

#include <memory>
#include <vector>

namespace Waker
{
  /**
   * What a layer fills: a prism, of which height maps may leave the part
   * between them. In 2D the prism is 1 m thick, and there are no maps. Lengths
   * in m, or in units of a lattice.
   */
  struct LayerBody
  {
    Polygon corners;    // in x-y, anticlockwise
    double  begin = 0.; // extent along z
    double  end   = 1.;
    /// What lies above `top` and below `bottom` is left away; none: nullptr.
    std::shared_ptr<const HeightMap> top;
    std::shared_ptr<const HeightMap> bottom;

    bool
    is_prism() const
    {
      return top == nullptr && bottom == nullptr;
    }

    /// A stretch of the vertical line through a place.
    struct Stretch
    {
      double low, high;
    };

    /**
     * The stretches of the vertical line through (x, z) in the body, from
     * below.
     *
     * @param right a line through a corner of the prism, or through a joint of
     *        two, belongs to what lies on its right, or on its left
     */
    std::vector<Stretch>
    stretches(const double x, const double z, const bool right) const;

    /// The height of the highest place at z; exact. Nothing there: -infinity.
    double
    highest_at(const double z) const;

    /// Volume; exact.
    double
    volume() const;
  };


  /**
   * The parts of the lattice's unit cubes in a body in units of the lattice,
   * those that are not empty, lexicographically (i fastest); none is given to a
   * neighbour. Exact: over each place the body is bounded by planes, whose
   * volume and first moment are integrated piece by piece.
   */
  std::vector<LatticePart<3>>
  cut_body(const LayerBody &body);

  /// The volume that two bodies share; exact.
  double
  common_volume(const LayerBody &a, const LayerBody &b);
} // namespace Waker

#endif
