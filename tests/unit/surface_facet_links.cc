// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/facet_links.h>

#include "rectangles.h"
#include <gtest/gtest.h>

namespace surface_facet_links
{
  using namespace Waker;

  TEST(Surface, facets_are_linked_through_common_and_overlapping_sides)
  {
    // A rectangle beside two of half its height: sides overlap along y.
    Facets<3> facets;
    add_rectangle(facets,
                  Point<3>(0, 0, 0),
                  Point<3>(1, 0, 0),
                  Point<3>(1, 2, 0));
    add_rectangle(facets,
                  Point<3>(1, 0, 0),
                  Point<3>(2, 0, 0),
                  Point<3>(2, 1, 0));
    add_rectangle(facets,
                  Point<3>(1, 1, 0),
                  Point<3>(2, 1, 0),
                  Point<3>(2, 2, 0));
    add_rectangle(facets,
                  Point<3>(5, 0, 0),
                  Point<3>(6, 0, 0),
                  Point<3>(6, 1, 1));

    FacetLinks             finder;
    std::vector<FacetLink> links;
    finder.find(facets, 1e-6, links);
    // Four diagonals, two overlaps with the first, one between the halves.
    ASSERT_EQ(links.size(), 7u);
    double length = 0.;
    for (const FacetLink &link : links)
      {
        ASSERT_LT(link.facets[0], facets.size());
        if (link.from[0] == 1. && link.to[0] == 1.)
          length += link.from.distance(link.to);
      }
    EXPECT_NEAR(length, 2., 1e-14);
    std::vector<unsigned int> part;
    EXPECT_EQ(find_parts(facets.size(), links, part), 2u);
    EXPECT_EQ(part[0], part[5]);
    EXPECT_NE(part[0], part[6]);
    EXPECT_EQ(part[6], part[7]);
  }
} // namespace surface_facet_links
