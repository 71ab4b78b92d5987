// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_wetted_facets_h
#define waker_loads_wetted_facets_h

#include <waker/loads/wet_surface.h>
#include <waker/surface/facet_links.h>
#include <waker/surface/shape/facet.h>

#include <optional>
#include <vector>

namespace Waker
{
  /**
   * What find_wetted_segments() finds in the plane, in three dimensions: what
   * the water reaches of the largest body over its surface, from the outer toe
   * line, without coming up to the level, clipped at the level. So it comes
   * through a gap in the crest, and stays out of a hollow behind it, or inside.
   *
   * The outer toe line, with the water on the left, is the left end of the
   * body's contact with the closed bottom, in each slice of the width of a cell
   * along z. Where this contact begins at the closed left wall, it is the
   * lowest line where the surface leaves the wall. A body that touches no
   * bottom, but comes within a cell of it, stands on what of its underside is
   * as low. One that is higher up floats: it is wet from its lowest vertex on.
   * Closed faces are not loaded. Water that comes to the toe line on the other
   * side has got over the body, or round its end.
   *
   * Facets may come from anywhere, as long as they are closed and meet as
   * FacetLinks can see. Keeps its work arrays from call to call.
   */
  class WettedFacets
  {
  public:
    /// @param wetted overwritten
    void
    find(const Facets<3> &facets,
         const bool       water_left,
         const double     level,
         const double     bottom,
         const double     cell_size,
         Facets<3>       &wetted);

    /// Where what was found last gets over; nothing if it does not.
    std::optional<Spill>
    spill() const
    {
      return lowest_spill;
    }

  private:
    // Keep the links of the part with the largest volume.
    void
    find_body(const Facets<3> &facets);

    // Which faces of the grid the facets close the body against. One that
    // hovers over the bottom: the low part of its underside does.
    void
    set_contacts(const Facets<3> &facets,
                 const double     bottom,
                 const double     cell_size);

    // The facets at the toe on one side.
    void
    find_toe(const bool                 left,
             const double               cell_size,
             std::vector<unsigned int> &toe);

    // Put the facets that the water starts from on the list `reached`.
    void
    start_at_lowest(const Facets<3> &facets,
                    const bool       water_left,
                    const double     cell_size);

    // Go on to all that is linked below the limit (m).
    void
    flood(const Facets<3> &facets, const double limit);

    void
    reach(const unsigned int facet);

    // The way from the water's toe to the other one whose highest link is
    // lowest.
    std::optional<Spill>
    find_spill(const std::size_t n_facets) const;

    FacetLinks                 finder;
    std::vector<FacetLink>     links;
    std::vector<unsigned int>  part;
    std::vector<double>        volumes;
    unsigned int               body = 0;  // number of its part
    std::vector<int>           contacts;  // on_face of each facet, or -1
    std::vector<double>        outermost; // of each slice: x, towards the water
    std::vector<double>        lowest;    // of each slice: y on the wall
    std::vector<unsigned char> at_wall;   // of each slice
    std::vector<unsigned int>  first_neighbour;
    std::vector<unsigned int>  neighbours;
    std::vector<unsigned int>  reached;
    std::vector<unsigned char> is_reached;
    std::vector<unsigned int>  toe, other_toe;
    std::optional<Spill>       lowest_spill;
    Facets<3>                  work;
  };
} // namespace Waker

#endif
