// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_boxes_box_union_plane_coverage_h
#define waker_surface_boxes_box_union_plane_coverage_h

#include <waker/grid/node_exchange.h>
#include <waker/surface/boxes/box_union.h>
#include <waker/surface/boxes/box_union_bit_raster.h>

#include <array>
#include <cstdint>
#include <vector>

namespace Waker
{
  /**
   * Which blocks of the plane rectangles certainly cover once their gaps are
   * filled, so that the search for the contour can skip them. In 3D:
   * BlockCoverage.
   *
   * The plane is divided into small cells, eight to the width and four to the
   * height of the smallest rectangle, and blocks of that extent. The cells that
   * single rectangles cover are marked as bits: all rectangles have at least
   * the extent of the smallest, so that one bit each, for the lowest cell
   * covered, and a dilation of the whole raster will do. Gaps in rows of bits
   * are filled along x, then y, if they have at most as many bits as fit into
   * the minimum gap. All steps err on the open side only. A block of which all
   * bits are set is covered.
   *
   * Let S be the filled body by the slab method, X its slabs before vertical
   * gaps are filled and C the covered blocks. C lies in S: a horizontal gap of
   * bits that is filled contains no gap of the rectangles wider than W_min,
   * which the left extensions fill; a vertical one no gap higher than H_min.
   * The contour of the rectangles that touch, by themselves or with their
   * extensions, a block that is not covered, together with C, is that of all
   * rectangles: slab by slab, from the left, the restricted X agrees with X
   * outside C and with C lies between X and S = fill(X), and what lies between
   * them is filled to S. More rectangles than those do no harm.
   */
  class PlaneCoverage
  {
  public:
    void
    reinit(const std::vector<Box<2>> &boxes, const BoxUnionRules<2> &rules)
    {
      reinit(boxes, rules, extents_of(boxes));
    }

    /// The same where each of several ranks has some of the boxes: each knows
    /// the blocks that all of them cover.
    /// @param all of all boxes, these and others
    /// @param ranks that have others; null: none
    void
    reinit(const std::vector<Box<2>> &boxes,
           const BoxUnionRules<2>    &rules,
           const BoxExtents<2>       &all,
           const NodeExchange        *ranks = nullptr);

    /// The numbers of the rectangles of the last call that touch, by themselves
    /// or with their extensions, a block that is not covered, and perhaps some
    /// more, in ascending order.
    void
    find_open(std::vector<unsigned int> &numbers);

    /// The covered blocks, those in a row along x as one.
    void
    append_covered_rows(std::vector<Box<2>> &rows) const;

  private:
    using Word = BitRaster::Word;

    // The small cells that a rectangle covers, from begin to before end.
    struct Cells
    {
      int begin_x;
      int begin_y;
      int end_x;
      int end_y;
    };

    void
    choose_lattice(const BoxExtents<2> &all);

    void
    find_cells(const std::vector<Box<2>> &boxes);

    void
    mark_cells();

    /// What any rank has marked is marked.
    void
    unite_marks();

    void
    mark_beyond_closed_faces();

    void
    find_covered_blocks();

    bool
    is_large(const Cells &c) const
    {
      return c.end_x - c.begin_x > large[0] || c.end_y - c.begin_y > large[1];
    }

    // Cells in a block, and in the smallest rectangle: a byte along x.
    static constexpr std::array<int, 2> block_size = {{8, 4}};

    BoxUnionRules<2>            rules;
    const NodeExchange         *ranks = nullptr;
    Point<2>                    origin;
    Tensor<1, 2>                cell; // extent of a small cell, m
    std::array<int, 2>          n_blocks;
    std::array<int, 2>          mark;  // cells that every rectangle covers
    std::array<int, 2>          large; // cells; larger ones are marked in full
    int                         longest; // cells along x of all others
    std::array<unsigned int, 2> gap;     // cells within a minimum gap
    std::vector<Cells>          cells;   // per rectangle
    BitRaster                   raster;  // small cells
    BitRaster                   covered; // a byte per block: 0 or 255
    BitRaster                   open; // the same, then the corners that matter
  };
} // namespace Waker

#endif
