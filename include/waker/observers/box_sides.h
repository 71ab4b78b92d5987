// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_observers_box_sides_h
#define waker_observers_box_sides_h

#include <waker/grid/background_grid.h>
#include <waker/particles/material_points.h>

#include <array>
#include <vector>

namespace Waker
{
  /// Volume (m^dim) of the soil that lies in the outermost cells at the left
  /// and at the right side of the grid's box, or beyond, was not there at the
  /// start, and has moved along x by more than half a cell. So a foundation
  /// that reaches the side from the beginning is not meant.
  template <int dim>
  std::array<double, 2>
  soil_come_to_sides(const BackgroundGrid<dim> &grid,
                     const MaterialPoints<dim> &points);

  /**
   * Has soil come to the left or right side of the box, so that the box holds
   * it? That is half a cell's volume of it: one row of points of the usual two.
   *
   * @param open_faces of the box, by number (2d lower, 2d + 1 upper): what
   *        passes is removed or fed, and lies against nothing
   */
  template <int dim>
  bool
  soil_lies_against_side(const BackgroundGrid<dim> &grid,
                         const MaterialPoints<dim> &points,
                         const std::vector<bool>   &open_faces);
} // namespace Waker

#endif
