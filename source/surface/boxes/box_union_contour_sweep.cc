// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The slabs of BoxUnionContour.
#include <waker/surface/boxes/box_union_contour.h>

#include <algorithm>

namespace Waker
{
  void
  BoxUnionContour::start_sweep()
  {
    const unsigned int n = y.size() - 1;
    segments.resize(n + 1);
    for (unsigned int r = 0; r <= n; ++r)
      segments[r].y = y[r];
    segments[0]   = Segment();
    segments[0].y = y[0];
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
        const unsigned int below            = active.previous(r);
        const double       place            = segments[r].y;
        segments[r]                         = segments[below];
        segments[r].y                       = place;
        segments[r].previous                = below;
        segments[r].n_edges                 = 0;
        segments[below].next                = r;
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
    below.next                = s.next;
    segments[s.next].previous = s.previous;
    active.erase(r);
  }



  void
  BoxUnionContour::apply(const unsigned int box, const Change change)
  {
    if (change > extension_ends) // a face
      return;
    const unsigned int begin   = y_ranks[2 * box];
    const unsigned int end     = y_ranks[2 * box + 1];
    bool               matters = false;
    const auto         for_all = [&](const auto &change_segment) {
      for (unsigned int r = begin; r < end; r = segments[r].next)
        matters |= change_segment(segments[r]);
    };
    // What is inside only because its run is filled stays so when it becomes
    // solid. So a beginning matters where nothing was inside, an end where
    // neither a rectangle nor an extension is left. The events at one x come in
    // any order: who leaves nothing counts too.
    const auto is_left = [](const Segment &s) {
      return s.n_boxes > 0 || s.n_extensions > 0;
    };
    switch (change)
      {
        case extension_begins:
          for_all([&](Segment &s) {
            ++s.n_extensions;
            return at_left_face || s.n_extensions <= 0;
          });
          break;
        case extension_ends:
          for_all([&](Segment &s) {
            --s.n_extensions;
            return !is_left(s);
          });
          break;
        case box_begins:
          {
            const int  extension = rules.minimum_gap[0] > 0. ? 1 : 0;
            const bool symmetric = rules.symmetric;
            for_all([=](Segment &s) {
              const bool was_solid =
                extension ? s.inside && (!symmetric || s.before_filling)
                          : s.n_boxes > 0;
              ++s.n_boxes;
              s.n_extensions -= extension;
              return !was_solid || s.n_boxes <= 0;
            });
            break;
          }
        case box_ends:
          for_all([&](Segment &s) {
            --s.n_boxes;
            return !is_left(s);
          });
          break;
        case cover_begins:
          for_all([](Segment &s) {
            ++s.n_covers;
            return true;
          });
          break;
        case cover_ends:
          for_all([](Segment &s) {
            --s.n_covers;
            return s.n_boxes <= 0;
          });
          break;
      }
    if (matters)
      changed.push_back({begin, end});
    if (change == box_ends || change == cover_ends || change == extension_ends)
      for (const unsigned int r : {begin, end})
        if (--segments[r].n_edges == 0)
          released.push_back(r);
  }



  void
  BoxUnionContour::evaluate(const unsigned int x)
  {
    edges.clear();
    if (changed.size() > 1)
      std::sort(changed.begin(),
                changed.end(),
                [](const Range &a, const Range &b) {
                  return a.begin < b.begin;
                });

    // What is solid next to a change stays as it is. A run of other segments
    // may change up to its end, unless it is too high to be filled.
    const unsigned int n     = segments.size() - 1;
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
            height += segments[range.begin].y - segments[below].y;
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
            height += segments[above].y - segments[range.end].y;
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
      if (run_begin != no_run && segments[r].y - segments[run_begin].y <= limit)
        for (unsigned int s = run_begin; s < r; s = segments[s].next)
          segments[s].now = true;
      run_begin = no_run;
    };
    for (unsigned int r = range.begin; r < range.end; r = segments[r].next)
      {
        Segment &s       = segments[r];
        s.now            = is_solid(s);
        s.before_filling = rules.symmetric && is_solid_without_covers(s);
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
    if (range.end + 1 < segments.size())
      tidy_breakpoint(range.end);
  }
} // namespace Waker
