// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_boundary_facet_links_h
#define waker_boundary_facet_links_h

#include <waker/boundary/facet.h>

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
    // A side of a triangle, on a line that the keys name: a line along an axis,
    // or one through two vertices.
    struct Side
    {
      std::uint64_t keys[2];
      double        begin, end; // along the line
      Point<3>      from, to;   // in this order along the line
      unsigned int  facet;
    };

    std::vector<Side>         sides;
    std::vector<unsigned int> order;
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
