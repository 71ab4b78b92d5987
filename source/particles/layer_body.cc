// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/particles/body_pieces.h>
#include <waker/particles/layer_body.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace Waker
{
  namespace
  {
    using Corner = std::array<double, 2>;

    constexpr double infinity = std::numeric_limits<double>::infinity();

    /// Shares that differ by less come from round-off.
    constexpr double round_off = 1e-12;


    /// All of the body in plan.
    Plan
    whole_plan(const LayerBody &body)
    {
      double low = body.corners[0][0], high = low;
      for (const Corner &corner : body.corners)
        {
          low  = std::min(low, corner[0]);
          high = std::max(high, corner[0]);
        }
      return {{{low, body.begin}},
              {{high, body.begin}},
              {{high, body.end}},
              {{low, body.end}}};
    }
  } // namespace


  std::vector<LayerBody::Stretch>
  LayerBody::stretches(const double x, const double z, const bool right) const
  {
    std::vector<double> heights;
    for (std::size_t k = 0; k < corners.size(); ++k)
      {
        const Corner &a = corners[k], &b = corners[(k + 1) % corners.size()];
        const double  low = std::min(a[0], b[0]), high = std::max(a[0], b[0]);
        if (right ? low <= x && x < high : low < x && x <= high)
          heights.push_back(a[1] +
                            (b[1] - a[1]) * ((x - a[0]) / (b[0] - a[0])));
      }
    std::sort(heights.begin(), heights.end());

    const std::optional<double> roof =
      top == nullptr ? std::nullopt : top->at(x, z);
    const std::optional<double> floor =
      bottom == nullptr ? std::nullopt : bottom->at(x, z);
    std::vector<Stretch> result;
    for (std::size_t k = 0; k + 1 < heights.size(); k += 2)
      {
        const Stretch stretch = {floor ? std::max(*floor, heights[k])
                                       : heights[k],
                                 roof ? std::min(*roof, heights[k + 1])
                                      : heights[k + 1]};
        if (stretch.low <= stretch.high)
          result.push_back(stretch);
      }
    return result;
  }


  double
  LayerBody::highest_at(const double z) const
  {
    std::vector<double> places;
    for (const Corner &corner : corners)
      places.push_back(corner[0]);
    for (const HeightMap *const map : {top.get(), bottom.get()})
      if (map != nullptr)
        for (const double x : map->crossings(z))
          places.push_back(x);
    std::sort(places.begin(), places.end());

    // Between these all borders are lines: a maximum may lie where the map cuts
    // off a side of the polygon.
    const std::size_t n = top == nullptr ? 0 : places.size();
    for (std::size_t i = 0; i + 1 < n; ++i)
      for (std::size_t k = 0; k < corners.size(); ++k)
        {
          const Corner &a = corners[k], &b = corners[(k + 1) % corners.size()];
          const double  x[2] = {places[i], places[i + 1]};
          if (!(std::min(a[0], b[0]) <= x[0] && x[1] <= std::max(a[0], b[0]) &&
                x[0] < x[1]))
            continue;
          double above[2]; // the side over the map
          for (unsigned int e = 0; e < 2; ++e)
            above[e] = a[1] + (b[1] - a[1]) * ((x[e] - a[0]) / (b[0] - a[0])) -
                       top->at(x[e], z).value_or(infinity);
          if (std::isfinite(above[0]) && std::isfinite(above[1]) &&
              above[0] * above[1] < 0.)
            places.push_back(x[0] +
                             (x[1] - x[0]) * above[0] / (above[0] - above[1]));
        }

    double highest = -infinity;
    for (const double x : places)
      for (const bool right : {true, false})
        for (const Stretch &stretch : stretches(x, z, right))
          highest = std::max(highest, stretch.high);
    return highest;
  }


  double
  LayerBody::volume() const
  {
    if (is_prism())
      return signed_area(corners) * (end - begin);
    Moments sum;
    for (const Trapezoid &trapezoid : trapezoids(corners))
      for_each_piece(*this,
                     trapezoid,
                     whole_plan(*this),
                     [&](const Piece &piece) { add_piece(piece, sum); });
    return sum.volume;
  }


  double
  common_volume(const LayerBody &a, const LayerBody &b)
  {
    if (a.is_prism() && b.is_prism())
      {
        const double depth =
          std::min(a.end, b.end) - std::max(a.begin, b.begin);
        return depth > 0. ? depth * common_area(a.corners, b.corners) : 0.;
      }
    Moments                      sum;
    const std::vector<Trapezoid> of_b = trapezoids(b.corners);
    for (const Trapezoid &trapezoid : trapezoids(a.corners))
      for_each_piece(a, trapezoid, whole_plan(a), [&](const Piece &piece) {
        for (const Trapezoid &other : of_b)
          for_each_piece(b, other, piece.plan, [&](Piece both) {
            both.floors.insert(both.floors.end(),
                               piece.floors.begin(),
                               piece.floors.end());
            both.roofs.insert(both.roofs.end(),
                              piece.roofs.begin(),
                              piece.roofs.end());
            add_piece(both, sum);
          });
      });
    return sum.volume;
  }


  std::vector<LatticePart<3>>
  cut_body(const LayerBody &body)
  {
    // By (k, j, i): the lexicographic order.
    std::map<std::array<int, 3>, Moments> cubes;
    const auto                            last = [](const double x) {
      return static_cast<int>(std::ceil(x));
    };
    for (const Trapezoid &trapezoid : trapezoids(body.corners))
      for (int k = static_cast<int>(std::floor(body.begin)); k < last(body.end);
           ++k)
        for (int i = static_cast<int>(std::floor(trapezoid.begin));
             i < last(trapezoid.end);
             ++i)
          for_each_piece(body,
                         trapezoid,
                         {{{1. * i, 1. * k}},
                          {{i + 1., 1. * k}},
                          {{i + 1., k + 1.}},
                          {{1. * i, k + 1.}}},
                         [&](const Piece &piece) {
                           const auto [low, high] = height_range(piece);
                           for (int j = static_cast<int>(std::floor(low));
                                j < last(high);
                                ++j)
                             {
                               Piece part = piece;
                               part.floors.push_back({1. * j, {{0., 0.}}});
                               part.roofs.push_back({j + 1., {{0., 0.}}});
                               add_piece(part, cubes[{{k, j, i}}]);
                             }
                         });

    std::vector<LatticePart<3>> parts;
    for (const auto &[kji, moments] : cubes)
      {
        if (moments.volume < round_off)
          continue;
        LatticePart<3> part;
        part.index = {{kji[2], kji[1], kji[0]}};
        part.share = 1.;
        for (unsigned int d = 0; d < 3; ++d)
          part.centroid[d] = part.index[d] + 0.5;
        if (moments.volume < 1. - round_off)
          {
            part.share = moments.volume;
            // Round-off must not move the centroid of a sliver out.
            for (unsigned int d = 0; d < 3; ++d)
              part.centroid[d] = std::clamp(moments.first[d] / moments.volume,
                                            1. * part.index[d],
                                            part.index[d] + 1.);
          }
        parts.push_back(part);
      }
    return parts;
  }
} // namespace Waker
