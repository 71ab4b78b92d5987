// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/boundary/box_union_faces.h>

#include <algorithm>
#include <limits>

namespace Waker
{
  namespace
  {
    constexpr unsigned int none = std::numeric_limits<unsigned int>::max();
  }



  void
  BoxUnionFaces::find(const std::vector<Box<3>> &boxes,
                      const BoxUnionRules<3>    &new_rules,
                      Facets<3>                 &facets)
  {
    rules = new_rules;
    facets.clear();
    if (boxes.empty())
      return;
    select(boxes);
    rank_coordinates();
    list_boxes_by_block();

    const Index n = coverage.n_blocks();
    Index       block;
    for (block[2] = 0; block[2] < n[2]; ++block[2])
      for (block[1] = 0; block[1] < n[1]; ++block[1])
        for (block[0] = 0; block[0] < n[0]; ++block[0])
          {
            if (is_skipped(block))
              continue;
            lay_lattice(block);
            mark_inside(block);
            for (const unsigned int direction : {0, 2, 1})
              fill_gaps(direction);
            collect_faces(block, facets);
          }
  }



  void
  BoxUnionFaces::select(const std::vector<Box<3>> &boxes)
  {
    coverage.reinit(boxes, rules);
    coverage.open_blocks_at_closed_faces();
    selected.clear();
    for (const Box<3> &box : boxes)
      {
        Box<3> reach = box;
        reach.lower -= rules.minimum_gap;
        reach.upper += rules.minimum_gap;
        if (rules.restricted && !coverage.touches_open_block(reach))
          continue;
        selected.push_back(box);
        if (!cut_at_closed_faces(rules, selected.back()))
          selected.pop_back();
      }
  }



  void
  BoxUnionFaces::rank_coordinates()
  {
    const unsigned int n = selected.size();
    for (unsigned int d = 0; d < 3; ++d)
      {
        SnappedCoordinates &x = coordinates[d];
        x.clear();
        for (unsigned int i = 0; i < n; ++i)
          {
            x.add(selected[i].lower[d], 2 * i);
            x.add(selected[i].upper[d], 2 * i + 1);
          }
        const unsigned int n_lines = coverage.n_blocks()[d] + 1;
        for (unsigned int i = 0; i < n_lines; ++i)
          {
            Index block{};
            block[d] = i;
            x.add(coverage.block(block).lower[d], 2 * n + i);
          }
        // A closed face, and a place beyond it, so that there are cells there.
        const double block =
          coverage.block(Index{}).upper[d] - coverage.block(Index{}).lower[d];
        const unsigned int face_tag = 2 * n + n_lines;
        for (unsigned int f = 0; f < 2; ++f)
          if (rules.is_closed(2 * d + f))
            {
              const double place = f == 0 ? rules.lower[d] : rules.upper[d];
              x.add(place, face_tag + f);
              x.add(f == 0 ? place - block : place + block, face_tag + 2);
            }
        x.rank(rules.tolerance);

        box_ranks[d].resize(2 * n);
        block_lines[d].resize(n_lines);
        line_of_rank[d].resize(x.values.size());
        face_ranks[2 * d] = face_ranks[2 * d + 1] = none;
        for (const SnappedCoordinates::Entry &entry : x.sorted())
          if (entry.tag < 2 * n)
            box_ranks[d][entry.tag] = entry.rank;
          else if (entry.tag < face_tag)
            block_lines[d][entry.tag - 2 * n] = entry.rank;
          else if (entry.tag < face_tag + 2)
            {
              const unsigned int f  = entry.tag - face_tag;
              face_ranks[2 * d + f] = entry.rank;
              x.values[entry.rank]  = f == 0 ? rules.lower[d] : rules.upper[d];
            }
      }
  }



  std::size_t
  BoxUnionFaces::block_number(const Index &block) const
  {
    const Index &n = coverage.n_blocks();
    return (std::size_t(block[2]) * n[1] + block[1]) * n[0] + block[0];
  }



  void
  BoxUnionFaces::list_boxes_by_block()
  {
    const Index &n = coverage.n_blocks();
    list_begins.assign(std::size_t(n[0]) * n[1] * n[2] + 2, 0);
    const auto for_all_blocks = [&](const auto &visit) {
      for (unsigned int i = 0; i < selected.size(); ++i)
        {
          Box<3> reach = selected[i];
          reach.lower -= rules.minimum_gap;
          reach.upper += rules.minimum_gap;
          Index first;
          Index last;
          coverage.touched_blocks(reach, first, last);
          Index b = first;
          do
            {
              for (b[0] = first[0]; b[0] <= last[0]; ++b[0])
                if (!rules.restricted || !coverage.is_covered(b))
                  visit(block_number(b), i);
          } while (BlockCoverage<3>::next_row(first, last, b));
        }
    };
    // Two places on, so that filling the lists moves the beginnings to theirs.
    for_all_blocks(
      [&](const std::size_t b, const unsigned int) { ++list_begins[b + 2]; });
    for (std::size_t b = 2; b < list_begins.size(); ++b)
      list_begins[b] += list_begins[b - 1];
    lists.resize(list_begins.back());
    for_all_blocks([&](const std::size_t b, const unsigned int i) {
      lists[list_begins[b + 1]++] = i;
    });
  }



  bool
  BoxUnionFaces::is_skipped(const Index &block) const
  {
    for (unsigned int d = 0; d < 3; ++d)
      if (block[d] < 0 || block[d] >= coverage.n_blocks()[d])
        return true;
    const std::size_t b = block_number(block);
    return list_begins[b] == list_begins[b + 1];
  }



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
    strides = {{1,
                static_cast<unsigned int>(lines[0].size() - 1),
                static_cast<unsigned int>((lines[0].size() - 1) *
                                          (lines[1].size() - 1))}};
  }



  void
  BoxUnionFaces::mark_inside(const Index &block)
  {
    inside.assign(std::size_t(strides[2]) * (lines[2].size() - 1), 0);
    const auto mark = [&](const Ranks &begin, const Ranks &end) {
      for (unsigned int k = begin[2]; k < end[2]; ++k)
        for (unsigned int j = begin[1]; j < end[1]; ++j)
          for (unsigned int i = begin[0]; i < end[0]; ++i)
            inside[i + j * strides[1] + k * strides[2]] = 1;
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
  BoxUnionFaces::fill_gaps(const unsigned int direction)
  {
    if (rules.minimum_gap[direction] == 0.)
      return;
    const double       limit  = rules.minimum_gap[direction] + rules.tolerance;
    const auto        &x      = coordinates[direction].values;
    const auto        &l      = lines[direction];
    const unsigned int a      = (direction + 1) % 3;
    const unsigned int b      = (direction + 2) % 3;
    const unsigned int stride = strides[direction];
    const auto         is_filled_later = [&](const unsigned int d) {
      return d == 1 || (d == 2 && direction == 0);
    };
    // Only what the later directions and the faces need.
    const unsigned int begin_a = is_filled_later(a) ? 0 : near_begin[a];
    const unsigned int begin_b = is_filled_later(b) ? 0 : near_begin[b];
    const unsigned int end_a =
      is_filled_later(a) ? lines[a].size() - 1 : near_end[a];
    const unsigned int end_b =
      is_filled_later(b) ? lines[b].size() - 1 : near_end[b];
    for (unsigned int i = begin_a; i < end_a; ++i)
      for (unsigned int j = begin_b; j < end_b; ++j)
        {
          unsigned char *const row =
            inside.data() + i * strides[a] + j * strides[b];
          unsigned int last = none; // cell inside
          for (unsigned int k = 0; k + 1 < l.size(); ++k)
            {
              if (row[k * stride] == 0)
                continue;
              if (last != none && last + 1 < k &&
                  x[l[k]] - x[l[last + 1]] <= limit)
                for (unsigned int m = last + 1; m < k; ++m)
                  row[m * stride] = 1;
              last = k;
            }
        }
  }



  void
  BoxUnionFaces::collect_faces(const Index &block, Facets<3> &facets)
  {
    // A block collects the faces on its own lower sides, and those on an upper
    // one if nobody else does.
    for (unsigned int d = 0; d < 3; ++d)
      {
        Index next = block;
        ++next[d];
        const unsigned int end = block_end[d] + is_skipped(next);
        for (unsigned int line = block_begin[d]; line < end; ++line)
          collect_plane(d, line, facets);
      }
  }



  void
  BoxUnionFaces::collect_plane(const unsigned int direction,
                               const unsigned int line,
                               Facets<3>         &facets)
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

          Ranks lower;
          Ranks upper;
          lower[direction] = upper[direction] = lines[direction][line];
          lower[a]                            = lines[a][block_begin[a] + i];
          upper[a] = lines[a][block_begin[a] + i_end];
          lower[b] = lines[b][block_begin[b] + j];
          upper[b] = lines[b][block_begin[b] + j_end];
          add_rectangle(direction, lower, upper, sign > 0, facets);
        }
  }



  void
  BoxUnionFaces::add_rectangle(const unsigned int direction,
                               const Ranks       &lower,
                               const Ranks       &upper,
                               const bool         faces_up,
                               Facets<3>         &facets) const
  {
    const unsigned int a = (direction + 1) % 3;
    const unsigned int b = (direction + 2) % 3;
    const auto corner    = [&](const bool at_upper_a, const bool at_upper_b) {
      Point<3> x;
      x[direction] = coordinates[direction].values[lower[direction]];
      x[a]         = coordinates[a].values[at_upper_a ? upper[a] : lower[a]];
      x[b]         = coordinates[b].values[at_upper_b ? upper[b] : lower[b]];
      return x;
    };
    // Anticlockwise, seen from outside.
    const Point<3> first  = corner(false, false);
    const Point<3> second = corner(faces_up, !faces_up);
    const Point<3> third  = corner(true, true);
    const Point<3> fourth = corner(!faces_up, faces_up);

    const unsigned int face = 2 * direction + faces_up;
    const int          mark = lower[direction] == face_ranks[face] ? face : -1;
    facets.push_back(make_facet<3>({{first, second, third}}, mark));
    facets.push_back(make_facet<3>({{first, third, fourth}}, mark));
  }
} // namespace Waker
