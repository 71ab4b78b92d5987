// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/grid/box_face.h>
#include <waker/loads/wetted_segments.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    // The first chain of a section: segment k runs from vertex k to k + 1.
    class Chain
    {
    public:
      explicit Chain(const Facets<2> &section)
        : segments(section)
        , n(std::find_if(section.begin(),
                         section.end(),
                         [&](const Facet<2> &segment) {
                           return segment.chain != section.front().chain;
                         }) -
            section.begin())
      {}

      std::size_t
      size() const
      {
        return n;
      }

      const Point<2> &
      vertex(const std::size_t k) const
      {
        return segments[k].vertices[0];
      }

      int
      on_face(const std::size_t k) const
      {
        return segments[k].on_face;
      }

    private:
      const Facets<2>  &segments;
      const std::size_t n;
    };


    // Where the walk along the surface starts: a vertex of the chain.
    struct Toe
    {
      std::size_t vertex;
      bool        floats;
    };


    Toe
    find_toe(const Chain &chain,
             const bool   water_left,
             const double bottom_height,
             const double cell_size)
    {
      constexpr int     bottom = static_cast<int>(BoxFace::bottom);
      const std::size_t n      = chain.size();

      // The bottom runs from left to right, the body above it.
      std::size_t toe   = n;
      const auto  outer = [&](const std::size_t a, const std::size_t b) {
        return water_left ? chain.vertex(a)[0] < chain.vertex(b)[0]
                           : chain.vertex(a)[0] > chain.vertex(b)[0];
      };
      for (std::size_t k = 0; k < n; ++k)
        if (chain.on_face(k) == bottom)
          {
            const std::size_t end = water_left ? k : (k + 1) % n;
            if (toe == n || outer(end, toe))
              toe = end;
          }
      if (toe < n)
        return {toe, false};

      // The lowest vertex; the detected line of a flat underside scatters.
      double lowest = chain.vertex(0)[1];
      for (std::size_t k = 0; k < n; ++k)
        lowest = std::min(lowest, chain.vertex(k)[1]);
      const double tolerance = 0.25 * cell_size;
      for (std::size_t k = 0; k < n; ++k)
        if (chain.vertex(k)[1] <= lowest + tolerance &&
            (toe == n || outer(k, toe)))
          toe = k;
      return {toe, lowest > bottom_height + cell_size};
    }


    // Walk from vertex `start` until the surface reaches the level or a closed
    // face other than `wall`, and collect what is wet.
    // @return true if the walk came back to its start
    bool
    walk(const Chain      &chain,
         const std::size_t start,
         const bool        backwards,
         const int         wall,
         const double      level,
         const double      tolerance,
         Facets<2>        &wetted)
    {
      const std::size_t n    = chain.size();
      const auto        next = [=](const std::size_t k) {
        return backwards ? (k + n - 1) % n : (k + 1) % n;
      };
      const auto face = [&](const std::size_t k) {
        return chain.on_face(backwards ? next(k) : k);
      };

      std::size_t k        = start;
      std::size_t n_walked = 0;
      while (wall >= 0 && face(k) == wall && n_walked++ < n)
        k = next(k);

      for (; n_walked < n; ++n_walked, k = next(k))
        {
          const Point<2> &from = chain.vertex(k);
          Point<2>        to   = chain.vertex(next(k));
          if (from[1] > level || (face(k) >= 0 && face(k) != wall))
            return false;

          const bool rises_above = to[1] > level;
          if (rises_above)
            {
              const double t = (level - from[1]) / (to[1] - from[1]);
              to             = from + t * (to - from);
              to[1]          = level;
            }

          const Tensor<1, 2> along  = to - from;
          const double       length = along.norm();
          if (length > tolerance && face(k) < 0)
            {
              // Backwards, the body is on the right.
              const double side = backwards ? 1. : -1.;
              Tensor<1, 2> normal;
              normal[0] = -side * along[1] / length;
              normal[1] = side * along[0] / length;
              Facet<2> wet;
              wet.vertices = {{from, to}};
              wet.normal   = normal;
              wetted.push_back(wet);
            }
          // A crest at the level keeps the water out, whatever round-off says.
          if (to[1] >= level - tolerance)
            return false;
        }
      return true;
    }
  } // namespace


  void
  find_wetted_segments(const Facets<2> &section,
                       const bool       water_left,
                       const double     level,
                       const double     bottom,
                       const double     cell_size,
                       Facets<2>       &wetted)
  {
    wetted.clear();
    if (section.empty())
      return;

    // With the water on the left, up the outer slope is against the chain.
    const Chain  chain(section);
    const double tolerance = 1e-9 * cell_size;
    const Toe    toe       = find_toe(chain, water_left, bottom, cell_size);
    const int    wall =
      static_cast<int>(water_left ? BoxFace::left : BoxFace::right);
    const bool is_round =
      walk(chain, toe.vertex, water_left, wall, level, tolerance, wetted);

    // A body that floats is wet on the other side too.
    if (toe.floats && !is_round)
      walk(chain, toe.vertex, !water_left, -1, level, tolerance, wetted);
  }
} // namespace Waker
