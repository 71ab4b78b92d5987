// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_holes_h
#define waker_surface_holes_h

#include <waker/surface/facet_links.h>

#include <vector>

namespace Waker
{
  /**
   * Which facets of a closed surface in space bound holes inside a body: those
   * of connected parts that enclose a negative volume. Keeps its work arrays
   * from call to call.
   */
  class Holes
  {
  public:
    /**
     * Set Facet::in_hole.
     * @param tolerance see FacetLinks::find() (m)
     */
    void
    mark(const double tolerance, Facets<3> &facets);

    /// In the plane, chains know by themselves.
    void
    mark(const double, Facets<2> &)
    {}

  private:
    FacetLinks                links_finder;
    std::vector<FacetLink>    links;
    std::vector<unsigned int> part;
    std::vector<double>       volume;
  };
} // namespace Waker

#endif
