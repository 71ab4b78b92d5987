// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/boxes/box_union_faces.h>

#include <algorithm>

namespace Waker
{
  void
  BoxUnionFaces::find(const std::vector<Box<3>> &boxes,
                      const BoxUnionRules<3>    &new_rules,
                      Facets<3>                 &facets)
  {
    find(boxes, new_rules, extents_of(boxes), Share(), found);
    to_facets(found, facets);
  }



  void
  BoxUnionFaces::find(const std::vector<Box<3>> &boxes,
                      const BoxUnionRules<3>    &new_rules,
                      const BoxExtents<3>       &all,
                      const Share               &share,
                      std::vector<Rectangle>    &rectangles)
  {
    rules = new_rules;
    rectangles.clear();
    if (all.n == 0.)
      return;
    select(boxes, all);
    find_heard(share);
    rank_coordinates(share);
    list_boxes_by_block();

    const Index n = coverage.n_blocks();
    Index       block;
    for (block[2] = 0; block[2] < n[2]; ++block[2])
      for (block[1] = 0; block[1] < n[1]; ++block[1])
        for (block[0] = 0; block[0] < n[0]; ++block[0])
          {
            if (is_skipped(block))
              continue;
            const Box<3> place = coverage.block(block);
            if (share.has &&
                !share.has(place.lower + 0.5 * (place.upper - place.lower)))
              continue;
            lay_lattice(block);
            mark_inside(block);
            fill_rows(0);
            fill_rows(2);
            fill_along_y();
            collect_faces(block, rectangles);
          }
  }



  double
  BoxUnionFaces::reach(const BoxUnionRules<3> &rules, const BoxExtents<3> &all)
  {
    // Its own faces need what comes nearer to the block than a gap; whether
    // there is one on the next block's side, what does so to that.
    const Tensor<1, 3> block = BlockCoverage<3>::block_extent(rules, all);
    double             most  = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      most = std::max(most, 1.5 * block[d] + rules.minimum_gap[d]);
    return most + 4. * rules.tolerance;
  }



  void
  BoxUnionFaces::to_facets(const std::vector<Rectangle> &rectangles,
                           Facets<3>                    &facets)
  {
    facets.clear();
    for (const Rectangle &rectangle : rectangles)
      {
        const unsigned int a = (rectangle.direction + 1) % 3;
        const unsigned int b = (rectangle.direction + 2) % 3;
        const auto corner    = [&](const bool upper_a, const bool upper_b) {
          Point<3> x;
          x[rectangle.direction] = rectangle.place;
          x[a] = upper_a ? rectangle.upper[0] : rectangle.lower[0];
          x[b] = upper_b ? rectangle.upper[1] : rectangle.lower[1];
          return x;
        };
        // Anticlockwise, seen from outside.
        const bool     faces_up = rectangle.faces_up != 0;
        const Point<3> first    = corner(false, false);
        const Point<3> second   = corner(faces_up, !faces_up);
        const Point<3> third    = corner(true, true);
        const Point<3> fourth   = corner(!faces_up, faces_up);
        facets.push_back(
          make_facet<3>({{first, second, third}}, rectangle.on_face));
        facets.push_back(
          make_facet<3>({{first, third, fourth}}, rectangle.on_face));
      }
  }



  void
  BoxUnionFaces::select(const std::vector<Box<3>> &boxes,
                        const BoxExtents<3>       &all)
  {
    coverage.reinit(boxes, rules, all);
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
  BoxUnionFaces::find_heard(const Share &share)
  {
    is_heard.assign(selected.size(), share.has ? 0 : 1);
    if (!share.has)
      return;
    for (std::size_t i = 0; i < selected.size(); ++i)
      {
        Box<3> reach = selected[i];
        reach.lower -= rules.minimum_gap;
        reach.upper += rules.minimum_gap;
        Index first, last;
        coverage.touched_blocks(reach, first, last);
        Index b = first;
        do
          {
            for (b[0] = first[0]; b[0] <= last[0] && !is_heard[i]; ++b[0])
              if (!rules.restricted || !coverage.is_covered(b))
                {
                  const Box<3> place = coverage.block(b);
                  is_heard[i] =
                    share.has(place.lower + 0.5 * (place.upper - place.lower));
                }
        } while (!is_heard[i] && BlockCoverage<3>::next_row(first, last, b));
      }
  }



  void
  BoxUnionFaces::add_coordinates_of_all(const unsigned int d,
                                        const Share       &share,
                                        const unsigned int tag)
  {
    if (!share.tell_all)
      return;
    told.clear();
    for (std::size_t i = 0; i < selected.size(); ++i)
      if (is_heard[i])
        {
          told.push_back(selected[i].lower[d]);
          told.push_back(selected[i].upper[d]);
        }
    // Of those closer to each other than the tolerance as many as hold the rest
    // together.
    std::sort(told.begin(), told.end());
    std::size_t n = 0;
    for (std::size_t i = 0; i < told.size(); ++i)
      if (n == 0 || i + 1 == told.size() ||
          told[i + 1] - told[n - 1] > rules.tolerance)
        told[n++] = told[i];
    told.resize(n);
    share.tell_all(told);
    for (const double x : told)
      coordinates[d].add(x, tag);
  }



  void
  BoxUnionFaces::rank_coordinates(const Share &share)
  {
    const unsigned int n = selected.size();
    for (unsigned int d = 0; d < 3; ++d)
      {
        SnappedCoordinates &x = coordinates[d];
        x.clear();
        for (unsigned int i = 0; i < n; ++i)
          if (is_heard[i])
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
        add_coordinates_of_all(d, share, face_tag + 2);
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
} // namespace Waker
