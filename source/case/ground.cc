// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/case/ground.h>
#include <waker/case/parameters.h>
#include <waker/loads/water_level.h>

#include <algorithm>
#include <limits>

namespace Waker
{
  template <int dim>
  Ground<dim>::Ground(const BackgroundGrid<dim> &grid,
                      const Parameters          &p,
                      const PoreWater<dim>      &pore_water)
    : soil_depths(grid, p.layers)
    , quick_loads(p.tractions, p.layers, soil_depths)
    , pore_water(&pore_water)
    , daily_pore_water(p.pore_water.of_the_daily_water(),
                       p.water.unit_weight,
                       {},
                       p.initial_stress.daily_stage
                         ? p.initial_stress.level().value_or(
                             WaterLevel(p.water).at(0.))
                         : WaterLevel(p.water).at(0.))
    , water_weight(p.water.unit_weight)
    , has_gravity(p.gravity.acceleration > 0.)
    , stress_is_known(p.pore_water.is_there() || !p.water.stands())
  {
    // Without gravity nothing weighs anything.
    const double share =
      p.gravity.acceleration / p.gravity.density_acceleration();
    for (const LayerParameters &layer : p.layers)
      {
        const auto material =
          std::find_if(p.materials.begin(),
                       p.materials.end(),
                       [&](const auto &m) { return m.name == layer.material; });
        AssertThrow(material != p.materials.end(), ExcInternalError());
        const unsigned int number = material - p.materials.begin();
        soils.push_back({share * material->unit_weight,
                         share * unit_weight_below_line(p.materials, number),
                         number,
                         material_below_line(p.materials, number)});
      }
    for (const TractionParameters &traction : p.tractions)
      if (traction.kind == TractionKind::hydrostatic)
        stress_is_known = stress_is_known && p.pore_water.is_there();
  }


  template <int dim>
  double
  Ground<dim>::vertical_stress(const Column         &column,
                               const Point<dim>     &x,
                               const PoreWater<dim> &water,
                               const WeightRatio    &weight_ratio) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double line   = water.empty() ? -infinity : water.line().height(x[0]);
    double       stress = 0., wet_soil = 0.; // length of it
    for (const auto &[layer, stretch] : column)
      {
        const double low = std::max(stretch.low, x[1]);
        if (!(stretch.high > low))
          continue;
        const double       border = std::clamp(line, low, stretch.high);
        const SoilOfLayer &soil   = soils[layer];
        double             dry    = soil.above_line * (stretch.high - border);
        double             wet    = soil.below_line * (border - low);
        if (weight_ratio)
          {
            if (stretch.high > border)
              dry *= weight_ratio(soil.material, x, border, stretch.high);
            if (border > low)
              wet *= weight_ratio(soil.material_below_line, x, low, border);
          }
        stress += dry + wet;
        wet_soil += border - low;
      }
    if (water.empty())
      return stress;
    // Water stands on the soil, and in its gaps.
    const double open_water = std::max(line - x[1], 0.) - wet_soil;
    return stress + water_weight * open_water - water.pressure(x);
  }


  template <int dim>
  InGround
  Ground<dim>::at(const Point<dim>  &x,
                  const unsigned int layer,
                  const WeightRatio &weight_ratio) const
  {
    const Depths depths = soil_depths.at(x, layer);
    if (layer >= soil_depths.n_layers())
      return {nan, nan, nan, nan};
    const auto column = soil_depths.column(x);
    return {depths.below_surface,
            depths.in_layer,
            vertical_stress(column, x, *pore_water, weight_ratio) +
              quick_loads.stress(x) - load_pressure(x, layer),
            vertical_stress(column, x, daily_pore_water, weight_ratio)};
  }


  template <int dim>
  double
  Ground<dim>::load_pressure(const Point<dim>  &x,
                             const unsigned int layer) const
  {
    // Above the line there is air, too.
    if (pore_water->empty() || x[1] > pore_water->line().height(x[0]))
      return 0.;
    return quick_loads.pore_pressure(x, layer);
  }


  template <int dim>
  void
  Ground<dim>::record_loads(const std::vector<unsigned int> &layers,
                            MaterialPoints<dim>             &points) const
  {
    if (quick_loads.empty())
      return;
    std::vector<double> &values = points.scalar("pore pressure of loads");
    for (std::size_t p = 0; p < points.n_points(); ++p)
      values[p] = load_pressure(points.initial_position[p], layers[p]);
  }


  template <int dim>
  void
  Ground<dim>::check(const PlaceExpression<dim> &expression,
                     const std::string          &path) const
  {
    if (expression.asks_for_stress())
      require_stress(path,
                     "asks for the effective vertical stress (\"" +
                       expression.text() + "\")",
                     "a strength without it");
  }


  template <int dim>
  void
  Ground<dim>::require_stress(const std::string &path,
                              const std::string &what,
                              const std::string &otherwise) const
  {
    if (!has_gravity)
      throw UserError(path,
                      what + ", and Gravity/Acceleration is 0",
                      otherwise + ", or gravity");
    if (!stress_is_known)
      throw UserError(path,
                      what + ", and water stands on the soil, but nothing says "
                             "where it is in the ground",
                      otherwise +
                        ", or a phreatic line (Pore water/Phreatic line)");
  }


  template class Ground<2>;
  template class Ground<3>;
} // namespace Waker
