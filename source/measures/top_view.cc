// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/top_view.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    // Half a square, but no domain that only touches a square reaches into it.
    constexpr double touch = 0.5 - 1e-6;

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

    // What reaches highest over the middles; where nothing does, into squares.
    std::vector<double> middle_height = height, square_height = height;
    std::vector<int>    over_middle = point, in_square = point;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      for (const bool whole : {false, true})
        {
          const Point<dim>     &centre = points.position[p];
          const Tensor<1, dim> &half   = points.half_size[p];
          const double          top    = centre[1] + half[1];
          // A square is reached into where a domain that is half a square
          // longer at both ends covers its middle.
          const auto squares = [&](const unsigned int d,
                                   const double       lower,
                                   const unsigned int n) {
            const double reach = half[d] + (whole ? touch * side : 0.);
            return middles_in((centre[d] - reach - lower) / side,
                              (centre[d] + reach - lower) / side,
                              n);
          };
          const Range columns = squares(0, x, n_x);
          const Range rows = dim == 3 ? squares(dim - 1, z, n_z) : Range{0, 1};
          std::vector<double> &heights = whole ? square_height : middle_height;
          std::vector<int>    &seen    = whole ? in_square : over_middle;
          for (int k = rows.begin; k < rows.end; ++k)
            for (int i = columns.begin; i < columns.end; ++i)
              {
                const unsigned int square = k * n_x + i;
                if (seen[square] == none || top > heights[square] ||
                    (top == heights[square] &&
                     points.id[p] < points.id[seen[square]]))
                  {
                    seen[square]    = static_cast<int>(p);
                    heights[square] = top;
                  }
              }
        }
    for (std::size_t square = 0; square < point.size(); ++square)
      {
        const bool is_covered = over_middle[square] != none;
        point[square] = is_covered ? over_middle[square] : in_square[square];
        height[square] =
          is_covered ? middle_height[square] : square_height[square];
      }
  }


  template struct TopView<2>;
  template struct TopView<3>;
} // namespace Waker
