// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/particles/sub_cells.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace Waker
{
  namespace
  {
    /// Shares that differ by less come from round-off.
    constexpr double round_off = 1e-12;

    /// Area and first moments about the lower left corner of a unit square.
    struct Moments
    {
      double area = 0., x = 0., y = 0.;
    };

    /// The squares of a polygon's bounding box, being cut.
    class Cutter
    {
    public:
      explicit Cutter(const Polygon &corners)
      {
        std::array<double, 2> low  = corners[0];
        std::array<double, 2> high = corners[0];
        for (const auto &p : corners)
          for (unsigned int d = 0; d < 2; ++d)
            {
              low[d]  = std::min(low[d], p[d]);
              high[d] = std::max(high[d], p[d]);
            }
        for (unsigned int d = 0; d < 2; ++d)
          {
            first[d] = static_cast<int>(std::floor(low[d]));
            n[d] = std::max(1, static_cast<int>(std::ceil(high[d])) - first[d]);
          }
        inside.resize(std::size_t(n[0]) * n[1]);
        rest_of_row.resize(inside.size());
        for (std::size_t k = 0; k < corners.size(); ++k)
          add_edge(corners[k], corners[(k + 1) % corners.size()]);
      }

      std::vector<SubCellPart>
      parts() const
      {
        std::vector<SubCellPart> result;
        for (int j = 0; j < n[1]; ++j)
          {
            Moments left; // what the squares to the left hand on
            for (int i = 0; i < n[0]; ++i)
              {
                const std::size_t k      = std::size_t(j) * n[0] + i;
                const Moments    &own    = inside[k];
                const Moments     square = {own.area + left.area,
                                            own.x + left.x,
                                            own.y + left.y};
                const Moments    &more   = rest_of_row[k];
                left.area += more.area;
                left.x += more.x;
                left.y += more.y;

                SubCellPart part;
                part.index    = {{first[0] + i, first[1] + j}};
                part.share    = 1.;
                part.centroid = {{part.index[0] + .5, part.index[1] + .5}};
                if (square.area < round_off)
                  continue;
                if (square.area < 1. - round_off)
                  {
                    part.share = square.area;
                    // Round-off must not move the centroid of a sliver out.
                    part.centroid = {
                      {part.index[0] +
                         std::clamp(square.x / square.area, 0., 1.),
                       part.index[1] +
                         std::clamp(square.y / square.area, 0., 1.)}};
                  }
                result.push_back(part);
              }
          }
        return result;
      }

    private:
      /// Cut the edge at the rows, then each piece at the columns.
      void
      add_edge(const std::array<double, 2> &from,
               const std::array<double, 2> &to)
      {
        const double x0 = from[0] - first[0], x1 = to[0] - first[0];
        const double y0 = from[1] - first[1], y1 = to[1] - first[1];
        if (y0 == y1)
          return; // nothing lies to the right of a horizontal edge
        const bool up        = y1 > y0;
        const int  row_begin = static_cast<int>(std::floor(std::min(y0, y1)));
        const int  row_end   = static_cast<int>(std::ceil(std::max(y0, y1)));
        const auto x_at      = [&](const double y) {
          if (y == y0 || y == y1)
            return y == y0 ? x0 : x1;
          const double x = x0 + (x1 - x0) * ((y - y0) / (y1 - y0));
          return std::clamp(x, std::min(x0, x1), std::max(x0, x1));
        };
        for (int j = row_begin; j < row_end; ++j)
          {
            const double y_low  = std::max<double>(j, std::min(y0, y1));
            const double y_high = std::min<double>(j + 1, std::max(y0, y1));
            if (up)
              add_row_piece(
                j, x_at(y_low), y_low - j, x_at(y_high), y_high - j);
            else
              add_row_piece(
                j, x_at(y_high), y_high - j, x_at(y_low), y_low - j);
          }
      }

      void
      add_row_piece(const int    j,
                    const double x0,
                    const double y0,
                    const double x1,
                    const double y1)
      {
        const int begin =
          std::min(n[0] - 1, static_cast<int>(std::floor(std::min(x0, x1))));
        const int end =
          std::max(begin + 1,
                   std::min(n[0],
                            static_cast<int>(std::ceil(std::max(x0, x1)))));
        const auto y_at = [&](const double x) {
          return y0 + (y1 - y0) * ((x - x0) / (x1 - x0));
        };
        double x = x0, y = y0;
        for (int k = begin; k < end; ++k)
          {
            const int    i      = x1 >= x0 ? k : begin + end - 1 - k;
            const bool   last   = k == end - 1;
            const double next_x = last ? x1 : x1 >= x0 ? i + 1. : i;
            const double next_y = last ? y1 : y_at(next_x);
            add_piece(std::size_t(j) * n[0] + i, x - i, y, next_x - i, next_y);
            x = next_x;
            y = next_y;
          }
      }

      /// Add what lies to the right of a piece inside one square: positive if
      /// it runs down, since an anticlockwise polygon then lies on that side.
      void
      add_piece(const std::size_t square,
                const double      x0,
                const double      y0,
                const double      x1,
                const double      y1)
      {
        const double height = y0 - y1;
        const double y_mean = (y0 + y1) / 2.;
        inside[square].area += height * (1. - (x0 + x1) / 2.);
        inside[square].x +=
          height * (1. - (x0 * x0 + x0 * x1 + x1 * x1) / 3.) / 2.;
        inside[square].y += height * (y_mean - (x0 * y0 + x1 * y1) / 3. -
                                      (x0 * y1 + x1 * y0) / 6.);
        rest_of_row[square].area += height;
        rest_of_row[square].x += height / 2.;
        rest_of_row[square].y += height * y_mean;
      }

      std::array<int, 2>   first;
      std::array<int, 2>   n;
      std::vector<Moments> inside;
      std::vector<Moments> rest_of_row;
    };

    /// Add the volume and first moment of one part to another.
    template <int dim>
    void
    give(const LatticePart<dim> &from, LatticePart<dim> &to)
    {
      const double weight = from.share / (to.share + from.share);
      for (unsigned int d = 0; d < dim; ++d)
        to.centroid[d] += weight * (from.centroid[d] - to.centroid[d]);
      to.share += from.share;
    }


    /// Does one stand before the other in the lexicographic order?
    template <int dim>
    bool
    comes_before(const std::array<int, dim> &a, const std::array<int, dim> &b)
    {
      for (unsigned int d = dim; d-- > 0;)
        if (a[d] != b[d])
          return a[d] < b[d];
      return false;
    }


    template <int dim>
    double
    distance(const std::array<double, dim> &a, const std::array<double, dim> &b)
    {
      if constexpr (dim == 2)
        return std::hypot(a[0] - b[0], a[1] - b[1]);
      else
        return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
  } // namespace


  std::vector<SubCellPart>
  cut_sub_cells(const Polygon &corners)
  {
    Assert(corners.size() >= 3, dealii::ExcInternalError());
    return Cutter(corners).parts();
  }


  template <int dim>
  std::vector<LatticePart<dim>>
  merge_small_parts(const std::vector<LatticePart<dim>> &parts,
                    const double                         minimum_share)
  {
    std::vector<LatticePart<dim>> merged(parts);
    std::vector<bool>             gone(parts.size(), false);
    const auto                    is_small = [&](const double share) {
      return share < minimum_share - round_off;
    };

    // The parts lie lexicographically: find one by bisection.
    const auto find = [&](const std::array<int, dim> &index) {
      const auto place =
        std::lower_bound(parts.begin(),
                         parts.end(),
                         index,
                         [](const LatticePart<dim>     &part,
                            const std::array<int, dim> &sought) {
                           return comes_before<dim>(part.index, sought);
                         });
      return place != parts.end() && place->index == index
               ? static_cast<std::size_t>(place - parts.begin())
               : parts.size();
    };

    using Entry = std::pair<double, std::size_t>; // share, part
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> small;
    for (std::size_t p = 0; p < parts.size(); ++p)
      if (is_small(parts[p].share))
        small.emplace(parts[p].share, p);

    while (!small.empty())
      {
        const Entry entry = small.top();
        small.pop();
        const std::size_t p = entry.second;
        if (gone[p] || merged[p].share != entry.first)
          continue; // it has merged, or grown and stands in the queue again

        std::size_t best          = parts.size();
        double      best_distance = std::numeric_limits<double>::max();
        // Lower neighbours first, the last direction first of them; then the
        // upper ones, the first direction first.
        for (unsigned int n = 0; n < 2 * dim; ++n)
          {
            std::array<int, dim> index = parts[p].index;
            if (n < dim)
              --index[dim - 1 - n];
            else
              ++index[n - dim];
            const std::size_t q = find(index);
            if (q == parts.size() || gone[q])
              continue;
            // Shares and centroids before any merging, so that the choice
            // hardly depends on the order.
            const double way =
              distance<dim>(parts[q].centroid, parts[p].centroid);
            const double more =
              best == parts.size() ? 1. : parts[q].share - parts[best].share;
            if (more > 1e-9 || (more > -1e-9 && way < best_distance))
              {
                best          = q;
                best_distance = way;
              }
          }
        if (best == parts.size())
          continue;
        give(merged[p], merged[best]);
        gone[p] = true;
        if (is_small(merged[best].share))
          small.emplace(merged[best].share, best);
      }

    std::vector<LatticePart<dim>> result;
    for (std::size_t p = 0; p < parts.size(); ++p)
      if (!gone[p])
        result.push_back(merged[p]);
    return result;
  }


  std::vector<IntervalPart>
  cut_intervals(const double begin,
                const double end,
                const double minimum_share)
  {
    std::vector<IntervalPart> parts;
    for (int k = static_cast<int>(std::floor(begin)); k < end; ++k)
      {
        const double a = std::max<double>(k, begin);
        const double b = std::min<double>(k + 1, end);
        if (b - a > round_off)
          parts.push_back({k, b - a, (a + b) / 2.});
      }
    const auto give = [](const IntervalPart &from, IntervalPart &to) {
      to.centroid = (from.share * from.centroid + to.share * to.centroid) /
                    (from.share + to.share);
      to.share += from.share;
    };
    if (parts.size() > 1 && parts.front().share < minimum_share - round_off)
      {
        give(parts[0], parts[1]);
        parts.erase(parts.begin());
      }
    if (parts.size() > 1 && parts.back().share < minimum_share - round_off)
      {
        give(parts.back(), parts[parts.size() - 2]);
        parts.pop_back();
      }
    return parts;
  }


  template std::vector<LatticePart<2>>
  merge_small_parts(const std::vector<LatticePart<2>> &, const double);
  template std::vector<LatticePart<3>>
  merge_small_parts(const std::vector<LatticePart<3>> &, const double);
} // namespace Waker
