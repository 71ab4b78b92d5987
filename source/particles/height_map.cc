// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/particles/height_map.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace Waker
{
  namespace
  {
    using Corner = std::array<double, 2>;

    const char *const allowed =
      "a surface that a vertical line meets once, all over the layer; let it "
      "reach beyond the layer's edges";


    std::string
    place(const double x, const double z)
    {
      return "(x, z) = (" + in_digits(x) + ", " + in_digits(z) + ") m";
    }


    /// Twice the area of a triangle in plan, positive if anticlockwise in x, z.
    double
    turn(const Corner &a, const Corner &b, const Corner &c)
    {
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }


    /// The part of the segment a-b inside the rectangle: its middle; none if it
    /// only touches.
    std::optional<Corner>
    middle_inside(Corner a, Corner b, const Corner &lower, const Corner &upper)
    {
      for (unsigned int d = 0; d < 2; ++d)
        for (const double sign : {1., -1.})
          {
            // Keep g >= 0.
            const double edge = sign > 0. ? lower[d] : upper[d];
            const double g_a = sign * (a[d] - edge), g_b = sign * (b[d] - edge);
            if (g_a <= 0. && g_b <= 0.)
              return {};
            Corner &out = g_a < 0. ? a : b;
            if (g_a < 0. || g_b < 0.)
              {
                const double s = g_a / (g_a - g_b);
                out = {{a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])}};
              }
          }
      return Corner{{(a[0] + b[0]) / 2., (a[1] + b[1]) / 2.}};
    }


    Plane
    plane_through(const std::array<Corner, 3> &c,
                  const std::array<double, 3> &y,
                  const double                 twice_area)
    {
      Plane plane;
      plane.slope[0] = ((y[1] - y[0]) * (c[2][1] - c[0][1]) -
                        (y[2] - y[0]) * (c[1][1] - c[0][1])) /
                       twice_area;
      plane.slope[1] = ((y[2] - y[0]) * (c[1][0] - c[0][0]) -
                        (y[1] - y[0]) * (c[2][0] - c[0][0])) /
                       twice_area;
      plane.level = y[0] - plane.slope[0] * c[0][0] - plane.slope[1] * c[0][1];
      return plane;
    }
  } // namespace


  HeightMap::HeightMap(const std::vector<StlTriangle> &given,
                       const Corner                   &lower,
                       const Corner                   &upper,
                       const double                    round_off,
                       const std::string              &name,
                       const std::string              &path)
    : lower(lower)
    , upper(upper)
  {
    const auto refuse = [&](const std::string &what) {
      throw UserError(path, name + " " + what, allowed);
    };

    // Edges by their ends (x, z, y): how often each direction occurs. In plan
    // all triangles are anticlockwise, so each edge inside the surface occurs
    // once each way; twice the same way it is the edge of a fold.
    using Vertex = std::array<double, 3>;
    std::map<std::pair<Vertex, Vertex>, unsigned int> edges;
    const double least = 1e-12 * (upper[0] - lower[0]) * (upper[1] - lower[1]);
    for (const StlTriangle &corners : given)
      {
        std::array<Vertex, 3> v;
        for (unsigned int k = 0; k < 3; ++k)
          {
            v[k] = {{corners[k][0], corners[k][2], corners[k][1]}};
            for (unsigned int d = 0; d < 2; ++d)
              for (const double edge : {lower[d], upper[d]})
                if (std::abs(v[k][d] - edge) <= round_off)
                  v[k][d] = edge;
          }
        bool reaches = true;
        for (unsigned int d = 0; d < 2; ++d)
          reaches = reaches &&
                    std::max({v[0][d], v[1][d], v[2][d]}) > lower[d] &&
                    std::min({v[0][d], v[1][d], v[2][d]}) < upper[d];
        if (!reaches)
          continue;

        Triangle triangle;
        for (unsigned int k = 0; k < 3; ++k)
          triangle.corners[k] = {{v[k][0], v[k][1]}};
        auto        &c     = triangle.corners;
        const double twice = turn(c[0], c[1], c[2]);
        // The heights of a triangle without an area are no function of place.
        if (!(std::abs(twice) > least))
          refuse("stands upright at " + place(c[0][0], c[0][1]));
        if (twice < 0.)
          {
            std::swap(v[1], v[2]);
            std::swap(c[1], c[2]);
          }
        triangle.height =
          plane_through(c, {{v[0][2], v[1][2], v[2][2]}}, std::abs(twice));
        triangles.push_back(triangle);
        for (unsigned int k = 0; k < 3; ++k)
          if (++edges[{v[k], v[(k + 1) % 3]}] > 1)
            refuse("folds back at " +
                   place((v[k][0] + v[(k + 1) % 3][0]) / 2.,
                         (v[k][1] + v[(k + 1) % 3][1]) / 2.) +
                   ": it hangs over");
      }
    if (triangles.empty())
      refuse("does not reach over the layer");

    // How often the surface covers a place changes at edges that are not
    // shared: inside the rectangle there must be none.
    for (const auto &[ends, count] : edges)
      if (edges.find({ends.second, ends.first}) == edges.end())
        if (const auto middle =
              middle_inside({{ends.first[0], ends.first[1]}},
                            {{ends.second[0], ends.second[1]}},
                            lower,
                            upper))
          refuse("ends at " + place((*middle)[0], (*middle)[1]) +
                 ", inside the layer: it has a hole, or is too small");
    fill_bins();
    double     covered   = 0.;
    const Plan rectangle = {{{lower[0], lower[1]}},
                            {{upper[0], lower[1]}},
                            {{upper[0], upper[1]}},
                            {{lower[0], upper[1]}}};
    for_each_part(rectangle, [&](const Plan &part, const Plane &) {
      covered += area_of(part);
    });
    if (!(std::abs(covered / area_of(rectangle) - 1.) < 1e-9))
      refuse("covers " + in_digits(covered) +
             " m^2, counted with what lies "
             "over itself, of the " +
             in_digits(area_of(rectangle)) + " m^2 of the layer in plan");
  }


  void
  HeightMap::fill_bins()
  {
    // About one triangle in each, so that they are found in O(1).
    const double n     = std::sqrt(double(triangles.size()));
    const double ratio = (upper[0] - lower[0]) / (upper[1] - lower[1]);
    const double root  = std::sqrt(ratio);
    n_bins[0] = std::clamp(static_cast<int>(std::ceil(n * root)), 1, 10000);
    n_bins[1] = std::clamp(static_cast<int>(std::ceil(n / root)), 1, 10000);
    bins.assign(std::size_t(n_bins[0]) * n_bins[1], {});
    for (unsigned int t = 0; t < triangles.size(); ++t)
      {
        const auto        &c = triangles[t].corners;
        std::array<int, 2> first, last;
        for (unsigned int d = 0; d < 2; ++d)
          {
            first[d] = bin(d, std::min({c[0][d], c[1][d], c[2][d]}));
            last[d]  = bin(d, std::max({c[0][d], c[1][d], c[2][d]}));
          }
        for (int k = first[1]; k <= last[1]; ++k)
          for (int i = first[0]; i <= last[0]; ++i)
            bins[std::size_t(k) * n_bins[0] + i].push_back(t);
      }
  }


  int
  HeightMap::bin(const unsigned int d, const double x) const
  {
    const double share = (x - lower[d]) / (upper[d] - lower[d]);
    return std::clamp(static_cast<int>(std::clamp(share, 0., 1.) * n_bins[d]),
                      0,
                      n_bins[d] - 1);
  }


  void
  HeightMap::for_each_part(
    const Plan                                             &polygon,
    const std::function<void(const Plan &, const Plane &)> &f) const
  {
    if (polygon.empty())
      return;
    Corner low = polygon[0], high = polygon[0];
    for (const Corner &c : polygon)
      for (unsigned int d = 0; d < 2; ++d)
        {
          low[d]  = std::min(low[d], c[d]);
          high[d] = std::max(high[d], c[d]);
        }
    std::vector<unsigned int> candidates;
    for (int k = bin(1, low[1]); k <= bin(1, high[1]); ++k)
      for (int i = bin(0, low[0]); i <= bin(0, high[0]); ++i)
        {
          const auto &list = bins[std::size_t(k) * n_bins[0] + i];
          candidates.insert(candidates.end(), list.begin(), list.end());
        }
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()),
                     candidates.end());
    for (const unsigned int t : candidates)
      {
        const auto &c    = triangles[t].corners;
        Plan        part = polygon;
        for (unsigned int k = 0; k < 3 && !part.empty(); ++k)
          {
            // The left side of the edge a-b.
            const Corner &a = c[k], &b = c[(k + 1) % 3];
            Plane         left;
            left.slope = {{a[1] - b[1], b[0] - a[0]}};
            left.level = -(left.slope[0] * a[0] + left.slope[1] * a[1]);
            part       = clip(part, left);
          }
        if (!part.empty())
          f(part, triangles[t].height);
      }
  }


  std::optional<double>
  HeightMap::at(const double x, const double z) const
  {
    if (!(x >= lower[0] && x <= upper[0] && z >= lower[1] && z <= upper[1]))
      return {};
    // The one that it lies in, or is nearest to: round-off at an edge counts
    // for nothing.
    double nearest = -std::numeric_limits<double>::max(), height = 0.;
    for (const unsigned int t :
         bins[std::size_t(bin(1, z)) * n_bins[0] + bin(0, x)])
      {
        const auto  &c      = triangles[t].corners;
        const double twice  = turn(c[0], c[1], c[2]);
        double       inside = std::numeric_limits<double>::max();
        for (unsigned int k = 0; k < 3; ++k)
          inside =
            std::min(inside, turn(c[k], c[(k + 1) % 3], {{x, z}}) / twice);
        if (inside > nearest)
          {
            nearest = inside;
            height  = triangles[t].height.at(x, z);
          }
      }
    return height;
  }


  std::vector<double>
  HeightMap::crossings(const double z) const
  {
    std::vector<double> places;
    for (const Triangle &triangle : triangles)
      for (unsigned int k = 0; k < 3; ++k)
        {
          const auto &a = triangle.corners[k];
          const auto &b = triangle.corners[(k + 1) % 3];
          if (a[1] == z)
            places.push_back(a[0]);
          if ((a[1] < z) != (b[1] < z))
            places.push_back(a[0] +
                             (b[0] - a[0]) * ((z - a[1]) / (b[1] - a[1])));
        }
    return places;
  }


  std::array<double, 2>
  HeightMap::range() const
  {
    std::array<double, 2> heights = {{std::numeric_limits<double>::max(),
                                      -std::numeric_limits<double>::max()}};
    for_each_part({{{lower[0], lower[1]}},
                   {{upper[0], lower[1]}},
                   {{upper[0], upper[1]}},
                   {{lower[0], upper[1]}}},
                  [&](const Plan &part, const Plane &height) {
                    for (const Corner &c : part)
                      {
                        const double y = height.at(c[0], c[1]);
                        heights[0]     = std::min(heights[0], y);
                        heights[1]     = std::max(heights[1], y);
                      }
                  });
    return heights;
  }


  HeightMap
  HeightMap::scaled(const std::array<double, 3> &origin,
                    const double                 scale) const
  {
    HeightMap                         result;
    const std::array<unsigned int, 2> in_plan = {{0, 2}};
    for (unsigned int d = 0; d < 2; ++d)
      {
        result.lower[d] = (lower[d] - origin[in_plan[d]]) * scale;
        result.upper[d] = (upper[d] - origin[in_plan[d]]) * scale;
      }
    for (Triangle triangle : triangles)
      {
        Plane &height = triangle.height;
        height.level  = (height.at(origin[0], origin[2]) - origin[1]) * scale;
        for (Corner &c : triangle.corners)
          for (unsigned int d = 0; d < 2; ++d)
            c[d] = (c[d] - origin[in_plan[d]]) * scale;
        result.triangles.push_back(triangle);
      }
    result.fill_bins();
    return result;
  }
} // namespace Waker
