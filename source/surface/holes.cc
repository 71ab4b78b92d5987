// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/holes.h>

namespace Waker
{
  void
  Holes::mark(const double tolerance, Facets<3> &facets)
  {
    if (facets.empty())
      return;
    links_finder.find(facets, tolerance, links);
    volume.assign(find_parts(facets.size(), links, part), 0.);

    // The divergence theorem, relative to a vertex, so that a body far from the
    // origin loses no digits.
    const Point<3> &origin = facets[0].vertices[0];
    for (std::size_t i = 0; i < facets.size(); ++i)
      volume[part[i]] += (facets[i].vertices[0] - origin) * facets[i].normal *
                         facets[i].measure() / 3.;
    for (std::size_t i = 0; i < facets.size(); ++i)
      facets[i].in_hole = volume[part[i]] < 0.;
  }
} // namespace Waker
