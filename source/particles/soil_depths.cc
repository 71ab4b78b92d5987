// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/numbers.h>
#include <waker/particles/layer.h>
#include <waker/particles/soil_depths.h>

#include <algorithm>
#include <limits>

namespace Waker
{
  template <int dim>
  SoilDepths<dim>::SoilDepths(const BackgroundGrid<dim>          &grid,
                              const std::vector<LayerParameters> &layers)
    : tolerance(1e-10 * grid.cell_size())
  {
    for (const LayerParameters &parameters : layers)
      layer_bodies.push_back(place_layer(grid, parameters));
  }


  template <int dim>
  bool
  SoilDepths<dim>::reaches(const LayerBody &body, const Point<dim> &x) const
  {
    return dim == 2 || (x[dim - 1] >= body.begin - tolerance &&
                        x[dim - 1] <= body.end + tolerance);
  }


  template <int dim>
  std::vector<LayerBody::Stretch>
  SoilDepths<dim>::stretches_at(const LayerBody  &body,
                                const Point<dim> &x) const
  {
    std::vector<LayerBody::Stretch> both;
    if (!reaches(body, x))
      return both;
    const double z = std::clamp(x[dim - 1], body.begin, body.end);
    // A polygon ends at a corner, and one of its two sides meets the line.
    for (const bool right : {true, false})
      for (const LayerBody::Stretch &stretch : body.stretches(x[0], z, right))
        both.push_back(stretch);
    return both;
  }


  template <int dim>
  Depths
  SoilDepths<dim>::at(const Point<dim> &x, const unsigned int layer) const
  {
    if (layer >= layer_bodies.size())
      return {nan, nan};
    Depths depths{0., 0.};
    for (const LayerBody &body : layer_bodies)
      for (const LayerBody::Stretch &stretch : stretches_at(body, x))
        depths.below_surface =
          std::max(depths.below_surface, stretch.high - x[1]);
    for (const LayerBody::Stretch &stretch :
         stretches_at(layer_bodies[layer], x))
      if (x[1] >= stretch.low - tolerance && x[1] <= stretch.high + tolerance)
        depths.in_layer = std::max(depths.in_layer, stretch.high - x[1]);
    return depths;
  }


  template <int dim>
  std::vector<typename SoilDepths<dim>::InLayer>
  SoilDepths<dim>::column(const Point<dim> &x) const
  {
    std::vector<InLayer> soil;
    for (const bool right : {true, false})
      {
        for (unsigned int layer = 0; layer < layer_bodies.size(); ++layer)
          {
            const LayerBody &body = layer_bodies[layer];
            if (!reaches(body, x))
              continue;
            const double z = std::clamp(x[dim - 1], body.begin, body.end);
            for (const LayerBody::Stretch &stretch :
                 body.stretches(x[0], z, right))
              soil.push_back({layer, stretch});
          }
        if (!soil.empty())
          break;
      }
    return soil;
  }


  template <int dim>
  bool
  SoilDepths<dim>::holds(const Point<dim> &x, const unsigned int layer) const
  {
    for (const LayerBody::Stretch &stretch :
         stretches_at(layer_bodies[layer], x))
      if (x[1] >= stretch.low - tolerance && x[1] <= stretch.high + tolerance)
        return true;
    return false;
  }


  template class SoilDepths<2>;
  template class SoilDepths<3>;
} // namespace Waker
