// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_boxes_box_union_contour_h
#define waker_surface_boxes_box_union_contour_h

#include <waker/surface/boxes/box_union.h>
#include <waker/surface/boxes/box_union_chains.h>
#include <waker/surface/boxes/box_union_coordinates.h>
#include <waker/surface/boxes/box_union_plane_coverage.h>
#include <waker/surface/shape/surface.h>

#include <vector>

namespace Waker
{
  /**
   * The contour of a union of rectangles along the axes, with its small gaps
   * filled: the slab method of Prusinkiewicz and Raghavan (1985), as extended
   * in section 3.6.2 of Remmerswaal (2023).
   *
   * A slab lies between neighbouring x at which a rectangle, or the extension
   * of one by W_min to its left, begins or ends; it is divided into segments
   * by the horizontal edges in it. With J and K the numbers of rectangles and
   * of left extensions over a segment, eqs. 3.12 and 3.13, the segment is in
   * the body (eq. 3.14)
   *
   *   I = 1   if J > 0, or K > 0 and I* = 1 at its place in the slab before,
   *   I* = 1  if I = 1, or in a run of segments with I = 0, neither the lowest
   *           nor the highest of the slab, of a total height up to H_min.
   *
   * Slabs without width, which the thesis has between equal coordinates, do not
   * exist here: the result does not depend on the order of the rectangles. A
   * gap of exactly W_min or H_min is filled. The filling never shrinks the
   * body; it is neither idempotent nor mirror symmetric, because what is filled
   * vertically is carried on to the right, but not to the left. With
   * BoxUnionRules::symmetric I, not I*, of the slab before counts: the
   * horizontal gaps up to W_min are filled, and then the vertical ones up to
   * H_min.
   *
   * From slab to slab only the segments are visited that an edge begins or ends
   * at and the runs beside them, and of those ends only the ones that can
   * change a state (apply()). With n rectangles of which each meets the edges
   * of m others: O(n (m + log n)).
   *
   * Keeps its work arrays from call to call.
   */
  class BoxUnionContour
  {
  public:
    /// @param surface overwritten; closed oriented chains, collinear edges
    ///        merged (see ContourChains)
    void
    trace(const std::vector<Box<2>> &boxes,
          const BoxUnionRules<2>    &rules,
          Surface                   &surface)
    {
      find_visible(boxes, rules, extents_of(boxes), visible);
      trace(visible, rules, surface);
    }

    /// What decides where the contour of boxes is: those that may be seen from
    /// outside, and blocks that are certainly inside, in rows.
    struct Visible
    {
      std::vector<Box<2>> boxes, covered;
    };

    /**
     * Which they are. Where each of several ranks has some of the boxes, all
     * that these find together are the visible ones, and each knows all covered
     * blocks.
     *
     * @param all of all boxes, these and others
     * @param ranks that have others; null: none
     */
    void
    find_visible(const std::vector<Box<2>> &boxes,
                 const BoxUnionRules<2>    &rules,
                 const BoxExtents<2>       &all,
                 Visible                   &visible,
                 const NodeExchange        *ranks = nullptr);

    /// The contour of all boxes of which these are visible.
    void
    trace(const Visible          &visible,
          const BoxUnionRules<2> &rules,
          Surface                &surface);

    /// The rectangles and rows of covered blocks that were swept last.
    std::size_t
    n_swept() const
    {
      return swept.size();
    }

  private:
    // What happens to a rectangle at an x.
    enum Change : unsigned char
    {
      extension_begins,
      box_begins,
      box_ends,
      cover_begins,
      cover_ends,
      extension_ends
    };
    static constexpr unsigned int n_changes = 8; // in a tag

    // The segment from a rank of y up to the next active one.
    struct Segment
    {
      double       y;    // m, of its lower end
      unsigned int next; // active breakpoints
      unsigned int previous;
      int          n_boxes;        // J
      int          n_extensions;   // K
      int          n_edges;        // at its lower end
      signed char  n_covers;       // covered blocks
      bool         before_filling; // symmetric: I without the covered blocks
      bool         inside;         // I*, of the slab before until evaluated
      bool         now;            // I*
    };

    struct Range
    {
      unsigned int begin;
      unsigned int end;
    };

    // Cut at the closed faces.
    void
    select(const Visible &visible);

    void
    rank_coordinates();

    void
    add_events(const unsigned int box, const bool is_cover);

    void
    start_sweep();

    void
    apply(const unsigned int box, const Change change);

    void
    open_breakpoint(const unsigned int y);

    // Remove it if no edge is there and it divides nothing.
    void
    tidy_breakpoint(const unsigned int y);

    // I: is the segment inside before the vertical gaps are filled?
    bool
    is_solid(const Segment &s) const
    {
      return s.n_covers > 0 || is_solid_without_covers(s);
    }

    bool
    is_solid_without_covers(const Segment &s) const
    {
      return s.n_boxes > 0 ||
             (s.n_extensions > 0 &&
              ((rules.symmetric ? s.before_filling : s.inside) ||
               at_left_face));
    }

    // Find the state of all segments that a change at this x can reach.
    void
    evaluate(const unsigned int x);

    void
    evaluate(const unsigned int x, const Range &range);

    BoxUnionRules<2>          rules;
    Visible                   visible;
    PlaneCoverage             coverage;
    std::vector<unsigned int> near_surface; // rectangles
    std::vector<Box<2>>       swept;        // cut at the closed faces
    unsigned int              n_boxes;      // in swept; then the covered blocks

    SnappedCoordinates        x_coordinates;
    SnappedCoordinates        y_coordinates;
    std::vector<unsigned int> y_ranks; // low and high of each in swept
    ContourChains::FaceRanks  faces;

    RankSet                   active;   // ranks of y with a breakpoint
    std::vector<Segment>      segments; // by rank of y
    std::vector<double>       y; // by rank of y, from -infinity to infinity
    bool                      at_left_face;
    std::vector<Range>        changed;
    std::vector<unsigned int> released; // breakpoints

    std::vector<ContourChains::Edge> edges;
    ContourChains                    chains;
  };
} // namespace Waker

#endif
