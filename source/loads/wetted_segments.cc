// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/loads/wetted_surface.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    // Where the walk along the surface starts: a vertex of the chain.
    struct Toe
    {
      std::size_t vertex;
      bool        floats;
    };


    Toe
    find_toe(const SurfaceChain &chain,
             const bool          water_left,
             const double        bottom_height,
             const double        cell_size)
    {
      constexpr int     bottom = 2;
      const std::size_t n      = chain.vertices.size();

      // The bottom runs from left to right, the body above it.
      std::size_t toe   = n;
      const auto  outer = [&](const std::size_t a, const std::size_t b) {
        return water_left ? chain.vertices[a][0] < chain.vertices[b][0]
                           : chain.vertices[a][0] > chain.vertices[b][0];
      };
      for (std::size_t k = 0; k < n; ++k)
        if (chain.on_face[k] == bottom)
          {
            const std::size_t end = water_left ? k : (k + 1) % n;
            if (toe == n || outer(end, toe))
              toe = end;
          }
      if (toe < n)
        return {toe, false};

      // The lowest vertex; the detected line of a flat underside scatters.
      double lowest = chain.vertices[0][1];
      for (const Point<2> &x : chain.vertices)
        lowest = std::min(lowest, x[1]);
      const double tolerance = 0.25 * cell_size;
      for (std::size_t k = 0; k < n; ++k)
        if (chain.vertices[k][1] <= lowest + tolerance &&
            (toe == n || outer(k, toe)))
          toe = k;
      return {toe, lowest > bottom_height + cell_size};
    }


    // Walk from vertex `start` until the surface reaches the level or a closed
    // face other than `wall`, and collect what is wet.
    // @return true if the walk came back to its start
    bool
    walk(const SurfaceChain         &chain,
         const std::size_t           start,
         const bool                  backwards,
         const int                   wall,
         const double                level,
         const double                tolerance,
         std::vector<LoadedSegment> &wetted)
    {
      const std::size_t n    = chain.vertices.size();
      const auto        next = [=](const std::size_t k) {
        return backwards ? (k + n - 1) % n : (k + 1) % n;
      };
      const auto face = [&](const std::size_t k) {
        return chain.on_face[backwards ? next(k) : k];
      };

      std::size_t k        = start;
      std::size_t n_walked = 0;
      while (wall >= 0 && face(k) == wall && n_walked++ < n)
        k = next(k);

      for (; n_walked < n; ++n_walked, k = next(k))
        {
          const Point<2> &from = chain.vertices[k];
          Point<2>        to   = chain.vertices[next(k)];
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
              wetted.push_back({from, to, normal});
            }
          // A crest at the level keeps the water out, whatever round-off says.
          if (to[1] >= level - tolerance)
            return false;
        }
      return true;
    }
  } // namespace


  void
  find_wetted_segments(const Surface              &surface,
                       const bool                  water_left,
                       const double                level,
                       const double                bottom,
                       const double                cell_size,
                       std::vector<LoadedSegment> &wetted)
  {
    wetted.clear();
    if (surface.chains.empty())
      return;

    // With the water on the left, up the outer slope is against the chain.
    const SurfaceChain &chain     = surface.chains[0];
    const double        tolerance = 1e-9 * cell_size;
    const Toe           toe  = find_toe(chain, water_left, bottom, cell_size);
    const int           wall = water_left ? 0 : 1;
    const bool          is_round =
      walk(chain, toe.vertex, water_left, wall, level, tolerance, wetted);

    // A body that floats is wet on the other side too.
    if (toe.floats && !is_round)
      walk(chain, toe.vertex, !water_left, -1, level, tolerance, wetted);
  }
} // namespace Waker
