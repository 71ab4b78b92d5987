// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_loads_polygon_cells_h
#define waker_source_loads_polygon_cells_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Waker
{
  using namespace dealii;

  // Corners of a triangle cut by six planes: three and one for each.
  constexpr unsigned int most_corners = 9;

  struct Polygon
  {
    Point<3>     corners[most_corners];
    unsigned int n = 0;

    void
    add(const Point<3> &x)
    {
      Assert(n < most_corners, ExcInternalError());
      corners[n++] = x;
    }
  };


  // The part of a convex polygon with sign (x[d] - value) >= 0. New corners
  // lie on the plane exactly.
  inline void
  clip(const Polygon &from,
       const int      d,
       const double   value,
       const double   sign,
       Polygon       &to)
  {
    to.n = 0;
    for (unsigned int k = 0; k < from.n; ++k)
      {
        const Point<3> &a  = from.corners[k];
        const Point<3> &b  = from.corners[k + 1 < from.n ? k + 1 : 0];
        const double    fa = sign * (a[d] - value);
        const double    fb = sign * (b[d] - value);
        if (fa >= 0)
          to.add(a);
        if ((fa > 0 && fb < 0) || (fa < 0 && fb > 0))
          {
            Point<3> x = a + fa / (fa - fb) * (b - a);
            x[d]       = value;
            to.add(x);
          }
      }
  }


  // Cut a polygon (in cells) at the planes of the lattice normal to direction
  // d and to those after it, and call f(piece, cell) for every piece. A
  // polygon that lies in a plane belongs to one cell only.
  template <typename Function>
  void
  cut_into_cells(const Polygon      &polygon,
                 const int           d,
                 const int          *n_cells,
                 std::array<int, 3> &cell,
                 const Function     &f)
  {
    if (d == 3)
      {
        f(polygon, cell);
        return;
      }

    double lowest  = polygon.corners[0][d];
    double highest = lowest;
    for (unsigned int k = 1; k < polygon.n; ++k)
      {
        lowest  = std::min(lowest, polygon.corners[k][d]);
        highest = std::max(highest, polygon.corners[k][d]);
      }
    const auto inside = [&](const int i) {
      return std::min(std::max(i, 0), n_cells[d] - 1);
    };
    const int first = inside(std::floor(lowest));
    const int last =
      std::max(first, inside(static_cast<int>(std::ceil(highest)) - 1));
    if (first == last)
      {
        cell[d] = first;
        cut_into_cells(polygon, d + 1, n_cells, cell, f);
        return;
      }

    Polygon rest[2] = {polygon, {}};
    Polygon piece;
    int     now = 0;
    for (int i = first; i <= last; ++i, now = 1 - now)
      {
        cell[d] = i;
        if (i < last)
          {
            clip(rest[now], d, i + 1, -1., piece);
            clip(rest[now], d, i + 1, 1., rest[1 - now]);
          }
        else
          piece = rest[now];
        if (piece.n >= 3)
          cut_into_cells(piece, d + 1, n_cells, cell, f);
      }
  }
} // namespace Waker

#endif
