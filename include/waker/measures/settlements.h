// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_measures_settlements_h
#define waker_measures_settlements_h

#include <waker/particles/material_points.h>

#include <algorithm>
#include <vector>

namespace Waker
{
  /// How far points sink in a step. Work space.
  template <int dim>
  class Settlements
  {
  public:
    /// A step begins.
    void
    begin(const MaterialPoints<dim> &points)
    {
      heights.resize(points.n_points());
      for (std::size_t p = 0; p < points.n_points(); ++p)
        heights[p] = points.position[p][1];
    }

    /// The largest settlement of a point since (m), at least 0; the points are
    /// the same, in the same order.
    double
    largest(const MaterialPoints<dim> &points) const
    {
      double largest = 0.;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        largest = std::max(largest, heights[p] - points.position[p][1]);
      return largest;
    }

  private:
    std::vector<double> heights; // m
  };
} // namespace Waker

#endif
