// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_plan_h
#define waker_particles_plan_h

#include <array>
#include <vector>

namespace Waker
{
  /// A convex polygon in plan: corners x, z, in either orientation.
  using Plan = std::vector<std::array<double, 2>>;


  /// A height that is linear in plan: y = level + x slope[0] + z slope[1].
  struct Plane
  {
    double                level;
    std::array<double, 2> slope;

    double
    at(const double x, const double z) const
    {
      return level + slope[0] * x + slope[1] * z;
    }
  };


  /// The part of a convex polygon in which plane >= 0.
  Plan
  clip(const Plan &polygon, const Plane &plane);

  /// Area, positive in either orientation.
  double
  area_of(const Plan &polygon);
} // namespace Waker

#endif
