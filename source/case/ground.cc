// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/case/ground.h>
#include <waker/case/parameters.h>
#include <waker/loads/water_level.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

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
    , lines(p.pore_water)
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
      {
        if (traction.kind == TractionKind::hydrostatic)
          stress_is_known = stress_is_known && p.pore_water.is_there();
        if (!tidy(traction.consolidation).empty())
          names_of_quick_loads +=
            (names_of_quick_loads.empty() ? "" : ", ") + traction.name;
      }
  }


  template <int dim>
  double
  Ground<dim>::vertical_stress(const Column         &column,
                               const Point<dim>     &x,
                               const PoreWater<dim> &water,
                               const WeightRatio    &weight_ratio) const
  {
    const double line = water.empty() ? -std::numeric_limits<double>::infinity()
                                      : water.line().height(x[0]);
    return vertical_stress(column,
                           x,
                           line,
                           {line, water.empty() ? 0. : water.pressure(x)},
                           weight_ratio);
  }


  template <int dim>
  double
  Ground<dim>::vertical_stress(const Column      &column,
                               const Point<dim>  &x,
                               const double       line,
                               const WaterAt     &water,
                               const WeightRatio &weight_ratio) const
  {
    double stress = 0., soil_in_water = 0.; // length of it
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
        soil_in_water += std::clamp(water.line, low, stretch.high) - low;
      }
    if (!std::isfinite(water.line))
      return stress;
    // Water stands on the soil, and in its gaps.
    const double open_water = std::max(water.line - x[1], 0.) - soil_in_water;
    return stress + water_weight * open_water - water.pressure;
  }


  template <int dim>
  double
  Ground<dim>::vertical_stress_under(const Heads       &heads,
                                     const Point<dim>  &x,
                                     const unsigned int layer) const
  {
    if (layer >= soil_depths.n_layers())
      return nan;
    return vertical_stress(soil_depths.column(x),
                           x,
                           pore_water->line().height(x[0]),
                           {heads.phreatic().height(x[0]),
                            pore_water->pressure(heads, x)},
                           {}) +
           quick_loads.stress(x) - load_pressure(x, layer);
  }


  template <int dim>
  std::string
  Ground<dim>::why_uplifted(const Point<dim>  &x,
                            const unsigned int layer,
                            const InGround    &place) const
  {
    if (place.vertical_stress >= 0. && place.daily_vertical_stress >= 0.)
      return "";
    if (layer >= soil_depths.n_layers())
      return " (soil that flows in lies in no ground)";
    if (!std::isfinite(place.vertical_stress) ||
        !std::isfinite(place.daily_vertical_stress))
      return " (a unit weight, a head or a load is too large)";
    const bool         is_now = !(place.vertical_stress >= 0.);
    std::ostringstream text;
    text << " (uplift" << (is_now ? "" : " on usual days")
         << ": the water there, "
         << (is_now ? *pore_water : daily_pore_water).pressure(x) << " kPa by "
         << lines.name_of_line_at(x[0], x[1])
         << (is_now ? "" : " of those days");
    const double of_loads = load_pressure(x, layer);
    if (is_now && of_loads > 0.)
      text << " and " << of_loads << " kPa by the loads with a Consolidation ("
           << names_of_quick_loads << ")";
    text << ", carries more than the soil above weighs)";
    return text.str();
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
