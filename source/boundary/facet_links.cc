// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/boundary/facet_links.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace Waker
{
  namespace
  {
    // Finaliser of splitmix64 (Steele et al. 2014).
    std::uint64_t
    mix(std::uint64_t x)
    {
      x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
      x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
      return x ^ (x >> 31);
    }


    std::uint64_t
    combine(const std::uint64_t a, const std::uint64_t b)
    {
      return mix(a + 0x9e3779b97f4a7c15u + mix(b));
    }
  } // namespace


  void
  FacetLinks::find(const Facets<3>        &facets,
                   const double            tolerance,
                   std::vector<FacetLink> &links)
  {
    links.clear();
    if (facets.empty())
      return;

    // Coordinates in units of the tolerance. The shift keeps the usual ones,
    // multiples of a cell's part, away from where rounding changes.
    const Point<3> origin = facets[0].vertices[0];
    const double   scale  = 1. / tolerance;
    const auto     round  = [=](const Point<3> &x, const unsigned int d) {
      return static_cast<std::uint64_t>(
        std::llround((x[d] - origin[d]) * scale + 0.17));
    };
    const auto key_of = [&](const Point<3> &x) {
      return combine(combine(round(x, 0), round(x, 1)), round(x, 2));
    };

    sides.clear();
    for (unsigned int f = 0; f < facets.size(); ++f)
      for (unsigned int k = 0; k < 3; ++k)
        {
          Side side;
          side.facet          = f;
          side.from           = facets[f].vertices[k];
          side.to             = facets[f].vertices[(k + 1) % 3];
          const auto   along  = side.to - side.from;
          unsigned int n_same = 0, axis = 0;
          for (unsigned int d = 0; d < 3; ++d)
            if (round(side.from, d) == round(side.to, d))
              ++n_same;
            else
              axis = d;
          if (n_same == 3)
            continue;
          if (n_same == 2)
            {
              const unsigned int e = (axis + 1) % 3;
              side.keys[0]         = combine(axis, round(side.from, e));
              side.keys[1]         = round(side.from, (axis + 2) % 3);
              if (along[axis] < 0)
                std::swap(side.from, side.to);
              side.begin = side.from[axis];
              side.end   = side.to[axis];
            }
          else
            {
              side.keys[0] = key_of(side.from);
              side.keys[1] = key_of(side.to);
              if (side.keys[0] > side.keys[1])
                {
                  std::swap(side.keys[0], side.keys[1]);
                  std::swap(side.from, side.to);
                }
              side.begin = 0.;
              side.end   = along.norm();
            }
          sides.push_back(side);
        }

    order.resize(sides.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(),
              order.end(),
              [&](const unsigned a, const unsigned b) {
                const auto rank = [](const Side &s) {
                  return std::tie(s.keys[0], s.keys[1], s.begin, s.facet);
                };
                return rank(sides[a]) < rank(sides[b]);
              });

    // Sweep along each line.
    const Side *last = nullptr;
    for (const unsigned int s : order)
      {
        const Side &side = sides[s];
        if (last == nullptr || last->keys[0] != side.keys[0] ||
            last->keys[1] != side.keys[1])
          open.clear();
        last = &side;

        std::size_t n_open = 0;
        for (const unsigned int o : open)
          {
            const Side &other = sides[o];
            if (other.end <= side.begin + tolerance)
              continue;
            open[n_open++] = o;
            if (other.facet != side.facet)
              links.push_back({{other.facet, side.facet},
                               side.from,
                               side.end < other.end ? side.to : other.to});
          }
        open.resize(n_open);
        open.push_back(s);
      }
  }


  unsigned int
  find_parts(const unsigned int            n_facets,
             const std::vector<FacetLink> &links,
             std::vector<unsigned int>    &part)
  {
    // Union by the lower number, with path halving; then number the roots.
    part.resize(n_facets);
    std::iota(part.begin(), part.end(), 0u);
    const auto root = [&](unsigned int f) {
      while (part[f] != f)
        f = part[f] = part[part[f]];
      return f;
    };
    for (const FacetLink &link : links)
      {
        const unsigned int a = root(link.facets[0]);
        const unsigned int b = root(link.facets[1]);
        part[std::max(a, b)] = std::min(a, b);
      }

    // A root comes before what hangs on it.
    unsigned int n_parts = 0;
    for (unsigned int f = 0; f < n_facets; ++f)
      part[f] = part[f] == f ? n_parts++ : part[part[f]];
    return n_parts;
  }
} // namespace Waker
