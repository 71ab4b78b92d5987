// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/particles/polygon.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    using Corner = std::array<double, 2>;

    const char *const allowed_polygon =
      "a polygon \"x1, y1; x2, y2; x3, y3; ...\" in m whose edges neither "
      "cross nor touch";

    /// Each edge is compared with all others.
    constexpr std::size_t most_corners = 10000;

    /// Twice the area of the triangle a, b, c: positive if c lies left of ab.
    double
    turn(const Corner &a, const Corner &b, const Corner &c)
    {
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    /// The sign of turn(), 0 if c is nearer than round-off to the line ab.
    int
    side(const Corner &a, const Corner &b, const Corner &c)
    {
      const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
      const double scale =
        std::max({length, std::hypot(c[0] - a[0], c[1] - a[1])});
      const double t = turn(a, b, c);
      return std::abs(t) <= 1e-12 * length * scale ? 0 : (t > 0. ? 1 : -1);
    }

    bool
    in_box(const Corner &a, const Corner &b, const Corner &c)
    {
      return std::min(a[0], b[0]) <= c[0] && c[0] <= std::max(a[0], b[0]) &&
             std::min(a[1], b[1]) <= c[1] && c[1] <= std::max(a[1], b[1]);
    }

    /// Do the segments ab and cd have a point in common?
    bool
    segments_meet(const Corner &a,
                  const Corner &b,
                  const Corner &c,
                  const Corner &d)
    {
      if (std::max(a[0], b[0]) < std::min(c[0], d[0]) ||
          std::max(c[0], d[0]) < std::min(a[0], b[0]) ||
          std::max(a[1], b[1]) < std::min(c[1], d[1]) ||
          std::max(c[1], d[1]) < std::min(a[1], b[1]))
        return false;
      const int c_side = side(a, b, c), d_side = side(a, b, d);
      const int a_side = side(c, d, a), b_side = side(c, d, b);
      if (c_side * d_side < 0 && a_side * b_side < 0)
        return true;
      return (c_side == 0 && in_box(a, b, c)) ||
             (d_side == 0 && in_box(a, b, d)) ||
             (a_side == 0 && in_box(c, d, a)) ||
             (b_side == 0 && in_box(c, d, b));
    }

    std::string
    edge_name(const Polygon &polygon, const std::size_t k)
    {
      const auto point = [](const Corner &p) {
        return "(" + in_digits(p[0]) + ", " + in_digits(p[1]) + ")";
      };
      return point(polygon[k]) + "-" + point(polygon[(k + 1) % polygon.size()]);
    }

    void
    check_simple(const Polygon &p, const std::string &where)
    {
      const std::size_t n = p.size();
      for (std::size_t i = 0; i < n; ++i)
        {
          // Neighbouring edges meet in a corner: they must not fold back.
          const Corner &a = p[i], &b = p[(i + 1) % n], &c = p[(i + 2) % n];
          if (side(a, b, c) == 0 &&
              (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]) <
                0.)
            throw UserError(where,
                            "the edges " + edge_name(p, i) + " and " +
                              edge_name(p, (i + 1) % n) + " lie on each other",
                            allowed_polygon);
          for (std::size_t j = i + 2; j < n; ++j)
            if (!(i == 0 && j == n - 1) &&
                segments_meet(a, b, p[j], p[(j + 1) % n]))
              throw UserError(where,
                              "the edges " + edge_name(p, i) + " and " +
                                edge_name(p, j) + " cross or touch",
                              allowed_polygon);
        }
    }

    /// The part of an anticlockwise triangle that lies in another one.
    Polygon
    clip(const Polygon &triangle, const Polygon &window)
    {
      Polygon rest = triangle;
      for (unsigned int k = 0; k < 3 && !rest.empty(); ++k)
        {
          const Corner &a = window[k], &b = window[(k + 1) % 3];
          Polygon       kept;
          for (std::size_t i = 0; i < rest.size(); ++i)
            {
              const Corner &p = rest[i], &q = rest[(i + 1) % rest.size()];
              const double  t_p = turn(a, b, p), t_q = turn(a, b, q);
              if (t_p >= 0.)
                kept.push_back(p);
              if ((t_p > 0. && t_q < 0.) || (t_p < 0. && t_q > 0.))
                {
                  const double s = t_p / (t_p - t_q);
                  kept.push_back(
                    {{p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])}});
                }
            }
          rest = kept;
        }
      return rest;
    }
  } // namespace


  double
  signed_area(const Polygon &polygon)
  {
    double twice_area = 0.;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      twice_area += turn(polygon[0], polygon[i], polygon[i + 1]);
    return twice_area / 2.;
  }


  Polygon
  parse_polygon(const std::string &text, const std::string &where)
  {
    Polygon                  polygon;
    std::vector<std::string> items = split(text, ';');
    if (!items.empty() && items.back().empty())
      items.pop_back(); // a semicolon at the end
    if (items.size() > most_corners)
      throw UserError(where,
                      "has " + std::to_string(items.size()) + " corners",
                      "at most " + std::to_string(most_corners));
    for (const std::string &item : items)
      {
        const std::vector<std::string> numbers = split(item, ',');
        Corner                         corner;
        if (numbers.size() != 2 || !read_number(numbers[0], corner[0]) ||
            !read_number(numbers[1], corner[1]))
          throw UserError(where,
                          "corner " + std::to_string(polygon.size() + 1) +
                            " is " + in_quotes(item) + ", not two numbers",
                          std::string(allowed_polygon) + decimals_with_a_point);
        polygon.push_back(corner);
      }
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    while (polygon.size() > 1 && polygon.front() == polygon.back())
      polygon.pop_back();
    if (polygon.size() < 3)
      throw UserError(where,
                      in_quotes(text) + " has " +
                        std::to_string(polygon.size()) + " corners",
                      "3 corners or more");

    double size = 0.;
    for (const Corner &p : polygon)
      size =
        std::max(size, std::hypot(p[0] - polygon[0][0], p[1] - polygon[0][1]));
    // Before the area: that of a figure of eight may be zero.
    if (std::any_of(polygon.begin(), polygon.end(), [&](const Corner &p) {
          return std::abs(turn(polygon[0], polygon[1], p)) >
                 1e-12 * size * size;
        }))
      check_simple(polygon, where);
    const double area = signed_area(polygon);
    if (!(std::abs(area) > 1e-12 * size * size))
      throw UserError(where,
                      "the corners " + in_quotes(text) + " enclose no area",
                      "a polygon with an area");
    if (area < 0.)
      std::reverse(polygon.begin(), polygon.end());
    return polygon;
  }


  double
  common_area(const Polygon &a, const Polygon &b)
  {
    // A polygon is the sum of the signed triangles from its first corner.
    // Unlike an overlay this has no special cases for edges in common.
    const auto triangle = [](const Polygon &p, const std::size_t i) {
      return Polygon{p[0], p[i], p[i + 1]};
    };
    double sum = 0.;
    for (std::size_t i = 1; i + 1 < a.size(); ++i)
      for (std::size_t j = 1; j + 1 < b.size(); ++j)
        {
          Polygon one = triangle(a, i), other = triangle(b, j);
          double  sign = 1.;
          for (Polygon *t : {&one, &other})
            if (signed_area(*t) < 0.)
              {
                std::swap((*t)[1], (*t)[2]);
                sign = -sign;
              }
          sum += sign * signed_area(clip(one, other));
        }
    return sum;
  }
} // namespace Waker
