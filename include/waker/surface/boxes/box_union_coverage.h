// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_boxes_box_union_coverage_h
#define waker_surface_boxes_box_union_coverage_h

#include <waker/surface/boxes/box_union.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace Waker
{
  /**
   * Which blocks of space boxes certainly cover once their gaps are filled, so
   * that the search for the contour can skip them.
   *
   * Space is divided into small cells, four to the smallest box in each
   * direction, and blocks of 4 x 4 x 4 of them. The cells
   * that single boxes cover are marked as bits, and gaps in rows of bits are
   * filled along x, then z, then y, if they have at most as many bits as fit
   * into the minimum gap. Both steps err on the open side only. A block of
   * which all bits are set is covered.
   *
   * In 2D PlaneCoverage does the same, faster; it tells why the covered blocks
   * may be skipped.
   */
  template <int dim>
  class BlockCoverage
  {
  public:
    void
    reinit(const std::vector<Box<dim>> &boxes, const BoxUnionRules<dim> &rules)
    {
      reinit(boxes, rules, extents_of(boxes));
    }

    /// The same for some of the boxes. Blocks are those of all boxes; what is
    /// said of one is right if all boxes are there that come nearer to it than
    /// the minimum gap.
    /// @param all of all boxes, which say how space is divided
    void
    reinit(const std::vector<Box<dim>> &boxes,
           const BoxUnionRules<dim>    &rules,
           const BoxExtents<dim>       &all);

    /// Extent of a block (m).
    static Tensor<1, dim>
    block_extent(const BoxUnionRules<dim> &rules, const BoxExtents<dim> &all);

    /// Count the blocks that a closed face touches as not covered.
    void
    open_blocks_at_closed_faces();

    /// Does the box, as far as it lies within the closed faces, touch a block
    /// that is not covered?
    bool
    touches_open_block(const Box<dim> &box) const
    {
      Index first;
      Index last;
      touched_blocks(box, first, last);
      Index i = first;
      do
        {
          for (i[0] = first[0]; i[0] <= last[0]; ++i[0])
            if (!is_covered(i))
              return true;
      } while (next_row(first, last, i));
      return false;
    }

    /// The covered blocks, those in a row along x as one box.
    void
    append_covered_rows(std::vector<Box<dim>> &rows) const;

    using Index = std::array<int, dim>;

    const Index &
    n_blocks() const
    {
      return n;
    }

    bool
    is_covered(const Index &index) const
    {
      return covered[number(index)];
    }

    /// The place of a block.
    Box<dim>
    block(const Index &index) const;

    /// Of a block among those of all boxes: x runs fastest.
    std::uint64_t
    number_of_all(const Index &index) const
    {
      std::uint64_t number = 0;
      for (int d = dim - 1; d >= 0; --d)
        number = number << 21 |
                 static_cast<std::uint64_t>(first[d] + index[d] + (1 << 20));
      return number;
    }

    /// The first and last block that a box touches, as far as it lies within
    /// the closed faces.
    void
    touched_blocks(const Box<dim> &box, Index &first, Index &last) const
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double a = std::max(box.lower[d], searched.lower[d]);
          const double b = std::min(box.upper[d], searched.upper[d]);
          first[d] = static_cast<int>((a - block_origin[d]) * inverse_block[d]);
          last[d]  = static_cast<int>((b - origin[d] + rules.tolerance) *
                                     inverse_block[d]);
        }
    }

    /// The next row of blocks in a range, from any of the last one.
    static bool
    next_row(const Index &first, const Index &last, Index &row)
    {
      for (unsigned int d = 1; d < dim; ++d)
        {
          if (row[d]++ < last[d])
            return true;
          row[d] = first[d];
        }
      return false;
    }

  private:
    std::size_t
    number(const Index &index) const
    {
      std::size_t i = index[dim - 1];
      for (int d = dim - 2; d >= 0; --d)
        i = i * n[d] + index[d];
      return i;
    }

    /// Blocks on a lattice through rules.lower, around boxes between these
    /// corners.
    struct Lattice
    {
      Index       first, n; // n up to 1e6
      std::size_t n_words;  // of bits
    };

    static Lattice
    lattice(const BoxUnionRules<dim> &rules,
            const Tensor<1, dim>     &block,
            const Point<dim>         &lower,
            const Point<dim>         &upper);

    void
    choose_lattice(const std::vector<Box<dim>> &boxes,
                   const BoxExtents<dim>       &all);

    void
    mark(const std::vector<Box<dim>> &boxes);

    void
    mark_beyond_closed_faces();

    // Set the zeros in rows of at most `gap` between ones.
    void
    fill_along_x(const unsigned int gap);

    void
    fill_along(const unsigned int direction, const unsigned int gap);

    void
    find_covered_blocks();

    static constexpr int bits_per_block = 4;

    BoxUnionRules<dim> rules;
    Point<dim>         origin;
    Point<dim>         block_origin;  // a tolerance above the origin
    Tensor<1, dim>     inverse_block; // 1/m
    Box<dim>           searched; // between the closed faces, within all blocks
    Tensor<1, dim>     cell;     // extent of a small cell, m
    Index              first;    // number of the first block, from rules.lower
    Index              n;        // blocks
    std::size_t        words_per_row;
    std::array<int, dim> n_lines; // small cells

    // Bits of the small cells, x fastest, each row in whole words.
    std::vector<std::uint64_t> bits;
    std::vector<std::uint64_t> dilated;
    std::vector<unsigned char> covered; // blocks, x fastest
  };
} // namespace Waker

#endif
