// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/grid/background_grid.h>
#include <waker/measures/dyke_geometry.h>
#include <waker/particles/material_points.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Waker
{
  namespace
  {
    /// A section of a body, from the segments of its outline, in any order.
    class Section
    {
    public:
      explicit Section(const double level)
        : level(level)
      {}

      /// The body is on the left of the segment from a to b.
      void
      add(const Point<2> &a, const Point<2> &b)
      {
        height = std::max({height, a[1], b[1]});
        // Half-open: a vertex on the level counts as below it, so that a chain
        // crosses as often up as down.
        if ((a[1] > level) == (b[1] > level))
          return;
        // The body is on the left: on its left side the chain runs down.
        const double t = (level - a[1]) / (b[1] - a[1]);
        crossings.emplace_back(a[0] + t * (b[0] - a[0]), a[1] > level ? 1 : -1);
      }

      DykeGeometry
      geometry()
      {
        DykeGeometry dyke;
        dyke.height = height;
        dyke.level  = level;
        if (!std::isnan(level))
          dyke.width = 0.;
        // From left to right; where parts touch, the next is entered before
        // the last is left.
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

    private:
      double level;
      double height = -std::numeric_limits<double>::infinity();
      std::vector<std::pair<double, int>> crossings; // x, winding
    };


    /// Where an edge crosses z; the same bits from both facets that share it.
    Point<2>
    crossing(const Point<3> &a, const Point<3> &b, const double z)
    {
      const Point<3> &low  = a[2] < b[2] ? a : b;
      const Point<3> &high = a[2] < b[2] ? b : a;
      const double    t    = (z - low[2]) / (high[2] - low[2]);
      return Point<2>(low[0] + t * (high[0] - low[0]),
                      low[1] + t * (high[1] - low[1]));
    }


    /// The segment that a facet has at z, if it has one: half-open, as above.
    void
    cut(const Facet<3> &facet, const double z, Section &section)
    {
      Point<2>     ends[2];
      unsigned int n = 0;
      for (unsigned int i = 0; i < 3; ++i)
        {
          const Point<3> &a = facet.vertices[i];
          const Point<3> &b = facet.vertices[(i + 1) % 3];
          if ((a[2] > z) != (b[2] > z))
            {
              // Seen from larger z the body is on the left of the way from
              // where the facet's border goes down through z to where it comes
              // up.
              ends[a[2] > z ? 0 : 1] = crossing(a, b, z);
              ++n;
            }
        }
      if (n == 2)
        section.add(ends[0], ends[1]);
    }
  } // namespace


  DykeGeometry
  measure_dyke(const Facets<2> &outline, const double level)
  {
    Section section(level);
    for (const Facet<2> &segment : outline)
      section.add(segment.vertices[0], segment.vertices[1]);
    return section.geometry();
  }


  std::vector<double>
  dyke_sections(const BackgroundGrid<3> &grid, const MaterialPoints<3> &points)
  {
    double first = std::numeric_limits<double>::max(), last = -first;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const double z    = points.initial_position[p][2];
        const double half = points.half_size[p][2];
        first             = std::min(first, z - half);
        last              = std::max(last, z + half);
      }
    std::vector<double> sections;
    const double        h = grid.cell_size();
    const auto          n =
      std::lround((grid.upper_corner()[2] - grid.lower_corner()[2]) / h);
    for (long int k = 0; k < n; ++k)
      {
        const double z = grid.lower_corner()[2] + (k + 0.5) * h;
        if (z > first && z < last)
          sections.push_back(z);
      }
    return sections;
  }


  DykeGeometry
  measure_dyke(const Facets<3>           &facets,
               const std::vector<double> &sections,
               const double               level)
  {
    std::vector<Section> all(sections.size(), Section(level));
    for (const Facet<3> &facet : facets)
      {
        double low = std::numeric_limits<double>::max(), high = -low;
        for (const Point<3> &x : facet.vertices)
          {
            low  = std::min(low, x[2]);
            high = std::max(high, x[2]);
          }
        for (auto z = std::lower_bound(sections.begin(), sections.end(), low);
             z != sections.end() && *z < high;
             ++z)
          cut(facet, *z, all[z - sections.begin()]);
      }

    DykeGeometry dyke;
    dyke.level = level;
    for (std::size_t s = 0; s < sections.size(); ++s)
      {
        DykeGeometry section = all[s].geometry();
        if (s == 0 || section.height < dyke.height)
          {
            dyke.height   = section.height;
            dyke.height_z = sections[s];
          }
        if (!std::isnan(level) && (s == 0 || section.width < dyke.width))
          {
            dyke.width   = section.width;
            dyke.width_z = sections[s];
            dyke.parts   = std::move(section.parts);
          }
      }
    return dyke;
  }
} // namespace Waker
