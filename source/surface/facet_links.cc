// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/facet_links.h>

#include <algorithm>
#include <array>
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
    using Rounded         = std::array<std::uint64_t, 3>;
    const Point<3> origin = facets[0].vertices[0];
    const double   scale  = 1. / tolerance;
    const auto     round  = [=](const Point<3> &x) {
      Rounded r;
      for (unsigned int d = 0; d < 3; ++d)
        r[d] = static_cast<std::uint64_t>(static_cast<std::int64_t>(
          std::floor((x[d] - origin[d]) * scale + 0.67)));
      return r;
    };

    sides.clear();
    entries.clear();
    for (unsigned int f = 0; f < facets.size(); ++f)
      {
        const auto   &v    = facets[f].vertices;
        const Rounded r[3] = {round(v[0]), round(v[1]), round(v[2])};
        for (unsigned int k = 0; k < 3; ++k)
          {
            const unsigned int k1   = (k + 1) % 3;
            Side               side = {v[k], v[k1], 0., f};
            Entry entry = {0, 0., static_cast<unsigned int>(sides.size())};
            unsigned int n_same = 0, axis = 0;
            for (unsigned int d = 0; d < 3; ++d)
              if (r[k][d] == r[k1][d])
                ++n_same;
              else
                axis = d;
            if (n_same == 3)
              continue;
            if (n_same == 2)
              {
                entry.line = combine(combine(axis, r[k][(axis + 1) % 3]),
                                     r[k][(axis + 2) % 3]);
                if (side.from[axis] > side.to[axis])
                  std::swap(side.from, side.to);
                entry.begin = side.from[axis];
                side.end    = side.to[axis];
              }
            else
              {
                // The lower vertex first.
                const bool     is_up = r[k] < r[k1];
                const Rounded &a     = is_up ? r[k] : r[k1];
                const Rounded &b     = is_up ? r[k1] : r[k];
                for (unsigned int d = 0; d < 3; ++d)
                  entry.line = combine(combine(entry.line, a[d]), b[d]);
                if (!is_up)
                  std::swap(side.from, side.to);
                side.end = side.from.distance(side.to);
              }
            sides.push_back(side);
            entries.push_back(entry);
          }
      }

    std::sort(entries.begin(),
              entries.end(),
              [](const Entry &a, const Entry &b) {
                return std::tie(a.line, a.begin, a.side) <
                       std::tie(b.line, b.begin, b.side);
              });

    // Sweep along each line.
    open.clear();
    for (std::size_t e = 0; e < entries.size(); ++e)
      {
        const Entry &entry = entries[e];
        const Side  &side  = sides[entry.side];
        if (e > 0 && entries[e - 1].line != entry.line)
          open.clear();

        std::size_t n_open = 0;
        for (const unsigned int o : open)
          {
            const Side &other = sides[o];
            if (other.end <= entry.begin + tolerance)
              continue;
            open[n_open++] = o;
            if (other.facet != side.facet)
              links.push_back({{other.facet, side.facet},
                               side.from,
                               side.end < other.end ? side.to : other.to});
          }
        open.resize(n_open);
        open.push_back(entry.side);
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
