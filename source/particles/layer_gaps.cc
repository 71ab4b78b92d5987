// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/particles/layer_gaps.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Waker
{
  namespace
  {
    using Corner = std::array<double, 2>;

    /// Edges face each other if their normals are this close to opposite.
    constexpr double facing = -0.9;
    /// A lower face hangs above what it looks down on if its outward normal is
    /// this steep.
    constexpr double downwards = -0.9;


    double
    dot(const Corner &a, const Corner &b)
    {
      return a[0] * b[0] + a[1] * b[1];
    }


    Corner
    difference(const Corner &a, const Corner &b)
    {
      return {{a[0] - b[0], a[1] - b[1]}};
    }


    /// From an anticlockwise polygon.
    struct Edge
    {
      Corner begin, tangent, normal; // the normal points out
      double length;

      Edge(const Polygon &polygon, const std::size_t k)
        : begin(polygon[k])
      {
        const Corner d =
          difference(polygon[(k + 1) % polygon.size()], polygon[k]);
        length  = std::hypot(d[0], d[1]);
        tangent = {{d[0] / length, d[1] / length}};
        normal  = {{tangent[1], -tangent[0]}};
      }

      /// Point at `s` along and `n` out of the edge (m).
      Corner
      at(const double s, const double n) const
      {
        return {{begin[0] + s * tangent[0] + n * normal[0],
                 begin[1] + s * tangent[1] + n * normal[1]}};
      }
    };


    bool
    holds(const Polygon &polygon, const Corner &x)
    {
      bool inside = false;
      for (std::size_t k = 0; k < polygon.size(); ++k)
        {
          const Corner &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
          if ((a[1] <= x[1]) != (b[1] <= x[1]) &&
              x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
            inside = !inside;
        }
      return inside;
    }


    /// The part of edge a that edge b faces, and how far b is from its middle.
    struct Facing
    {
      double begin = 0., end = 0., distance = 0.; // m; end <= begin: none
    };


    Facing
    face(const Edge &a, const Edge &b)
    {
      Facing none;
      if (!(dot(a.normal, b.normal) < facing))
        return none;
      const Corner begin  = difference(b.begin, a.begin);
      const double s_end  = dot(begin, a.tangent);
      const double slope  = dot(b.tangent, a.tangent); // near -1
      const double s_from = s_end + slope * b.length;
      Facing       result;
      result.begin = std::max(0., s_from);
      result.end   = std::min(a.length, s_end);
      if (!(result.end - result.begin > 1e-6 * a.length))
        return none;
      const double s  = 0.5 * (result.begin + result.end);
      const double t  = (s - s_end) / slope;
      result.distance = dot(begin, a.normal) + t * dot(b.tangent, a.normal);
      return result;
    }


    bool
    has_map(const LayerParameters &layer)
    {
      return !layer.top.empty() || !layer.bottom.empty();
    }


    bool
    apart_along_z(const LayerParameters &a, const LayerParameters &b)
    {
      return a.extent.size() == 2 && b.extent.size() == 2 &&
             (a.extent[1] <= b.extent[0] || b.extent[1] <= a.extent[0]);
    }
  } // namespace


  std::vector<LayerGap>
  layer_gaps(const std::vector<LayerParameters> &layers, const double largest)
  {
    std::vector<Polygon> polygons;
    for (const LayerParameters &layer : layers)
      polygons.push_back(layer.corners());
    const auto is_air = [&](const Corner &x) {
      for (const Polygon &polygon : polygons)
        if (holds(polygon, x))
          return false;
      return true;
    };

    std::vector<LayerGap> gaps;
    for (std::size_t i = 0; i < layers.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        {
          if (apart_along_z(layers[i], layers[j]) || has_map(layers[i]) ||
              has_map(layers[j]))
            continue;
          LayerGap gap{layers[j].name, layers[i].name, 0., 0., {}};
          for (std::size_t k = 0; k < polygons[i].size(); ++k)
            for (std::size_t l = 0; l < polygons[j].size(); ++l)
              {
                const Edge   a(polygons[i], k), b(polygons[j], l);
                const Facing part = face(a, b);
                if (!(part.end > part.begin))
                  continue;
                const bool hangs =
                  a.normal[1] < downwards || b.normal[1] < downwards;
                const double limit =
                  hangs ? std::numeric_limits<double>::max() : largest;
                if (!(part.distance > 1e-6 * largest && part.distance <= limit))
                  continue;
                // Soil in between, of whatever layer, fills it. A point near
                // either side sees what lies against it.
                const double s     = 0.5 * (part.begin + part.end);
                bool         empty = true;
                for (const double share : {0.01, 0.5, 0.99})
                  empty = empty && is_air(a.at(s, share * part.distance));
                if (!empty)
                  continue;
                gap.length += part.end - part.begin;
                if (part.distance > gap.width)
                  {
                    gap.width  = part.distance;
                    gap.middle = a.at(s, 0.5 * part.distance);
                  }
              }
          if (gap.width > 0.)
            gaps.push_back(gap);
        }
    return gaps;
  }
} // namespace Waker
