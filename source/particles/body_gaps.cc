// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/particles/layer_gaps.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace Waker
{
  std::vector<BodyGap>
  body_gaps(const std::vector<LayerBody> &bodies, const double spacing)
  {
    if (std::all_of(bodies.begin(), bodies.end(), [](const LayerBody &body) {
          return body.is_prism();
        }))
      return {};

    // All of them in plan: x, z.
    std::array<double, 2> low  = {{bodies[0].corners[0][0], bodies[0].begin}};
    std::array<double, 2> high = low;
    for (const LayerBody &body : bodies)
      {
        for (const auto &corner : body.corners)
          {
            low[0]  = std::min(low[0], corner[0]);
            high[0] = std::max(high[0], corner[0]);
          }
        low[1]  = std::min(low[1], body.begin);
        high[1] = std::max(high[1], body.end);
      }
    std::array<int, 2> n;
    for (unsigned int d = 0; d < 2; ++d)
      n[d] =
        std::max(1,
                 static_cast<int>(std::lround((high[d] - low[d]) / spacing)));

    struct Part
    {
      LayerBody::Stretch stretch;
      std::size_t        body;
    };
    std::map<std::pair<std::size_t, std::size_t>, BodyGap> gaps;
    const double                                           line_area =
      (high[0] - low[0]) / n[0] * (high[1] - low[1]) / n[1];
    std::vector<Part> parts;
    for (int k = 0; k < n[1]; ++k)
      for (int i = 0; i < n[0]; ++i)
        {
          const double x = low[0] + (high[0] - low[0]) * (i + 0.5) / n[0];
          const double z = low[1] + (high[1] - low[1]) * (k + 0.5) / n[1];
          parts.clear();
          for (std::size_t b = 0; b < bodies.size(); ++b)
            if (z >= bodies[b].begin && z < bodies[b].end)
              for (const auto &stretch : bodies[b].stretches(x, z, true))
                if (stretch.high > stretch.low)
                  parts.push_back({stretch, b});
          std::sort(parts.begin(),
                    parts.end(),
                    [](const Part &a, const Part &b) {
                      return a.stretch.low < b.stretch.low;
                    });
          for (std::size_t p = 0; p + 1 < parts.size(); ++p)
            {
              const Part  &a = parts[p], &b = parts[p + 1];
              const double height = b.stretch.low - a.stretch.high;
              if (height <= 1e-6 * spacing || a.body == b.body ||
                  (bodies[a.body].is_prism() && bodies[b.body].is_prism()))
                continue;
              BodyGap &gap =
                gaps.insert({{a.body, b.body}, {a.body, b.body, 0., 0., {}}})
                  .first->second;
              gap.area += line_area;
              if (height > gap.height)
                {
                  gap.height = height;
                  gap.middle = {{x, (a.stretch.high + b.stretch.low) / 2., z}};
                }
            }
        }
    std::vector<BodyGap> result;
    for (const auto &entry : gaps)
      result.push_back(entry.second);
    return result;
  }
} // namespace Waker
