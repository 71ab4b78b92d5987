// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/dyke_geometry.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Waker
{
  DykeGeometry
  measure_dyke(const Facets<2> &section, const double level)
  {
    DykeGeometry dyke;
    dyke.level = level;
    if (!std::isnan(level))
      dyke.width = 0.;

    // Crossings of the level: (x, winding). Half-open: a vertex on the level
    // counts as below it, so that a chain crosses as often up as down.
    std::vector<std::pair<double, int>> crossings;
    for (const Facet<2> &segment : section)
      {
        const Point<2> &a = segment.vertices[0];
        const Point<2> &b = segment.vertices[1];
        dyke.height       = std::max(dyke.height, a[1]);
        if ((a[1] > level) == (b[1] > level))
          continue;

        // The body is on the left: on its left side the chain runs down.
        const double t = (level - a[1]) / (b[1] - a[1]);
        crossings.emplace_back(a[0] + t * (b[0] - a[0]), a[1] > level ? 1 : -1);
      }

    // From left to right; where parts touch, the next is entered before the
    // last is left.
    std::sort(crossings.begin(),
              crossings.end(),
              [](const auto &a, const auto &b) {
                return a.first < b.first ||
                       (a.first == b.first && a.second > b.second);
              });
    int    winding = 0;
    double start   = 0.;
    for (const auto &[x, change] : crossings)
      {
        if (winding == 0 && change > 0)
          start = x;
        winding += change;
        if (winding == 0 && change < 0 && x > start)
          {
            dyke.parts.push_back({{start, x}});
            dyke.width += x - start;
          }
      }
    return dyke;
  }
} // namespace Waker
