// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_boxes_box_union_faces_h
#define waker_surface_boxes_box_union_faces_h

#include <waker/surface/boxes/box_union.h>
#include <waker/surface/boxes/box_union_coordinates.h>
#include <waker/surface/boxes/box_union_coverage.h>
#include <waker/surface/shape/facet.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace Waker
{
  /**
   * The surface of a union of boxes along the axes, with its small gaps filled.
   *
   * A gap is a stretch between boxes of at most the minimum gap. The gaps along
   * x are filled, then those along z in what results, then those along y: the
   * three-dimensional form of what BoxUnionContour does with
   * BoxUnionRules::symmetric.
   *
   * Space is divided into the blocks of BlockCoverage. Those that are covered
   * are skipped; in each other one the boxes within reach are marked on the
   * lattice of their own coordinates, and the faces between inside and outside
   * collected, joined to rectangles and halved to triangles. The facets are
   * oriented outwards and close the body, but a vertex may lie on the side of
   * another triangle.
   *
   * Linear in the number of boxes near the surface. Keeps its work arrays from
   * call to call.
   */
  class BoxUnionFaces
  {
  public:
    /// @param facets overwritten
    void
    find(const std::vector<Box<3>> &boxes,
         const BoxUnionRules<3>    &rules,
         Facets<3>                 &facets);

    /// A part of the surface, as those are told who have not found it.
    struct Rectangle
    {
      std::uint64_t         block; // number among all of them
      std::int32_t          direction;
      std::int16_t          faces_up; // 1: the body is below
      std::int16_t          on_face;
      double                place;        // in the direction (m)
      std::array<double, 2> lower, upper; // in the two that follow it (m)
    };

    /// The blocks of one of several who find the surface together.
    struct Share
    {
      /// Is a block in it? By its centre. Without: all are.
      std::function<bool(const Point<3> &centre)> has;
      /// Numbers that each has become those of all.
      std::function<void(std::vector<double> &)> tell_all;
    };

    /**
     * What is found in some of the blocks: those of all blocks, in the order of
     * the blocks, are the surface.
     *
     * @param boxes all that may come nearer to these blocks than reach()
     * @param all of all boxes, these and others
     */
    void
    find(const std::vector<Box<3>> &boxes,
         const BoxUnionRules<3>    &rules,
         const BoxExtents<3>       &all,
         const Share               &share,
         std::vector<Rectangle>    &rectangles);

    /// How far from the centre of a block, in each direction, boxes may end or
    /// begin that matter in it (m).
    static double
    reach(const BoxUnionRules<3> &rules, const BoxExtents<3> &all);

    /// @param facets overwritten
    static void
    to_facets(const std::vector<Rectangle> &rectangles, Facets<3> &facets);

  private:
    using Index = BlockCoverage<3>::Index;
    using Ranks = std::array<unsigned int, 3>;

    static constexpr unsigned int none = -1;

    void
    select(const std::vector<Box<3>> &boxes, const BoxExtents<3> &all);

    void
    rank_coordinates(const Share &share);

    void
    list_boxes_by_block();

    // Those of `selected` that have a say in the share's blocks.
    void
    find_heard(const Share &share);

    // Coordinates of boxes that others have, so that those which are one are
    // the same one everywhere.
    void
    add_coordinates_of_all(const unsigned int direction,
                           const Share       &share,
                           const unsigned int tag);

    // Is there nothing to be found in the block, or no such block?
    bool
    is_skipped(const Index &block) const;

    // Lay the lattice of a block: its own faces and what of the boxes is
    // within the reach of its gaps.
    void
    lay_lattice(const Index &block);

    void
    mark_inside(const Index &block);

    // Along x or z, for whole rows of bits along y at once.
    void
    fill_rows(const unsigned int direction);

    // Along y, in the cells of the block and next to it.
    void
    fill_along_y();

    void
    collect_faces(const Index &block, std::vector<Rectangle> &rectangles);

    void
    collect_plane(const Index            &block,
                  const unsigned int      direction,
                  const unsigned int      line,
                  std::vector<Rectangle> &rectangles);

    std::size_t
    block_number(const Index &block) const;

    BoxUnionRules<3>           rules;
    BlockCoverage<3>           coverage;
    std::vector<Box<3>>        selected; // cut at the closed faces
    std::vector<unsigned char> is_heard; // of those selected
    std::vector<double>        told;     // coordinates

    // By direction.
    std::array<SnappedCoordinates, 3>        coordinates;
    std::array<std::vector<unsigned int>, 3> box_ranks; // lower, upper of each
    std::array<std::vector<unsigned int>, 3> block_lines; // ranks
    std::array<unsigned int, 6>              face_ranks;

    // The boxes within reach of each block.
    std::vector<std::size_t>  list_begins;
    std::vector<unsigned int> lists;

    // The lattice of a block: ranks of its lines, the first and last of those
    // of the block itself, the first and last between the closed faces.
    std::array<std::vector<unsigned int>, 3> lines;
    std::array<std::vector<unsigned int>, 3> line_of_rank;
    Ranks                                    block_begin;
    Ranks                                    block_end;
    Ranks                                    near_begin; // and one more cell
    Ranks                                    near_end;
    Ranks                                    open_begin;
    Ranks                                    open_end;
    Ranks                                    strides;
    std::size_t                              words_per_row; // along y
    std::vector<std::uint64_t>               bits;          // inside, y fastest
    std::vector<unsigned int>                reaches;
    std::vector<unsigned char>               inside; // the same, of the block
    std::vector<signed char>                 plane;
    std::vector<Rectangle>                   found;
  };
} // namespace Waker

#endif
