// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/boxes/box_union_plane_coverage.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  void
  PlaneCoverage::reinit(const std::vector<Box<2>> &boxes,
                        const BoxUnionRules<2>    &new_rules,
                        const BoxExtents<2>       &all,
                        const NodeExchange *const  the_ranks)
  {
    rules = new_rules;
    ranks = the_ranks;
    choose_lattice(all);
    find_cells(boxes);
    mark_cells();
    raster.close_y(gap[1]);
    find_covered_blocks();
  }



  void
  PlaneCoverage::choose_lattice(const BoxExtents<2> &all)
  {
    Point<2>     lower    = all.lower;
    Point<2>     upper    = all.upper;
    Tensor<1, 2> smallest = all.smallest;
    if (all.n == 0.)
      {
        lower = upper = Point<2>();
        smallest[0] = smallest[1] = 1.;
      }

    for (unsigned int d = 0; d < 2; ++d)
      cell[d] = smallest[d] / block_size[d];
    // Few tiny boxes among large ones must not cost memory.
    const double max_words = 4096. + 16. * all.n;
    for (bool fits = false; !fits;)
      {
        double n_words = 1.;
        for (unsigned int d = 0; d < 2; ++d)
          {
            // Lines of blocks on a lattice through rules.lower, with blocks to
            // spare at either end for a gap between a box and a closed face.
            const double block = block_size[d] * cell[d];
            const double spare = 2. + std::floor(rules.minimum_gap[d] / block);
            const double first =
              std::floor((lower[d] - rules.lower[d]) / block) - spare;
            origin[d] = rules.lower[d] + first * block;
            const double n =
              std::min(std::ceil((upper[d] - origin[d]) / block) + spare, 1e6);
            n_blocks[d] = static_cast<int>(n);
            n_words *= d == 0 ? BitRaster::words(n_blocks[0] * block_size[0])
                              : n * block_size[1];
          }
        fits = n_words <= max_words;
        if (!fits)
          cell *= 2.;
      }
    raster.reinit(n_blocks[0] * block_size[0], n_blocks[1] * block_size[1]);

    for (unsigned int d = 0; d < 2; ++d)
      {
        // One less than the extent, wherever it lies.
        mark[d] =
          std::max(static_cast<int>(smallest[d] / cell[d] + 1e-6) - 1, 1);
        gap[d] = static_cast<unsigned int>(
          (rules.minimum_gap[d] + 0.5 * rules.tolerance) / cell[d]);
        large[d] = 4 * mark[d] + 1;
      }
  }



  void
  PlaneCoverage::find_cells(const std::vector<Box<2>> &boxes)
  {
    // A bit may reach beyond its box by half the tolerance: the gap that it
    // then hides has the width of the tolerance at most, and is none.
    double from[2], to[2], inverse[2];
    for (unsigned int d = 0; d < 2; ++d)
      {
        inverse[d] = 1. / cell[d];
        const double slack =
          std::min(0.5 * rules.tolerance * inverse[d], 0.01) * cell[d];
        from[d] = origin[d] + slack;
        to[d]   = origin[d] - slack;
      }
    const std::size_t n = boxes.size();
    cells.resize(n);
    const Box<2> *const __restrict in = boxes.data();
    Cells *const __restrict out       = cells.data();
    for (std::size_t i = 0; i < n; ++i)
      {
        // The origin lies below all boxes: no negative numbers, so that
        // truncation is the floor. The ceiling is one more, also for a number
        // that is whole: on the open side.
        out[i].begin_x =
          static_cast<int>((in[i].lower[0] - from[0]) * inverse[0]) + 1;
        out[i].begin_y =
          static_cast<int>((in[i].lower[1] - from[1]) * inverse[1]) + 1;
        out[i].end_x = static_cast<int>((in[i].upper[0] - to[0]) * inverse[0]);
        out[i].end_y = static_cast<int>((in[i].upper[1] - to[1]) * inverse[1]);
      }
  }



  void
  PlaneCoverage::mark_cells()
  {
    std::vector<Cells> large_ones;
    longest = 0;
    for (const Cells &c : cells)
      {
        if (is_large(c))
          {
            large_ones.push_back(c);
            continue;
          }
        longest = std::max(longest, c.end_x - c.begin_x);
        // In pieces of the smallest box's extent that overlap.
        const int last_x = c.end_x - mark[0];
        const int last_y = c.end_y - mark[1];
        for (int y = c.begin_y; y <= last_y; y = std::min(y + mark[1], last_y))
          {
            for (int x = c.begin_x; x <= last_x;
                 x     = std::min(x + mark[0], last_x))
              {
                    raster.set(x, y);
                    if (x == last_x)
                  break;
              }
            if (y == last_y)
              break;
          }
      }
    if (ranks != nullptr)
      {
        longest =
          static_cast<int>(ranks->largest(static_cast<double>(longest)));
        large_ones = ranks->all_gather(large_ones);
      }
    unite_marks();
    raster.dilate_y(mark[1] - 1);

    // Along x the marks and the gaps are closed in one go; what is marked in
    // full takes part as if it had been dilated for the gaps.
    const auto n_columns = n_blocks[0] * block_size[0];
    if (large_ones.empty() && (rules.closed_faces & 15u) == 0)
      {
        raster.dilate_and_erode_x(mark[0] - 1 + gap[0], gap[0]);
        return;
      }
    raster.dilate_x(mark[0] - 1, 0);
    for (const Cells &c : large_ones)
      for (int y = c.begin_y; y < c.end_y; ++y)
        raster.set(c.begin_x, std::min(c.end_x, n_columns), y);
    mark_beyond_closed_faces();
    raster.dilate_and_erode_x(gap[0], gap[0]);
  }



  void
  PlaneCoverage::mark_beyond_closed_faces()
  {
    const std::array<int, 2> n_all = {
      {n_blocks[0] * block_size[0], n_blocks[1] * block_size[1]}};
    for (unsigned int face = 0; face < 4; ++face)
      {
        if (!rules.is_closed(face))
          continue;
        const unsigned int d = face / 2;
        const double place   = face % 2 == 0 ? rules.lower[d] : rules.upper[d];
        const double line    = (place - origin[d]) / cell[d];
        const double slack   = 0.5 * rules.tolerance / cell[d];

        std::array<int, 2> begin = {{0, 0}};
        std::array<int, 2> end   = n_all;
        const double       limit = n_all[d];
        if (face % 2 == 0)
          end[d] = std::floor(std::min(std::max(line + slack, 0.), limit));
        else
          begin[d] = std::ceil(std::min(std::max(line - slack, 0.), limit));
        for (int j = begin[1]; j < end[1]; ++j)
          raster.set(begin[0], end[0], j);
      }
  }



  void
  PlaneCoverage::find_covered_blocks()
  {
    constexpr Word lowest = 0x0101010101010101;
    covered.reinit(n_blocks[0] * block_size[0], n_blocks[1]);
    const std::size_t n = raster.words_per_row();
    for (int j = 0; j < n_blocks[1]; ++j)
      {
        Word *const       all  = covered.row(j);
        const Word *const rows = raster.row(j * block_size[1]);
        for (std::size_t w = 0; w < n; ++w)
          {
            Word a = rows[w];
            for (int b = 1; b < block_size[1]; ++b)
              a &= rows[b * n + w];
            a &= a >> 4;
            a &= a >> 2;
            a &= a >> 1;
            all[w] = (a & lowest) * 255;
          }
      }
  }



  void
  PlaneCoverage::find_open(std::vector<unsigned int> &numbers)
  {
    // The blocks that are searched. Those that merely touch a closed face are
    // not.
    int first[2], last[2];
    for (unsigned int d = 0; d < 2; ++d)
      {
        const double block = block_size[d] * cell[d];
        first[d]           = 0;
        last[d]            = n_blocks[d] - 1;
        if (rules.is_closed(2 * d))
          first[d] = static_cast<int>(
            std::max(rules.lower[d] + 2 * rules.tolerance - origin[d], 0.) /
            block);
        if (rules.is_closed(2 * d + 1))
          last[d] = static_cast<int>(std::min(
            std::floor((rules.upper[d] - 2 * rules.tolerance - origin[d]) /
                       block),
            last[d] + 0.));
      }

    open.reinit(n_blocks[0] * block_size[0], n_blocks[1]);
    for (int j = first[1]; j <= last[1]; ++j)
      {
        open.set(first[0] * block_size[0], (last[0] + 1) * block_size[0], j);
        for (std::size_t w = 0; w < open.words_per_row(); ++w)
          open.row(j)[w] &= ~covered.row(j)[w];
      }

    // The lowest cells of the boxes that reach them: a box touches the cells
    // from begin - 1 to end, and its extensions more.
    const int gap_cells =
      static_cast<int>(std::ceil(rules.minimum_gap[0] / cell[0]));
    open.dilate_x(gap_cells + 1, longest + (rules.symmetric ? gap_cells : 0));

    const std::size_t n   = cells.size();
    const int         top = n_blocks[1] - 1;
    numbers.resize(n);
    std::size_t n_open = 0;
    for (std::size_t i = 0; i < n; ++i)
      {
        const Cells &c     = cells[i];
        const int    begin = (c.begin_y - 1) / block_size[1];
        const int    end   = std::min(c.end_y / block_size[1], top);
        bool touches = open.test(c.begin_x, begin) | open.test(c.begin_x, end);
        for (int j = begin + 1; j < end; ++j)
          touches |= open.test(c.begin_x, j);
        // Without a branch: nobody can predict it.
        numbers[n_open] = i;
        n_open += touches | is_large(c);
      }
    numbers.resize(n_open);
  }



  void
  PlaneCoverage::append_covered_rows(std::vector<Box<2>> &rows) const
  {
    const double width  = block_size[0] * cell[0];
    const double height = block_size[1] * cell[1];
    const int    n      = n_blocks[0] * block_size[0];
    for (int j = 0; j < n_blocks[1]; ++j)
      {
        const Word *const row = covered.row(j);
        // The next place from i on where the bits are not those of `value`.
        const auto skip = [&](int i, const Word value) {
          while (i < n)
            {
              const Word rest = (row[i >> 6] ^ value) >> (i & 63);
              if (rest != 0)
                return std::min(i + __builtin_ctzll(rest), n);
              i = (i | 63) + 1;
            }
          return n;
        };
        for (int i = skip(0, 0); i < n;)
          {
            const int end = skip(i, ~Word(0));
            Box<2>    box;
            box.lower = Point<2>(origin[0] + i / block_size[0] * width,
                                 origin[1] + j * height);
            box.upper = Point<2>(origin[0] + end / block_size[0] * width,
                                 origin[1] + (j + 1) * height);
            rows.push_back(box);
            i = skip(end, 0);
          }
      }
  }
  void
  PlaneCoverage::unite_marks()
  {
    if (ranks == nullptr)
      return;
    struct Told
    {
      std::uint64_t place, word;
    };
    std::vector<Told> told;
    Word *const       words = raster.row(0);
    const std::size_t n = raster.words_per_row() * n_blocks[1] * block_size[1];
    for (std::size_t k = 0; k < n; ++k)
      if (words[k] != 0)
        told.push_back({k, words[k]});
    told = ranks->all_gather(told);
    for (const Told &one : told)
      words[one.place] |= one.word;
  }
} // namespace Waker
