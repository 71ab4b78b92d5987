// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/particles/body_pieces.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Waker
{
  namespace
  {
    using Corner = std::array<double, 2>;

    /// Heights (in units of the lattice) that differ by less come from
    /// round-off.
    constexpr double round_off = 1e-12;


    Plan
    clip_to(Plan plan, const Corner &lower, const Corner &upper)
    {
      for (unsigned int d = 0; d < 2; ++d)
        for (const double sign : {1., -1.})
          {
            Plane inside{sign > 0. ? -lower[d] : upper[d], {{0., 0.}}};
            inside.slope[d] = sign;
            plan            = clip(plan, inside);
          }
      return plan;
    }


    /// Add what lies between two planes over a convex part of the plan; there
    /// the roof is nowhere below the floor.
    void
    add_between(const Plan  &plan,
                const Plane &floor,
                const Plane &roof,
                Moments     &sum)
    {
      // The integrands are of second degree at most: on a triangle the mean of
      // the middles of its edges is exact.
      for (std::size_t i = 1; i + 1 < plan.size(); ++i)
        {
          const std::array<Corner, 3> c = {{plan[0], plan[i], plan[i + 1]}};
          const double                third =
            std::abs((c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) -
                     (c[1][1] - c[0][1]) * (c[2][0] - c[0][0])) /
            6.;
          for (unsigned int k = 0; k < 3; ++k)
            {
              const double x   = (c[k][0] + c[(k + 1) % 3][0]) / 2.;
              const double z   = (c[k][1] + c[(k + 1) % 3][1]) / 2.;
              const double low = floor.at(x, z), high = roof.at(x, z);
              const double volume = third * (high - low);
              sum.volume += volume;
              sum.first[0] += volume * x;
              sum.first[1] += volume * (low + high) / 2.;
              sum.first[2] += volume * z;
            }
        }
    }


    Plane
    difference(const Plane &a, const Plane &b)
    {
      return {a.level - b.level,
              {{a.slope[0] - b.slope[0], a.slope[1] - b.slope[1]}}};
    }


    /// The part of the plan in which planes[n] is the largest of them (sign =
    /// 1) or the smallest (-1); of equal ones the first.
    Plan
    where_it_bounds(Plan                      plan,
                    const std::vector<Plane> &planes,
                    const std::size_t         n,
                    const double              sign)
    {
      for (std::size_t m = 0; m < planes.size() && !plan.empty(); ++m)
        {
          if (m == n)
            continue;
          Plane more = difference(planes[n], planes[m]);
          more.level *= sign;
          more.slope     = {{sign * more.slope[0], sign * more.slope[1]}};
          double largest = 0.;
          for (const Corner &c : plan)
            largest = std::max(largest, std::abs(more.at(c[0], c[1])));
          if (largest <= round_off)
            {
              if (m < n)
                plan.clear();
            }
          else
            plan = clip(plan, more);
        }
      return plan;
    }
  } // namespace


  std::vector<Trapezoid>
  trapezoids(const Polygon &corners)
  {
    std::vector<double> x;
    for (const Corner &corner : corners)
      x.push_back(corner[0]);
    std::sort(x.begin(), x.end());
    x.erase(std::unique(x.begin(), x.end()), x.end());

    std::vector<Trapezoid> result;
    for (std::size_t s = 0; s + 1 < x.size(); ++s)
      {
        const double middle = (x[s] + x[s + 1]) / 2.;
        // Edges that pass, by their height in the middle.
        std::vector<std::pair<double, Plane>> edges;
        for (std::size_t k = 0; k < corners.size(); ++k)
          {
            const Corner &a = corners[k],
                         &b = corners[(k + 1) % corners.size()];
            if ((a[0] < middle) == (b[0] < middle))
              continue;
            Plane edge;
            edge.slope = {{(b[1] - a[1]) / (b[0] - a[0]), 0.}};
            edge.level = a[1] - edge.slope[0] * a[0];
            edges.emplace_back(edge.at(middle, 0.), edge);
          }
        std::sort(edges.begin(), edges.end(), [](const auto &a, const auto &b) {
          return a.first < b.first;
        });
        for (std::size_t k = 0; k + 1 < edges.size(); k += 2)
          result.push_back(
            {x[s], x[s + 1], edges[k].second, edges[k + 1].second});
      }
    return result;
  }


  void
  for_each_piece(const LayerBody                          &body,
                 const Trapezoid                          &trapezoid,
                 const Plan                               &window,
                 const std::function<void(const Piece &)> &f)
  {
    const Plan plan = clip_to(window,
                              {{trapezoid.begin, body.begin}},
                              {{trapezoid.end, body.end}});
    if (plan.empty())
      return;
    const auto with_bottom = [&](const Plan               &part,
                                 const std::vector<Plane> &roofs) {
      if (body.bottom == nullptr)
        f(Piece{part, {trapezoid.floor}, roofs});
      else
        body.bottom->for_each_part(
          part, [&](const Plan &smaller, const Plane &y) {
            f(Piece{smaller, {trapezoid.floor, y}, roofs});
          });
    };
    if (body.top == nullptr)
      with_bottom(plan, {trapezoid.roof});
    else
      body.top->for_each_part(plan, [&](const Plan &part, const Plane &y) {
        with_bottom(part, {trapezoid.roof, y});
      });
  }


  void
  add_piece(const Piece &piece, Moments &sum)
  {
    for (std::size_t i = 0; i < piece.floors.size(); ++i)
      {
        const Plan over_floor =
          where_it_bounds(piece.plan, piece.floors, i, 1.);
        for (std::size_t j = 0; j < piece.roofs.size(); ++j)
          {
            const Plane &floor = piece.floors[i], &roof = piece.roofs[j];
            const Plan   plan =
              clip(where_it_bounds(over_floor, piece.roofs, j, -1.),
                   difference(roof, floor));
            if (!plan.empty())
              add_between(plan, floor, roof, sum);
          }
      }
  }


  std::pair<double, double>
  height_range(const Piece &piece)
  {
    double low  = -std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::max();
    for (const Plane &floor : piece.floors)
      {
        double least = std::numeric_limits<double>::max();
        for (const Corner &c : piece.plan)
          least = std::min(least, floor.at(c[0], c[1]));
        low = std::max(low, least);
      }
    for (const Plane &roof : piece.roofs)
      {
        double largest = -std::numeric_limits<double>::max();
        for (const Corner &c : piece.plan)
          largest = std::max(largest, roof.at(c[0], c[1]));
        high = std::min(high, largest);
      }
    return {low, high};
  }
} // namespace Waker
