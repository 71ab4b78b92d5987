// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/boundary/box_union_contour.h>

#include <algorithm>
#include <limits>

namespace Waker
{
  void
  BoxUnionContour::trace(const std::vector<Box<2>> &boxes,
                         const BoxUnionRules<2>    &new_rules,
                         Surface                   &surface)
  {
    rules = new_rules;
    select(boxes);
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
  BoxUnionContour::select(const std::vector<Box<2>> &boxes)
  {
    swept.clear();
    if (rules.restricted)
      coverage.reinit(boxes, rules);
    const double left  = rules.minimum_gap[0];
    const double right = rules.symmetric ? left : 0.;
    for (const Box<2> &box : boxes)
      {
        if (rules.restricted)
          {
            Box<2> reach = box;
            reach.lower[0] -= left;
            reach.upper[0] += right;
            if (!coverage.touches_open_block(reach))
              continue;
          }
        swept.push_back(box);
        if (!cut_at_closed_faces(rules, swept.back()))
          swept.pop_back();
      }
    n_boxes = swept.size();

    if (rules.restricted)
      {
        coverage.append_covered_rows(swept);
        std::size_t n = n_boxes;
        for (std::size_t i = n_boxes; i < swept.size(); ++i)
          {
            swept[n] = swept[i];
            n += cut_at_closed_faces(rules, swept[n]);
          }
        swept.resize(n);
      }
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



  void
  BoxUnionContour::start_sweep()
  {
    const unsigned int n = y.size() - 1;
    segments.assign(n, Segment());
    active.reinit(n);
    active.insert(0);
    segments[0].next = n;
    chains.start(n);

    // The closed faces divide the slabs from the start.
    for (unsigned int f = 2; f < 4; ++f)
      if (rules.is_closed(f))
        open_breakpoint(faces[f]);
    const auto close_up = [&](const unsigned int r) {
      segments[r].n_covers = 1;
      segments[r].inside   = true;
    };
    if (rules.is_closed(2))
      close_up(0);
    if (rules.is_closed(3))
      close_up(faces[3]);
  }



  void
  BoxUnionContour::open_breakpoint(const unsigned int r)
  {
    if (!active.contains(r))
      {
        const unsigned int below = active.previous(r);
        segments[r]              = segments[below];
        segments[r].previous     = below;
        segments[r].n_edges      = 0;
        segments[below].next     = r;
        if (segments[r].next < segments.size())
          segments[segments[r].next].previous = r;
        active.insert(r);
      }
    ++segments[r].n_edges;
  }



  void
  BoxUnionContour::tidy_breakpoint(const unsigned int r)
  {
    const Segment &s = segments[r];
    if (r == 0 || s.n_edges > 0)
      return;
    Segment &below = segments[s.previous];
    if (below.inside != s.inside || below.before_filling != s.before_filling)
      return;
    below.next = s.next;
    if (s.next < segments.size())
      segments[s.next].previous = s.previous;
    active.erase(r);
  }



  void
  BoxUnionContour::apply(const unsigned int box, const Change change)
  {
    const bool extended = rules.minimum_gap[0] > 0.;
    int        boxes = 0, extensions = 0, covers = 0;
    bool       last = false;
    switch (change)
      {
        case extension_begins:
          extensions = 1;
          break;
        case extension_ends:
          extensions = -1;
          last       = true;
          break;
        case box_begins:
          boxes      = 1;
          extensions = extended ? -1 : 0;
          break;
        case box_ends:
          boxes = -1;
          last  = true;
          break;
        case cover_begins:
          covers = 1;
          break;
        case cover_ends:
          covers = -1;
          last   = true;
          break;
        default: // a face
          return;
      }

    const unsigned int begin   = y_ranks[2 * box];
    const unsigned int end     = y_ranks[2 * box + 1];
    bool               matters = false;
    for (unsigned int r = begin; r < end; r = segments[r].next)
      {
        Segment   &s      = segments[r];
        const bool before = s.n_boxes > 0;
        s.n_boxes += boxes;
        s.n_extensions += extensions;
        s.n_covers += covers;
        matters |= !(before && s.n_boxes > 0);
      }
    // Where a box stays, nothing changes.
    if (matters)
      changed.push_back({begin, end});
    if (last)
      for (const unsigned int r : {begin, end})
        if (--segments[r].n_edges == 0)
          released.push_back(r);
  }



  bool
  BoxUnionContour::is_solid(const Segment &s, const bool with_covers) const
  {
    const bool before =
      (rules.symmetric ? s.before_filling : s.inside) || at_left_face;
    return s.n_boxes > 0 || (s.n_extensions > 0 && before) ||
           (with_covers && s.n_covers > 0);
  }



  void
  BoxUnionContour::evaluate(const unsigned int x)
  {
    edges.clear();
    std::sort(changed.begin(),
              changed.end(),
              [](const Range &a, const Range &b) { return a.begin < b.begin; });

    // What is solid next to a change stays as it is. A run of other segments
    // may change up to its end, unless it is too high to be filled.
    const unsigned int n     = segments.size();
    const double       limit = rules.minimum_gap[1] + rules.tolerance;
    for (std::size_t c = 0; c < changed.size();)
      {
        Range  range  = changed[c];
        double height = 0.;
        while (range.begin > 0 && height <= limit)
          {
            const unsigned int below = segments[range.begin].previous;
            if (is_solid(segments[below]))
              break;
            height += y[range.begin] - y[below];
            range.begin = below;
          }

        height = 0.;
        while (true)
          {
            while (c < changed.size() && changed[c].begin <= range.end)
              {
                if (changed[c].end > range.end)
                  {
                    range.end = changed[c].end;
                    height    = 0.;
                  }
                ++c;
              }
            if (range.end == n || height > limit ||
                is_solid(segments[range.end]))
              break;
            const unsigned int above = segments[range.end].next;
            height += y[above] - y[range.end];
            range.end = above;
          }
        evaluate(x, range);
      }
    for (const unsigned int r : released)
      if (active.contains(r))
        tidy_breakpoint(r);
    released.clear();
    chains.add(edges);
  }



  void
  BoxUnionContour::evaluate(const unsigned int x, const Range &range)
  {
    const double limit =
      rules.minimum_gap[1] > 0. ? rules.minimum_gap[1] + rules.tolerance : 0.;
    const unsigned int no_run    = -1;
    unsigned int       run_begin = no_run;
    const auto         end_run   = [&](const unsigned int r) {
      if (run_begin != no_run && y[r] - y[run_begin] <= limit)
        for (unsigned int s = run_begin; s < r; s = segments[s].next)
          segments[s].now = true;
      run_begin = no_run;
    };
    for (unsigned int r = range.begin; r < range.end; r = segments[r].next)
      {
        Segment &s       = segments[r];
        s.now            = is_solid(s);
        s.before_filling = is_solid(s, false);
        if (s.now)
          end_run(r);
        else if (run_begin == no_run)
          run_begin = r;
      }
    end_run(range.end);

    // Vertical edges where the state changes.
    ContourChains::Edge *edge = nullptr;
    for (unsigned int r = range.begin, next; r < range.end; r = next)
      {
        Segment &s = segments[r];
        next       = s.next;
        if (s.now == s.inside)
          edge = nullptr;
        else if (edge != nullptr && edge->upwards == s.inside)
          edge->high = next;
        else
          {
            edges.push_back({x, r, next, s.inside});
            edge = &edges.back();
          }
        s.inside = s.now;
        tidy_breakpoint(r);
      }
    if (range.end < segments.size())
      tidy_breakpoint(range.end);
  }
} // namespace Waker
