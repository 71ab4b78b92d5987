// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The lattice of a block of BoxUnionFaces.
#include <waker/surface/boxes/box_union_faces.h>

#include <algorithm>

namespace Waker
{
  void
  BoxUnionFaces::lay_lattice(const Index &block)
  {
    const std::size_t b = block_number(block);
    for (unsigned int d = 0; d < 3; ++d)
      {
        // A gap that is to be filled ends within the reach; one line more shows
        // what ends it.
        const std::vector<double> &x     = coordinates[d].values;
        const unsigned int         begin = block_lines[d][block[d]];
        const unsigned int         end   = block_lines[d][block[d] + 1];
        const double reach  = rules.minimum_gap[d] + 2 * rules.tolerance;
        unsigned int lowest = begin, highest = end;
        while (lowest > 0 && x[lowest] >= x[begin] - reach)
          --lowest;
        while (highest + 1 < x.size() && x[highest] <= x[end] + reach)
          ++highest;

        std::vector<unsigned int> &l = lines[d];
        l.assign({lowest, begin, end, highest});
        for (std::size_t i = list_begins[b]; i < list_begins[b + 1]; ++i)
          for (unsigned int side = 0; side < 2; ++side)
            {
              const unsigned int r = box_ranks[d][2 * lists[i] + side];
              if (r > lowest && r < highest)
                l.push_back(r);
            }
        for (unsigned int side = 0; side < 2; ++side)
          {
            const unsigned int r = face_ranks[2 * d + side];
            if (r != none && r > lowest && r < highest)
              l.push_back(r);
          }
        std::sort(l.begin(), l.end());
        l.erase(std::unique(l.begin(), l.end()), l.end());
        for (unsigned int i = 0; i < l.size(); ++i)
          line_of_rank[d][l[i]] = i;

        block_begin[d] = line_of_rank[d][begin];
        block_end[d]   = line_of_rank[d][end];
        near_begin[d]  = block_begin[d] > 0 ? block_begin[d] - 1 : 0;
        near_end[d]    = std::min<unsigned int>(block_end[d] + 1, l.size() - 1);
        const auto face_line = [&](const unsigned int r) {
          return line_of_rank[d][std::min(std::max(r, lowest), highest)];
        };
        open_begin[d] =
          face_ranks[2 * d] == none ? 0 : face_line(face_ranks[2 * d]);
        open_end[d] = face_ranks[2 * d + 1] == none
                        ? l.size() - 1
                        : face_line(face_ranks[2 * d + 1]);
      }
    const unsigned int n_y = lines[1].size() - 1;
    const unsigned int n_x = lines[0].size() - 1;
    strides                = {{n_y, 1, n_y * n_x}};
  }



  void
  BoxUnionFaces::mark_inside(const Index &block)
  {
    const std::size_t n_x = lines[0].size() - 1;
    words_per_row         = (lines[1].size() + 62) / 64;
    bits.assign(words_per_row * n_x * (lines[2].size() - 1), 0);
    const auto mark = [&](const Ranks &begin, const Ranks &end) {
      for (unsigned int first = begin[1]; first < end[1];)
        {
          // What lies in one word.
          const unsigned int  word = first / 64;
          const unsigned int  last = std::min(end[1], 64 * (word + 1)) - 1;
          const std::uint64_t mask = ~std::uint64_t(0) << first % 64 &
                                     ~std::uint64_t(0) >> (63 - last % 64);
          for (unsigned int k = begin[2]; k < end[2]; ++k)
            for (unsigned int i = begin[0]; i < end[0]; ++i)
              bits[(k * n_x + i) * words_per_row + word] |= mask;
          first = last + 1;
        }
    };

    const std::size_t b = block_number(block);
    for (std::size_t i = list_begins[b]; i < list_begins[b + 1]; ++i)
      {
        Ranks begin;
        Ranks end;
        for (unsigned int d = 0; d < 3; ++d)
          {
            const std::vector<unsigned int> &r     = box_ranks[d];
            const unsigned int               lower = r[2 * lists[i]];
            const unsigned int               upper = r[2 * lists[i] + 1];
            begin[d] = line_of_rank[d][std::max(lower, lines[d].front())];
            end[d]   = line_of_rank[d][std::min(upper, lines[d].back())];
          }
        mark(begin, end);
      }

    // Beyond closed faces.
    Ranks all;
    for (unsigned int d = 0; d < 3; ++d)
      all[d] = lines[d].size() - 1;
    for (unsigned int d = 0; d < 3; ++d)
      {
        Ranks end   = all;
        Ranks begin = {{0, 0, 0}};
        end[d]      = open_begin[d];
        mark(begin, end);
        begin[d] = open_end[d];
        mark(begin, all);
      }
  }



  void
  BoxUnionFaces::fill_rows(const unsigned int direction)
  {
    if (rules.minimum_gap[direction] == 0.)
      return;
    const double limit = rules.minimum_gap[direction] + rules.tolerance;
    const auto  &x     = coordinates[direction].values;
    const auto  &l     = lines[direction];

    // Along z, only what the faces need.
    const unsigned int other = 2 - direction;
    const unsigned int begin = direction == 0 ? 0 : near_begin[other];
    const unsigned int end =
      direction == 0 ? lines[other].size() - 1 : near_end[other];
    const std::size_t stride_x = words_per_row;
    const std::size_t stride_z = words_per_row * (lines[0].size() - 1);
    const std::size_t stride   = direction == 0 ? stride_x : stride_z;
    const std::size_t across   = direction == 0 ? stride_z : stride_x;

    // How far the gap behind each cell may reach.
    reaches.resize(l.size());
    for (unsigned int a = 0, b = 0; a + 1 < l.size(); ++a)
      {
        while (b + 2 < l.size() && x[l[b + 1]] - x[l[a + 1]] <= limit)
          ++b;
        reaches[a] = b;
      }
    for (unsigned int i = begin; i < end; ++i)
      for (std::size_t w = 0; w < words_per_row; ++w)
        {
          std::uint64_t *const cells = bits.data() + i * across + w;
          for (unsigned int a = 0; a + 2 < l.size(); ++a)
            {
              const std::uint64_t below = cells[a * stride];
              if (below == 0)
                continue;
              // Cell b - 1 is filled if something lies at b or further.
              std::uint64_t above = 0;
              for (unsigned int b = reaches[a]; b > a + 1; --b)
                {
                  above |= cells[b * stride];
                  cells[(b - 1) * stride] |= below & above;
                }
            }
        }
  }



  void
  BoxUnionFaces::fill_along_y()
  {
    const double limit =
      rules.minimum_gap[1] > 0. ? rules.minimum_gap[1] + rules.tolerance : 0.;
    const auto &y = coordinates[1].values;
    const auto &l = lines[1];
    inside.resize(std::size_t(strides[2]) * (lines[2].size() - 1));
    for (unsigned int k = near_begin[2]; k < near_end[2]; ++k)
      for (unsigned int i = near_begin[0]; i < near_end[0]; ++i)
        {
          unsigned char *const cells =
            inside.data() + i * strides[0] + k * strides[2];
          const std::uint64_t *const row =
            bits.data() + (k * (lines[0].size() - 1) + i) * words_per_row;
          for (unsigned int j = 0; j + 1 < l.size(); ++j)
            cells[j] = row[j / 64] >> (j % 64) & 1u;
          unsigned int last = none; // cell inside
          for (unsigned int j = 0; j + 1 < l.size(); ++j)
            {
              if (cells[j] == 0)
                continue;
              if (last != none && last + 1 < j &&
                  y[l[j]] - y[l[last + 1]] <= limit)
                std::fill(cells + last + 1, cells + j, 1);
              last = j;
            }
        }
  }



  void
  BoxUnionFaces::collect_faces(const Index            &block,
                               std::vector<Rectangle> &rectangles)
  {
    // A block collects the faces on its own lower sides, and those on an upper
    // one if nobody else does.
    for (unsigned int d = 0; d < 3; ++d)
      {
        Index next = block;
        ++next[d];
        const unsigned int end = block_end[d] + is_skipped(next);
        for (unsigned int line = block_begin[d]; line < end; ++line)
          collect_plane(block, d, line, rectangles);
      }
  }



  void
  BoxUnionFaces::collect_plane(const Index            &block,
                               const unsigned int      direction,
                               const unsigned int      line,
                               std::vector<Rectangle> &rectangles)
  {
    const unsigned int a       = (direction + 1) % 3;
    const unsigned int b       = (direction + 2) % 3;
    const unsigned int n_cells = lines[direction].size() - 1;
    const auto is_body = [&](const std::size_t row, const unsigned int k) {
      return k < n_cells && k >= open_begin[direction] &&
             k < open_end[direction] && inside[row + k * strides[direction]];
    };

    // +1: the body is below the plane, -1: above.
    const unsigned int na = block_end[a] - block_begin[a];
    const unsigned int nb = block_end[b] - block_begin[b];
    plane.assign(std::size_t(na) * nb, 0);
    for (unsigned int j = 0; j < nb; ++j)
      for (unsigned int i = 0; i < na; ++i)
        {
          const unsigned int ia = block_begin[a] + i;
          const unsigned int ib = block_begin[b] + j;
          if (ia < open_begin[a] || ia >= open_end[a] || ib < open_begin[b] ||
              ib >= open_end[b])
            continue;
          const std::size_t row   = ia * strides[a] + ib * strides[b];
          const bool        below = is_body(row, line - 1u);
          const bool        above = is_body(row, line);
          plane[j * na + i]       = static_cast<signed char>(below) - above;
        }

    for (unsigned int j = 0; j < nb; ++j)
      for (unsigned int i = 0; i < na; ++i)
        {
          const signed char sign = plane[j * na + i];
          if (sign == 0)
            continue;
          // As far as it goes along a, then along b.
          unsigned int i_end = i + 1;
          while (i_end < na && plane[j * na + i_end] == sign)
            ++i_end;
          const auto   same  = [&](const signed char s) { return s == sign; };
          unsigned int j_end = j + 1;
          while (j_end < nb && std::all_of(plane.begin() + j_end * na + i,
                                           plane.begin() + j_end * na + i_end,
                                           same))
            ++j_end;
          for (unsigned int m = j; m < j_end; ++m)
            std::fill(plane.begin() + m * na + i,
                      plane.begin() + m * na + i_end,
                      0);

          Rectangle rectangle;
          rectangle.block         = coverage.number_of_all(block);
          rectangle.direction     = direction;
          rectangle.faces_up      = sign > 0 ? 1 : 0;
          const unsigned int r    = lines[direction][line];
          const unsigned int face = 2 * direction + rectangle.faces_up;
          const auto place = [&](const unsigned int d, const unsigned int l) {
            return coordinates[d].values[lines[d][block_begin[d] + l]];
          };
          rectangle.on_face = r == face_ranks[face] ? face : -1;
          rectangle.place   = coordinates[direction].values[r];
          rectangle.lower   = {{place(a, i), place(b, j)}};
          rectangle.upper   = {{place(a, i_end), place(b, j_end)}};
          rectangles.push_back(rectangle);
        }
  }
} // namespace Waker
