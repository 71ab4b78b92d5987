// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_facet_links_h
#define waker_surface_facet_links_h

#include <waker/surface/shape/facet.h>

#include <cstdint>
#include <vector>

namespace Waker
{
  /// Two triangles that meet along a line.
  struct FacetLink
  {
    unsigned int facets[2];
    Point<3>     from, to; // ends of the line that they share (m)
  };


  /**
   * How the triangles of a surface hang together: through sides that they have
   * in common and, where a side lies along an axis, through sides that overlap
   * (as of the rectangles that bound a union of boxes).
   *
   * O(n log n) for n triangles. Keeps its work arrays from call to call.
   */
  class FacetLinks
  {
  public:
    /**
     * @param tolerance coordinates closer to each other than this count as one
     *        (m)
     * @param links overwritten
     */
    void
    find(const Facets<3>        &facets,
         const double            tolerance,
         std::vector<FacetLink> &links);

  private:
    // A side of a triangle.
    struct Side
    {
      Point<3>     from, to; // in the direction of the line
      double       end;      // along the line, as Entry::begin
      unsigned int facet;
    };

    // What the sides are sorted by: the line (one along an axis, or that
    // through two vertices), and where they begin on it.
    struct Entry
    {
      std::uint64_t line;
      double        begin;
      unsigned int  side;
    };

    std::vector<Side>         sides;
    std::vector<Entry>        entries;
    std::vector<unsigned int> open; // sides that the sweep has not passed yet
  };


  /**
   * Number the connected parts of a surface from 0.
   *
   * @param part overwritten: of each facet
   * @return the number of parts
   */
  unsigned int
  find_parts(const unsigned int            n_facets,
             const std::vector<FacetLink> &links,
             std::vector<unsigned int>    &part);
} // namespace Waker

#endif
