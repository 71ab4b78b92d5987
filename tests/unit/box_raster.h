// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_box_raster_h
#define waker_tests_box_raster_h

#include <waker/surface/boxes/box_union.h>
#include <waker/surface/shape/surface.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

/// Rectangles on the raster of their own coordinates, slab by slab as eqs.
/// 3.12-3.14 of Remmerswaal 2023 say it: what the fast search is tested
/// against.
class BoxRaster
{
public:
  using Box = Waker::Box<2>;

  BoxRaster(std::vector<Box> boxes, const Waker::BoxUnionRules<2> &rules)
  {
    add_bodies_beyond_closed_faces(boxes, rules);
    for (const Box &box : boxes)
      {
        x.insert(x.end(),
                 {box.lower[0],
                  box.upper[0],
                  box.lower[0] - rules.minimum_gap[0]});
        y.insert(y.end(), {box.lower[1], box.upper[1]});
      }
    for (auto *c : {&x, &y})
      {
        std::sort(c->begin(), c->end());
        c->erase(std::unique(c->begin(), c->end()), c->end());
      }

    std::vector<unsigned char> slab_before(n_y());
    for (std::size_t i = 0; i < n_x(); ++i)
      {
        // Numbers of rectangles and of left extensions, from edges met on the
        // way up.
        std::vector<int> J_edges(n_y() + 1), K_edges(n_y() + 1);
        for (const Box &box : boxes)
          for (const bool extension : {false, true})
            {
              const double from =
                extension ? box.lower[0] - rules.minimum_gap[0] : box.lower[0];
              const double to = extension ? box.lower[0] : box.upper[0];
              if (from <= x[i] && x[i + 1] <= to)
                {
                  auto &edges = extension ? K_edges : J_edges;
                  ++edges[rank(y, box.lower[1])];
                  --edges[rank(y, box.upper[1])];
                }
            }
        std::vector<unsigned char> I(n_y());
        int                        J = 0, K = 0;
        for (std::size_t k = 0; k < n_y(); ++k)
          {
            J += J_edges[k];
            K += K_edges[k];
            I[k] = J > 0 || (K > 0 && slab_before[k]);
          }
        std::vector<unsigned char> filled = I;
        for (std::size_t k = 0; k < n_y();)
          {
            std::size_t end = k;
            while (end < n_y() && I[end] == I[k])
              ++end;
            if (I[k] == 0 && k > 0 && end < n_y() &&
                y[end] - y[k] <= rules.minimum_gap[1])
              std::fill(filled.begin() + k, filled.begin() + end, 1);
            k = end;
          }
        slab_before = rules.symmetric ? I : filled;
        inside.push_back(filled);
      }

    for (std::size_t i = 0; i < n_x(); ++i)
      for (std::size_t k = 0; k < n_y(); ++k)
        if ((rules.is_closed(0) && x[i] < rules.lower[0]) ||
            (rules.is_closed(1) && x[i] >= rules.upper[0]) ||
            (rules.is_closed(2) && y[k] < rules.lower[1]) ||
            (rules.is_closed(3) && y[k] >= rules.upper[1]))
          inside[i][k] = 0;
  }

  std::size_t
  n_x() const
  {
    return x.size() - 1;
  }

  std::size_t
  n_y() const
  {
    return y.size() - 1;
  }

  /// Is raster cell (i, j) inside? Also asked beyond the raster.
  bool
  at(const int i, const int j) const
  {
    return i >= 0 && j >= 0 && i < int(n_x()) && j < int(n_y()) && inside[i][j];
  }

  /// The inside as rectangles, as high as they come in each slab.
  std::vector<Box>
  rectangles() const
  {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < n_x(); ++i)
      for (std::size_t j = 0; j < n_y(); ++j)
        if (inside[i][j])
          {
            Box box;
            box.lower = dealii::Point<2>(x[i], y[j]);
            while (j + 1 < n_y() && inside[i][j + 1])
              ++j;
            box.upper = dealii::Point<2>(x[i + 1], y[j + 1]);
            boxes.push_back(box);
          }
    return boxes;
  }

  double
  area() const
  {
    double sum = 0.;
    for (std::size_t i = 0; i < n_x(); ++i)
      for (std::size_t j = 0; j < n_y(); ++j)
        if (inside[i][j])
          sum += (x[i + 1] - x[i]) * (y[j + 1] - y[j]);
    return sum;
  }

  /// Net direction of the contour on the edges of the raster's cells, the body
  /// on the left: {horizontal?, i, j} -> +-1.
  using Edges = std::map<std::array<int, 3>, int>;

  Edges
  contour() const
  {
    Edges edges;
    for (int i = 0; i <= int(n_x()); ++i)
      for (int j = 0; j <= int(n_y()); ++j)
        {
          if (at(i - 1, j) != at(i, j))
            edges[{{0, i, j}}] = at(i - 1, j) ? 1 : -1;
          if (at(i, j - 1) != at(i, j))
            edges[{{1, i, j}}] = at(i, j) ? 1 : -1;
        }
    return edges;
  }

  /// The edges of chains in the same form. Edges that are passed twice count
  /// 2, a vertex off the raster gives an edge that contour() has not.
  Edges
  edges_of(const Waker::Surface &surface) const
  {
    Edges edges;
    for (const Waker::SurfaceChain &chain : surface.chains)
      for (std::size_t k = 0; k < chain.vertices.size(); ++k)
        {
          const auto &a = chain.vertices[k];
          const auto &b = chain.vertices[(k + 1) % chain.vertices.size()];
          const bool  horizontal = a[1] == b[1];
          const auto &c          = horizontal ? x : y;
          const int   fixed      = horizontal ? rank(y, a[1]) : rank(x, a[0]);
          const int   from       = rank(c, horizontal ? a[0] : a[1]);
          const int   to         = rank(c, horizontal ? b[0] : b[1]);
          for (int r = std::min(from, to); r < std::max(from, to); ++r)
            edges[horizontal ? std::array<int, 3>{{1, r, fixed}}
                             : std::array<int, 3>{{0, fixed, r}}] +=
              to > from ? 1 : -1;
        }
    return edges;
  }

  /// Number of parts of the inside that hang together by edges, or of the
  /// outside that hang together by edges or corners, the outermost included.
  unsigned int
  n_parts(const bool of_inside) const
  {
    // A frame of outside cells all round.
    const int                  nx = n_x() + 2, ny = n_y() + 2;
    std::vector<unsigned char> visited(nx * ny);
    unsigned int               n = 0;
    for (int start = 0; start < nx * ny; ++start)
      {
        if (visited[start] || at(start % nx - 1, start / nx - 1) != of_inside)
          continue;
        ++n;
        std::vector<int> stack = {start};
        visited[start]         = 1;
        while (!stack.empty())
          {
            const int c = stack.back();
            stack.pop_back();
            for (int di = -1; di <= 1; ++di)
              for (int dj = -1; dj <= 1; ++dj)
                {
                  if (of_inside && di != 0 && dj != 0)
                    continue;
                  const int i = c % nx + di, j = c / nx + dj;
                  if (i < 0 || j < 0 || i >= nx || j >= ny ||
                      visited[j * nx + i] || at(i - 1, j - 1) != of_inside)
                    continue;
                  visited[j * nx + i] = 1;
                  stack.push_back(j * nx + i);
                }
          }
      }
    return n;
  }

  std::vector<double>                     x;
  std::vector<double>                     y;
  std::vector<std::vector<unsigned char>> inside; // [slab][segment]

private:
  // What lies beyond closed faces counts as body until the contour is drawn.
  static void
  add_bodies_beyond_closed_faces(std::vector<Box>              &boxes,
                                 const Waker::BoxUnionRules<2> &rules)
  {
    const double far = 100.;
    for (unsigned int face = 0; face < 4; ++face)
      if (rules.is_closed(face))
        {
          Box box;
          for (unsigned int d = 0; d < 2; ++d)
            {
              box.lower[d] = -far;
              box.upper[d] = far;
            }
          if (face % 2 == 0)
            box.upper[face / 2] = rules.lower[face / 2];
          else
            box.lower[face / 2] = rules.upper[face / 2];
          boxes.push_back(box);
        }
  }

  static int
  rank(const std::vector<double> &values, const double value)
  {
    return std::lower_bound(values.begin(), values.end(), value) -
           values.begin();
  }
};

#endif
