// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/surface/boxes/box_union_contour.h>

#include <algorithm>
#include <limits>

namespace Waker
{
  void
  BoxUnionContour::trace(const Visible          &of_all,
                         const BoxUnionRules<2> &new_rules,
                         Surface                &surface)
  {
    rules = new_rules;
    select(of_all);
    rank_coordinates();
    start_sweep();

    const std::vector<SnappedCoordinates::Entry> &events =
      x_coordinates.sorted();
    for (std::size_t first = 0, last = 0; first < events.size(); first = last)
      {
        const unsigned int x = events[first].rank;
        while (last < events.size() && events[last].rank == x)
          ++last;
        at_left_face = x == faces[0];
        changed.clear();
        for (std::size_t e = first; e < last; ++e)
          {
            const unsigned int change = events[e].tag % n_changes;
            const unsigned int box    = events[e].tag / n_changes;
            if (change == extension_begins || change == cover_begins ||
                (change == box_begins && rules.minimum_gap[0] == 0.))
              for (unsigned int end = 0; end < 2; ++end)
                open_breakpoint(y_ranks[2 * box + end]);
          }
        for (std::size_t e = first; e < last; ++e)
          apply(events[e].tag / n_changes, Change(events[e].tag % n_changes));
        evaluate(x);
      }
    chains.finish(x_coordinates.values, y, faces, surface);
  }



  void
  BoxUnionContour::find_visible(const std::vector<Box<2>> &boxes,
                                const BoxUnionRules<2>    &of_boxes,
                                const BoxExtents<2>       &all,
                                Visible                   &found,
                                const NodeExchange *const  ranks)
  {
    found.covered.clear();
    if (!of_boxes.restricted)
      {
        found.boxes = boxes;
        return;
      }
    found.boxes.clear();
    coverage.reinit(boxes, of_boxes, all, ranks);
    coverage.find_open(near_surface);
    for (const unsigned int i : near_surface)
      found.boxes.push_back(boxes[i]);
    coverage.append_covered_rows(found.covered);
  }



  void
  BoxUnionContour::select(const Visible &of_all)
  {
    const auto add = [this](const Box<2> &box) {
      swept.push_back(box);
      if (!cut_at_closed_faces(rules, swept.back()))
        swept.pop_back();
    };
    swept.clear();
    for (const Box<2> &box : of_all.boxes)
      add(box);
    n_boxes = swept.size();
    for (const Box<2> &row : of_all.covered)
      add(row);
  }



  void
  BoxUnionContour::rank_coordinates()
  {
    const unsigned int n   = swept.size();
    const double       gap = rules.minimum_gap[0];
    const auto add_face    = [&](SnappedCoordinates &x, const unsigned int f) {
      if (rules.is_closed(f))
        x.add(f % 2 == 0 ? rules.lower[f / 2] : rules.upper[f / 2],
              -1u - f % 2);
    };

    y_coordinates.clear();
    for (unsigned int i = 0; i < n; ++i)
      {
        y_coordinates.add(swept[i].lower[1], 2 * i);
        y_coordinates.add(swept[i].upper[1], 2 * i + 1);
      }
    add_face(y_coordinates, 2);
    add_face(y_coordinates, 3);
    y_coordinates.rank(rules.tolerance);

    // Rank 0 is what lies below all.
    const double infinity = std::numeric_limits<double>::infinity();
    y.assign(1, -infinity);
    y.insert(y.end(), y_coordinates.values.begin(), y_coordinates.values.end());
    y.push_back(infinity);
    y_ranks.resize(2 * n + 2);
    faces.fill(ContourChains::no_face);
    for (const SnappedCoordinates::Entry &entry : y_coordinates.sorted())
      if (entry.tag < 2 * n)
        y_ranks[entry.tag] = entry.rank + 1;
      else
        {
          const unsigned int f = -1u - entry.tag;
          faces[2 + f]         = entry.rank + 1;
          y[entry.rank + 1]    = f == 0 ? rules.lower[1] : rules.upper[1];
        }

    x_coordinates.clear();
    for (unsigned int i = 0; i < n; ++i)
      {
        const bool   is_box = i < n_boxes;
        double       begin  = swept[i].lower[0];
        const double end    = swept[i].upper[0];
        x_coordinates.add(begin,
                          n_changes * i + (is_box ? box_begins : cover_begins));
        x_coordinates.add(end,
                          n_changes * i + (is_box ? box_ends : cover_ends));
        if (is_box && gap > 0.)
          {
            begin -= gap;
            if (rules.is_closed(0))
              begin = std::max(begin, rules.lower[0]);
            x_coordinates.add(begin, n_changes * i + extension_begins);
          }
      }
    add_face(x_coordinates, 0);
    add_face(x_coordinates, 1);
    if (rules.is_closed(1) && gap > 0. && n > 0)
      {
        // What lies beyond the right face extends to the left too.
        y_ranks[2 * n]     = 1;
        y_ranks[2 * n + 1] = y.size() - 2;
        x_coordinates.add(rules.upper[0] - gap,
                          n_changes * n + extension_begins);
        x_coordinates.add(rules.upper[0], n_changes * n + extension_ends);
      }
    x_coordinates.rank(rules.tolerance);
    for (const SnappedCoordinates::Entry &entry : x_coordinates.sorted())
      if (entry.tag >= -2u)
        {
          const unsigned int f = -1u - entry.tag;
          faces[f]             = entry.rank;
          x_coordinates.values[entry.rank] =
            f == 0 ? rules.lower[0] : rules.upper[0];
        }
  }
} // namespace Waker
