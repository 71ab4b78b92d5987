// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The bits of BlockCoverage.
#include <waker/surface/boxes/box_union_coverage.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// Set the bits from begin to before end.
    inline void
    set_bits(std::uint64_t *const row, const int begin, const int end)
    {
      if (begin >= end)
        return;
      const int           first = begin >> 6;
      const int           last  = (end - 1) >> 6;
      const std::uint64_t head  = ~std::uint64_t(0) << (begin & 63);
      const std::uint64_t tail  = ~std::uint64_t(0) >> (63 - ((end - 1) & 63));
      if (first == last)
        {
          row[first] |= head & tail;
          return;
        }
      row[first] |= head;
      for (int w = first + 1; w < last; ++w)
        row[w] = ~std::uint64_t(0);
      row[last] |= tail;
    }
  } // namespace



  template <int dim>
  void
  BlockCoverage<dim>::mark(const std::vector<Box<dim>> &boxes)
  {
    // A bit may reach beyond its box by half the tolerance: the gap that it
    // then hides has the width of the tolerance at most, and is none.
    std::array<double, dim> inverse;
    std::array<double, dim> slack;
    for (unsigned int d = 0; d < dim; ++d)
      {
        inverse[d] = 1. / cell[d];
        slack[d]   = std::min(0.5 * rules.tolerance * inverse[d], 0.01);
      }
    for (const Box<dim> &box : boxes)
      {
        int begin[3] = {0, 0, 0};
        int end[3]   = {1, 1, 1};
        for (unsigned int d = 0; d < dim; ++d)
          {
            // The origin lies a block below all boxes: no negative numbers,
            // so that truncation is the floor.
            const double a = (box.lower[d] - origin[d]) * inverse[d] - slack[d];
            const double b = (box.upper[d] - origin[d]) * inverse[d] + slack[d];
            begin[d]       = static_cast<int>(a) + 1;
            if (begin[d] - a >= 1.)
              --begin[d];
            end[d] = static_cast<int>(b);
          }
        if (begin[0] >= end[0])
          continue;

        for (int k = begin[2]; k < end[2]; ++k)
          for (int j = begin[1]; j < end[1]; ++j)
            {
              std::uint64_t *const row =
                bits.data() + (std::size_t(k) * n_lines[1] + j) * words_per_row;
              set_bits(row, begin[0], end[0]);
            }
      }
  }



  template <int dim>
  void
  BlockCoverage<dim>::mark_beyond_closed_faces()
  {
    std::array<int, 3> n_all = {{1, 1, 1}};
    for (unsigned int d = 0; d < dim; ++d)
      n_all[d] = n_lines[d];

    for (unsigned int face = 0; face < 2 * dim; ++face)
      {
        if (!rules.is_closed(face))
          continue;
        const unsigned int d = face / 2;
        const double place   = face % 2 == 0 ? rules.lower[d] : rules.upper[d];
        const double line    = (place - origin[d]) / cell[d];
        const double slack   = 0.5 * rules.tolerance / cell[d];

        std::array<int, 3> begin = {{0, 0, 0}};
        std::array<int, 3> end   = n_all;
        const double       limit = n_all[d];
        if (face % 2 == 0)
          end[d] = std::floor(std::min(std::max(line + slack, 0.), limit));
        else
          begin[d] = std::ceil(std::min(std::max(line - slack, 0.), limit));

        for (int k = begin[2]; k < end[2]; ++k)
          for (int j = begin[1]; j < end[1]; ++j)
            {
              std::uint64_t *const row =
                bits.data() + (std::size_t(k) * n_lines[1] + j) * words_per_row;
              set_bits(row, begin[0], end[0]);
            }
      }
  }



  template <int dim>
  void
  BlockCoverage<dim>::fill_along_x(const unsigned int gap)
  {
    // Closing: dilate by `gap` bits upwards, then erode by as many. A gap that
    // reaches the end of the row stays open.
    if (gap == 0)
      return;
    const unsigned int g = std::min(gap, 31u);
    for (std::size_t row = 0; row < bits.size(); row += words_per_row)
      {
        std::uint64_t *const m       = bits.data() + row;
        std::uint64_t *const d       = dilated.data() + row;
        std::uint64_t        carried = 0;
        for (std::size_t w = 0; w < words_per_row; ++w)
          {
            d[w] = m[w];
            for (unsigned int t = 1; t <= g; ++t)
              d[w] |= m[w] << t | carried >> (64 - t);
            carried = m[w];
          }
        for (std::size_t w = 0; w < words_per_row; ++w)
          {
            const std::uint64_t above = w + 1 < words_per_row ? d[w + 1] : 0;
            std::uint64_t       e     = d[w];
            for (unsigned int t = 1; t <= g; ++t)
              e &= d[w] >> t | above << (64 - t);
            m[w] |= e;
          }
      }
  }



  template <int dim>
  void
  BlockCoverage<dim>::fill_along(const unsigned int direction,
                                 const unsigned int gap)
  {
    if (gap == 0)
      return;
    const std::size_t line =
      direction == 1 ? words_per_row : words_per_row * n_lines[1];
    const std::size_t n_direction = n_lines[direction];
    for (std::size_t plane = 0; plane < bits.size();
         plane += line * n_direction)
      {
        std::uint64_t *const m = bits.data() + plane;
        std::uint64_t *const d = dilated.data() + plane;
        for (std::size_t j = 0; j < n_direction; ++j)
          {
            const std::size_t first = j - std::min<std::size_t>(j, gap);
            std::copy_n(m + j * line, line, d + j * line);
            for (std::size_t i = first; i < j; ++i)
              for (std::size_t w = 0; w < line; ++w)
                d[j * line + w] |= m[i * line + w];
          }
        for (std::size_t j = 0; j + gap < n_direction; ++j)
          {
            // All of the next `gap` lines; d[j] is not needed any more.
            for (std::size_t i = j + 1; i <= j + gap; ++i)
              for (std::size_t w = 0; w < line; ++w)
                d[j * line + w] &= d[i * line + w];
            for (std::size_t w = 0; w < line; ++w)
              m[j * line + w] |= d[j * line + w];
          }
      }
  }



  template <int dim>
  void
  BlockCoverage<dim>::find_covered_blocks()
  {
    const int nz = dim == 3 ? n[dim - 1] : 1;
    covered.resize(std::size_t(n[0]) * n[1] * nz);
    unsigned char *block = covered.data();
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (std::size_t w = 0; w < words_per_row; ++w)
          {
            std::uint64_t all = ~std::uint64_t(0);
            for (int c = 0; c < (dim == 3 ? bits_per_block : 1); ++c)
              for (int b = 0; b < bits_per_block; ++b)
                all &=
                  bits[((std::size_t(k) * bits_per_block + c) * n_lines[1] +
                        j * bits_per_block + b) *
                         words_per_row +
                       w];
            constexpr int           per_word = 64 / bits_per_block;
            constexpr std::uint64_t full     = (1u << bits_per_block) - 1;
            const int end = std::min<int>(per_word, n[0] - per_word * int(w));
            for (int i = 0; i < end; ++i)
              *block++ = (all >> (bits_per_block * i) & full) == full;
          }
  }



  template class BlockCoverage<3>;
} // namespace Waker
