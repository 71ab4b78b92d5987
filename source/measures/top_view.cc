// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/top_view.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    struct Range
    {
      int begin, end;
    };

    /// The squares, of n, whose middle lies in [from, to), counted in squares.
    Range
    middles_in(const double from, const double to, const unsigned int n)
    {
      const double last = static_cast<double>(n);
      return {static_cast<int>(std::clamp(std::ceil(from - 0.5), 0., last)),
              static_cast<int>(std::clamp(std::ceil(to - 0.5), 0., last))};
    }
  } // namespace


  template <int dim>
  TopView<dim>::TopView(const BackgroundGrid<dim> &grid,
                        const MaterialPoints<dim> &points)
    : side(0.5 * grid.cell_size())
    , x(grid.lower_corner()[0])
    , z(dim == 3 ? grid.lower_corner()[dim - 1] : 0.)
  {
    const auto n_squares = [&](const unsigned int d) {
      return static_cast<unsigned int>(
        std::lround((grid.upper_corner()[d] - grid.lower_corner()[d]) / side));
    };
    n_x = n_squares(0);
    n_z = dim == 3 ? n_squares(dim - 1) : 1;
    height.assign(n_x * n_z, grid.lower_corner()[1]);
    point.assign(n_x * n_z, none);

    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const Point<dim>     &centre = points.position[p];
        const Tensor<1, dim> &half   = points.half_size[p];
        const double          top    = centre[1] + half[1];

        const Range columns = middles_in((centre[0] - half[0] - x) / side,
                                         (centre[0] + half[0] - x) / side,
                                         n_x);
        const Range rows =
          dim == 3 ? middles_in((centre[dim - 1] - half[dim - 1] - z) / side,
                                (centre[dim - 1] + half[dim - 1] - z) / side,
                                n_z)
                   : Range{0, 1};
        for (int k = rows.begin; k < rows.end; ++k)
          for (int i = columns.begin; i < columns.end; ++i)
            {
              const unsigned int square = k * n_x + i;
              int               &seen   = point[square];
              if (seen == none || top > height[square] ||
                  (top == height[square] && points.id[p] < points.id[seen]))
                {
                  seen           = static_cast<int>(p);
                  height[square] = top;
                }
            }
      }
  }


  template struct TopView<2>;
  template struct TopView<3>;
} // namespace Waker
