// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/numbers.h>
#include <waker/particles/layer.h>
#include <waker/particles/soil_depths.h>

#include <algorithm>
#include <optional>

namespace Waker
{
  namespace
  {
    /**
     * Heights (m) at which the vertical line at x crosses the edges, ascending;
     * an even number. A corner counts with the edge on its right, or with that
     * on its left: a polygon ends at a corner, and one of the two meets it.
     */
    std::vector<double>
    crossings(const Polygon &polygon, const double x, const bool right)
    {
      std::vector<double> heights;
      for (std::size_t k = 0; k < polygon.size(); ++k)
        {
          const auto  &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
          const double low = std::min(a[0], b[0]), high = std::max(a[0], b[0]);
          if (right ? low <= x && x < high : low < x && x <= high)
            heights.push_back(a[1] +
                              (b[1] - a[1]) * ((x - a[0]) / (b[0] - a[0])));
        }
      std::sort(heights.begin(), heights.end());
      return heights;
    }


    /// Distance (m) to the top of the polygon over the place (x, y); none if
    /// it lies outside.
    std::optional<double>
    below_top(const Polygon &polygon,
              const double   x,
              const double   y,
              const double   tolerance)
    {
      std::optional<double> depth;
      for (const bool right : {true, false})
        {
          const std::vector<double> heights = crossings(polygon, x, right);
          for (std::size_t k = 0; k + 1 < heights.size(); k += 2)
            if (y >= heights[k] - tolerance && y <= heights[k + 1] + tolerance)
              depth = std::max(depth.value_or(0.), heights[k + 1] - y);
        }
      return depth;
    }
  } // namespace


  template <int dim>
  SoilDepths<dim>::SoilDepths(const BackgroundGrid<dim>          &grid,
                              const std::vector<LayerParameters> &layers)
    : tolerance(1e-10 * grid.cell_size())
  {
    for (const LayerParameters &parameters : layers)
      {
        const Layer<dim> layer = place_layer(grid, parameters);
        outlines.push_back({layer.corners, layer.begin, layer.end});
      }
  }


  template <int dim>
  bool
  SoilDepths<dim>::reaches(const Outline &outline, const Point<dim> &x) const
  {
    return dim == 2 || (x[dim - 1] >= outline.begin - tolerance &&
                        x[dim - 1] <= outline.end + tolerance);
  }


  template <int dim>
  Depths
  SoilDepths<dim>::at(const Point<dim> &x, const unsigned int layer) const
  {
    if (layer >= outlines.size())
      return {nan, nan};
    Depths depths{0., 0.};
    for (const Outline &outline : outlines)
      if (reaches(outline, x))
        for (const bool right : {true, false})
          {
            const std::vector<double> heights =
              crossings(outline.corners, x[0], right);
            if (!heights.empty())
              depths.below_surface =
                std::max(depths.below_surface, heights.back() - x[1]);
          }
    depths.in_layer =
      below_top(outlines[layer].corners, x[0], x[1], tolerance).value_or(0.);
    return depths;
  }


  template <int dim>
  bool
  SoilDepths<dim>::holds(const Point<dim> &x, const unsigned int layer) const
  {
    return reaches(outlines[layer], x) &&
           below_top(outlines[layer].corners, x[0], x[1], tolerance)
             .has_value();
  }


  template class SoilDepths<2>;
  template class SoilDepths<3>;
} // namespace Waker
