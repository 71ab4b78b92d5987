// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/ground_lines.h>
#include <waker/surface/marching_squares.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Waker
{
  namespace
  {
    /// A lattice of corners of squares, with marks on the sides between them:
    /// which sides belong to lines.
    class MarkedSides
    {
    public:
      MarkedSides(const unsigned int n_x, const unsigned int n_z)
        : n_x(n_x)
        , sides((n_x + 1) * (n_z + 1))
      {}

      /// The side from corner (i, k) to the next along x or z.
      void
      mark(const unsigned int i, const unsigned int k, const bool along_z)
      {
        sides[corner(i, k)][along_z ? 1 : 0] = true;
      }

      /// Join the sides to lines of corners. Each side is in one line; lines
      /// end where other than two sides meet.
      std::vector<std::vector<unsigned int>>
      join()
      {
        std::vector<std::vector<unsigned int>> lines;
        for (const bool loops : {false, true})
          for (unsigned int c = 0; c < sides.size(); ++c)
            while (n_marked(c) > 0 && (loops || !is_inner[c]))
              lines.push_back(follow(c));
        return lines;
      }

      /// To be called once all are marked.
      void
      find_ends()
      {
        is_inner.resize(sides.size());
        for (unsigned int c = 0; c < sides.size(); ++c)
          is_inner[c] = n_marked(c) == 2;
      }

    private:
      unsigned int
      corner(const unsigned int i, const unsigned int k) const
      {
        return k * (n_x + 1) + i;
      }

      /// The mark of the side that leads from a corner in one of four
      /// directions; null if the lattice ends there.
      char *
      side(const unsigned int c, const unsigned int direction)
      {
        const unsigned int row = n_x + 1;
        switch (direction)
          {
            case 0:
              return &sides[c][0];
            case 1:
              return &sides[c][1];
            case 2:
              return c % row > 0 ? &sides[c - 1][0] : nullptr;
            default:
              return c >= row ? &sides[c - row][1] : nullptr;
          }
      }

      unsigned int
      n_marked(const unsigned int c)
      {
        unsigned int n = 0;
        for (unsigned int direction = 0; direction < 4; ++direction)
          {
            const char *const mark = side(c, direction);
            n += mark != nullptr && *mark;
          }
        return n;
      }

      std::vector<unsigned int>
      follow(const unsigned int start)
      {
        const int row = static_cast<int>(n_x) + 1;

        std::vector<unsigned int> line = {start};
        do
          for (unsigned int direction = 0; direction < 4; ++direction)
            {
              char *const mark = side(line.back(), direction);
              if (mark == nullptr || !*mark)
                continue;
              *mark = false;
              line.push_back(line.back() +
                             std::array<int, 4>{{1, row, -1, -row}}[direction]);
              break;
            }
        while (is_inner[line.back()] && line.back() != start);
        return line;
      }

      unsigned int                     n_x;
      std::vector<std::array<char, 2>> sides; // of each corner, along x and z
      std::vector<char>                is_inner; // do two sides meet there?
    };


    /// Of the squares with soil whose middles are less than a side away in
    /// both directions: the height of the highest.
    double
    highest_around(const TopView<3> &view, const double x, const double z)
    {
      // The middles before and after, in squares from the first middle.
      const double x_at = (x - view.x) / view.side - 0.5;
      const double z_at = (z - view.z) / view.side - 0.5;
      const auto   from = [](const double at) {
        return static_cast<int>(std::floor(at + 1e-9));
      };
      const auto to = [](const double at) {
        return static_cast<int>(std::ceil(at - 1e-9));
      };
      double highest =
        *std::min_element(view.height.begin(), view.height.end());
      for (int k = std::max(from(z_at), 0);
           k <= std::min(to(z_at), static_cast<int>(view.n_z) - 1);
           ++k)
        for (int i = std::max(from(x_at), 0);
             i <= std::min(to(x_at), static_cast<int>(view.n_x) - 1);
             ++i)
          highest = std::max(highest, view.height[k * view.n_x + i]);
      return highest;
    }
  } // namespace


  std::vector<GroundPolyline>
  scarp_lines(const TopView<3> &view, const double step)
  {
    MarkedSides sides(view.n_x, view.n_z);
    const auto  is_drop = [&](const unsigned int i,
                             const unsigned int k,
                             const unsigned int i_next,
                             const unsigned int k_next) {
      return view.has_soil(i, k) && view.has_soil(i_next, k_next) &&
             std::abs(view.height[k * view.n_x + i] -
                      view.height[k_next * view.n_x + i_next]) > step;
    };
    for (unsigned int k = 0; k < view.n_z; ++k)
      for (unsigned int i = 0; i < view.n_x; ++i)
        {
          if (i + 1 < view.n_x && is_drop(i, k, i + 1, k))
            sides.mark(i + 1, k, true);
          if (k + 1 < view.n_z && is_drop(i, k, i, k + 1))
            sides.mark(i, k + 1, false);
        }
    sides.find_ends();

    std::vector<GroundPolyline> lines;
    for (const std::vector<unsigned int> &corners : sides.join())
      {
        lines.push_back({GroundLine::scarp, {}});
        for (const unsigned int corner : corners)
          {
            const double x = view.x + corner % (view.n_x + 1) * view.side;
            const double z = view.z + corner / (view.n_x + 1) * view.side;
            lines.back().vertices.emplace_back(x,
                                               highest_around(view, x, z),
                                               z);
          }
      }
    return lines;
  }


  std::vector<GroundPolyline>
  contour_lines(const TopView<3>          &view,
                const std::vector<double> &values,
                const double               threshold,
                const GroundLine           kind)
  {
    std::vector<GroundPolyline> lines;
    if (view.n_x < 2 || view.n_z < 2)
      return lines; // between middles there is nothing
    std::array<std::vector<double>, 2> middles;
    for (unsigned int i = 0; i < view.n_x; ++i)
      middles[0].push_back(view.x + (i + 0.5) * view.side);
    for (unsigned int k = 0; k < view.n_z; ++k)
      middles[1].push_back(view.z + (k + 0.5) * view.side);
    // Closed on all sides: what runs along the border is marked, and no line.
    Surface surface;
    MarchingSquares(middles, 15)
      .trace(values.data(), view.n_x, threshold, surface);
    for (const SurfaceChain &chain : surface.chains)
      {
        const std::size_t n       = chain.vertices.size();
        const auto        on_face = [&](const std::size_t k) {
          return chain.on_face[k % n] >= 0;
        };
        // Begin behind the border, if the chain comes to it.
        std::size_t first = 0;
        while (first < n && !on_face(first))
          ++first;
        first       = first == n ? 0 : first + 1;
        bool is_new = true;
        for (std::size_t k = first; k < first + n; ++k)
          {
            if (on_face(k))
              {
                is_new = true;
                continue;
              }
            const auto add = [&](const Point<2> &x) {
              lines.back().vertices.emplace_back(
                x[0], highest_around(view, x[0], x[1]), x[1]);
            };
            if (is_new)
              {
                lines.push_back({kind, {}});
                add(chain.vertices[k % n]);
              }
            add(chain.vertices[(k + 1) % n]);
            is_new = false;
          }
      }
    return lines;
  }


  template <int dim>
  double
  crest_height(const MaterialPoints<dim> &points)
  {
    double height = std::numeric_limits<double>::lowest();
    for (std::size_t p = 0; p < points.n_points(); ++p)
      height = std::max(height, points.position[p][1] + points.half_size[p][1]);
    return height;
  }


  std::vector<GroundPolyline>
  ground_lines(const TopView<3>        &view,
               const MaterialPoints<3> &points,
               const double             crest,
               const double             step)
  {
    // The contours' threshold must be positive: heights count from the base.
    const double base =
      *std::min_element(view.height.begin(), view.height.end()) - 2. * step;
    std::vector<double> above(view.height.size()), moved(view.height.size());
    for (std::size_t square = 0; square < above.size(); ++square)
      {
        const int p   = view.point[square];
        above[square] = view.height[square] - base;
        moved[square] =
          p == TopView<3>::none
            ? 0.
            : (points.position[p] - points.initial_position[p]).norm();
      }
    std::vector<GroundPolyline> lines;
    const auto take = [&](const std::vector<GroundPolyline> &more) {
      lines.insert(lines.end(), more.begin(), more.end());
    };
    take(contour_lines(view, above, crest - step - base, GroundLine::crest));
    take(scarp_lines(view, step));
    take(contour_lines(view, moved, step, GroundLine::moved));
    return lines;
  }


  template double
  crest_height(const MaterialPoints<2> &);
  template double
  crest_height(const MaterialPoints<3> &);
} // namespace Waker
