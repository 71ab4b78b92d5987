// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_rectangles_h
#define waker_tests_rectangles_h

#include <waker/surface/shape/facet.h>

namespace Waker
{
  /// Two triangles; the body is behind them, seen anticlockwise.
  inline void
  add_rectangle(Facets<3>      &facets,
                const Point<3> &a,
                const Point<3> &b,
                const Point<3> &c,
                const int       on_face = -1)
  {
    const Point<3> d = a + (c - b);
    facets.push_back(make_facet<3>({{a, b, c}}, on_face));
    facets.push_back(make_facet<3>({{a, c, d}}, on_face));
  }
} // namespace Waker

#endif
