// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/grid/box_face.h>
#include <waker/loads/facet_clip.h>
#include <waker/loads/wetted_facets.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace Waker
{
  namespace
  {
    constexpr int    bottom_face = static_cast<int>(BoxFace::bottom);
    constexpr double far         = std::numeric_limits<double>::max();
    constexpr double link_limit  = 1e-6; // of facets that meet, in cells
    constexpr double tie         = 1e-9; // of a crest with the level, in cells
  }                                      // namespace


  void
  WettedFacets::find(const Facets<3> &facets,
                     const bool       water_left,
                     const double     level,
                     const double     bottom,
                     const double     cell_size,
                     Facets<3>       &wetted)
  {
    wetted.clear();
    reached.clear();
    lowest_spill.reset();
    is_reached.assign(facets.size(), 0);
    if (facets.empty())
      return;

    finder.find(facets, link_limit * cell_size, links);
    find_body(facets);
    set_contacts(facets, bottom, cell_size);
    find_toe(water_left, cell_size, toe);
    for (const unsigned int f : toe)
      reach(f);
    if (reached.empty())
      start_at_lowest(facets, water_left, cell_size);
    flood(facets, level - tie * cell_size);
    if (!toe.empty())
      {
        find_toe(!water_left, cell_size, other_toe);
        // A facet at both toes closes a body's end: nothing gets over there.
        other_toe.erase(std::remove_if(other_toe.begin(),
                                       other_toe.end(),
                                       [&](const unsigned int f) {
                                         return std::find(toe.begin(),
                                                          toe.end(),
                                                          f) != toe.end();
                                       }),
                        other_toe.end());
        if (std::any_of(other_toe.begin(), other_toe.end(), [&](const auto f) {
              return is_reached[f];
            }))
          lowest_spill = find_spill(facets.size());
      }

    for (const unsigned int f : reached)
      wetted.push_back(facets[f]);
    Tensor<1, 3> up;
    up[1] = 1.;
    keep_below<3>(up, level, 0., wetted, work);
  }


  void
  WettedFacets::find_body(const Facets<3> &facets)
  {
    volumes.assign(find_parts(facets.size(), links, part), 0.);
    const Point<3> &origin = facets[0].vertices[0];
    for (unsigned int f = 0; f < facets.size(); ++f)
      volumes[part[f]] += facets[f].measure() *
                          (facets[f].normal * (facets[f].vertices[0] - origin));
    body = std::max_element(volumes.begin(), volumes.end()) - volumes.begin();
    links.erase(std::remove_if(links.begin(),
                               links.end(),
                               [&](const FacetLink &link) {
                                 return part[link.facets[0]] != body;
                               }),
                links.end());
  }


  void
  WettedFacets::set_contacts(const Facets<3> &facets,
                             const double     bottom,
                             const double     cell_size)
  {
    contacts.resize(facets.size());
    bool is_on_bottom = false;
    for (unsigned int f = 0; f < facets.size(); ++f)
      {
        contacts[f] = facets[f].on_face;
        is_on_bottom =
          is_on_bottom || (part[f] == body && contacts[f] == bottom_face);
      }
    if (is_on_bottom)
      return;

    for (unsigned int f = 0; f < facets.size(); ++f)
      {
        const auto  &v       = facets[f].vertices;
        const double highest = std::max({v[0][1], v[1][1], v[2][1]});
        if (contacts[f] < 0 && facets[f].normal[1] < -0.5 &&
            highest < bottom + cell_size)
          contacts[f] = bottom_face;
      }
  }


  void
  WettedFacets::find_toe(const bool                 left,
                         const double               cell_size,
                         std::vector<unsigned int> &toe)
  {
    const int    wall = left ? 0 : 1;
    const double side = left ? 1. : -1.;

    toe.clear();
    double first = far, last = -far;
    for (const FacetLink &link : links)
      {
        first = std::min({first, link.from[2], link.to[2]});
        last  = std::max({last, link.from[2], link.to[2]});
      }
    if (links.empty())
      return;
    const auto slice = [&](const double z) {
      return static_cast<unsigned int>((z - first) / cell_size);
    };
    const unsigned int n_slices = slice(last) + 1;
    outermost.assign(n_slices, far);
    lowest.assign(n_slices, far);
    at_wall.assign(n_slices, 0);

    // Call f(free facet or invalid, slice) for the slices of links between two
    // kinds of facets.
    const auto visit = [&](const int kind, const int other, const auto &f) {
      for (const FacetLink &link : links)
        for (unsigned int i = 0; i < 2; ++i)
          if (contacts[link.facets[i]] == kind &&
              contacts[link.facets[1 - i]] == other)
            {
              const auto z = std::minmax({link.from[2], link.to[2]});
              for (unsigned int k = slice(z.first); k <= slice(z.second); ++k)
                f(link.facets[1 - i], k, link);
            }
    };
    const auto x_of = [=](const FacetLink &link) {
      return std::min(side * link.from[0], side * link.to[0]);
    };
    const auto y_of = [](const FacetLink &link) {
      return std::min(link.from[1], link.to[1]);
    };

    visit(bottom_face,
          -1,
          [&](unsigned int, const unsigned int k, const auto &link) {
            outermost[k] = std::min(outermost[k], x_of(link));
          });
    visit(bottom_face,
          wall,
          [&](unsigned int, const unsigned int k, const FacetLink &) {
            at_wall[k] = 1;
          });
    visit(wall, -1, [&](unsigned int, const unsigned int k, const auto &link) {
      lowest[k] = std::min(lowest[k], y_of(link));
    });

    visit(bottom_face,
          -1,
          [&](const unsigned int f, const unsigned int k, const auto &link) {
            if (!at_wall[k] && x_of(link) <= outermost[k])
              toe.push_back(f);
          });
    visit(wall,
          -1,
          [&](const unsigned int f, const unsigned int k, const auto &link) {
            if (at_wall[k] && y_of(link) <= lowest[k])
              toe.push_back(f);
          });
  }


  void
  WettedFacets::start_at_lowest(const Facets<3> &facets,
                                const bool       water_left,
                                const double     cell_size)
  {
    const double side         = water_left ? 1. : -1.;
    double       lowest_point = far;
    for (unsigned int f = 0; f < facets.size(); ++f)
      if (part[f] == body)
        {
          // On the bottom, but all of the contact is at closed faces: dry.
          if (contacts[f] == bottom_face)
            return;
          for (const Point<3> &x : facets[f].vertices)
            lowest_point = std::min(lowest_point, x[1]);
        }

    // The detected underside scatters.
    double       outer = far;
    unsigned int start = facets.size();
    for (unsigned int f = 0; f < facets.size(); ++f)
      if (part[f] == body && contacts[f] < 0)
        for (const Point<3> &x : facets[f].vertices)
          if (x[1] <= lowest_point + 0.25 * cell_size && side * x[0] < outer)
            {
              outer = side * x[0];
              start = f;
            }
    if (start < facets.size())
      reach(start);
  }


  void
  WettedFacets::flood(const Facets<3> &facets, const double limit)
  {
    // What starts above the water stays dry.
    const auto is_dry = [&](const unsigned int f) {
      for (const Point<3> &x : facets[f].vertices)
        if (x[1] < limit)
          return false;
      return true;
    };
    std::size_t n_wet = 0;
    for (const unsigned int f : reached)
      if (is_dry(f))
        is_reached[f] = 0;
      else
        reached[n_wet++] = f;
    reached.resize(n_wet);

    // Neighbours of each free facet, through lines that lie below somewhere.
    const auto is_open = [&](const FacetLink &link) {
      return contacts[link.facets[0]] < 0 && contacts[link.facets[1]] < 0 &&
             std::min(link.from[1], link.to[1]) < limit;
    };
    first_neighbour.assign(facets.size() + 1, 0);
    for (const FacetLink &link : links)
      if (is_open(link))
        for (const unsigned int f : link.facets)
          ++first_neighbour[f + 1];
    for (std::size_t f = 0; f < facets.size(); ++f)
      first_neighbour[f + 1] += first_neighbour[f];
    neighbours.resize(first_neighbour.back());
    for (const FacetLink &link : links)
      if (is_open(link))
        for (unsigned int i = 0; i < 2; ++i)
          neighbours[--first_neighbour[link.facets[i] + 1]] =
            link.facets[1 - i];
    // Now the list of f begins at first_neighbour[f + 1].
    first_neighbour.push_back(neighbours.size());

    for (std::size_t k = 0; k < reached.size(); ++k)
      {
        const unsigned int f = reached[k];
        for (unsigned int i = first_neighbour[f + 1];
             i < first_neighbour[f + 2];
             ++i)
          reach(neighbours[i]);
      }
  }


  void
  WettedFacets::reach(const unsigned int facet)
  {
    if (is_reached[facet])
      return;
    is_reached[facet] = 1;
    reached.push_back(facet);
  }


  std::optional<Spill>
  WettedFacets::find_spill(const std::size_t n_facets) const
  {
    // As a pool fills: always on over the lowest link of its border.
    std::vector<std::vector<unsigned int>> links_of(n_facets);
    for (unsigned int l = 0; l < links.size(); ++l)
      if (contacts[links[l].facets[0]] < 0 && contacts[links[l].facets[1]] < 0)
        for (const unsigned int f : links[l].facets)
          links_of[f].push_back(l);
    std::vector<unsigned char> is_filled(n_facets, 0), is_end(n_facets, 0);
    for (const unsigned int f : other_toe)
      is_end[f] = 1;

    struct Entry
    {
      double       height;
      unsigned int link, facet;

      bool
      operator<(const Entry &other) const
      {
        return height > other.height; // the lowest on top
      }
    };
    std::priority_queue<Entry> border;
    const auto                 fill = [&](const unsigned int f) {
      is_filled[f] = 1;
      for (const unsigned int l : links_of[f])
        for (const unsigned int g : links[l].facets)
          if (!is_filled[g])
            border.push({std::min(links[l].from[1], links[l].to[1]), l, g});
    };
    for (const unsigned int f : toe)
      if (is_reached[f])
        fill(f);

    Spill spill{-far, 0.};
    while (!border.empty())
      {
        const Entry entry = border.top();
        border.pop();
        if (is_filled[entry.facet])
          continue;
        const FacetLink &link = links[entry.link];
        if (entry.height > spill.height)
          spill = {entry.height,
                   link.from[1] < link.to[1] ? link.from[2] : link.to[2]};
        if (is_end[entry.facet])
          return spill;
        fill(entry.facet);
      }
    return {};
  }
} // namespace Waker
