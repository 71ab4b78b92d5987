// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_measures_top_view_h
#define waker_measures_top_view_h

#include <waker/grid/background_grid.h>
#include <waker/particles/material_points.h>

#include <vector>

namespace Waker
{
  /**
   * The ground as seen from above: a raster of squares, two by two in each cell
   * of the grid, over its box. In 2D it is one row of them along x.
   *
   * What is seen in a square is the point whose domain (position +- half size)
   * reaches highest over the square's middle or, where none covers that (soil
   * that has spread), highest of those that reach into the square. Of several
   * that reach equally high it is the one with the smallest id, whatever their
   * order.
   */
  template <int dim>
  struct TopView
  {
    /// What is seen in a square without soil.
    static constexpr int none = -1;

    double       side; // of a square, m
    double       x, z; // lower corner of the raster, m
    unsigned int n_x, n_z;
    /// Square (i, k) is number k * n_x + i of these.
    std::vector<double> height; // of the soil, m; where there is none the
                                // height of the grid's lower face
    std::vector<int> point;     // its place in the arrays, or `none`

    TopView(const BackgroundGrid<dim> &grid, const MaterialPoints<dim> &points);

    bool
    has_soil(const unsigned int i, const unsigned int k) const
    {
      return point[k * n_x + i] != none;
    }
  };
} // namespace Waker

#endif
