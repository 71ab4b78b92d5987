// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/loads/quick_loads.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Waker
{
  double
  quick_pressure(const TractionParameters &traction, const unsigned int dim)
  {
    const std::string path = "Tractions/" + traction.name + "/";
    if (traction.kind == TractionKind::hydrostatic)
      throw UserError(path + "Consolidation",
                      "is " + in_quotes(traction.consolidation) +
                        ", but Kind is hydrostatic: water is no load that soil "
                        "consolidates under",
                      "nothing, or Kind = pressure or vector");
    if (traction.from.empty())
      throw UserError(path + "From",
                      "is empty, but a load with a Consolidation has an end",
                      "both corners of the box, From and To");
    const bool is_vector = traction.kind == TractionKind::vector;
    const auto parts     = split(traction.value, ';');
    double     pressure  = 0.;
    if (parts.size() != (is_vector ? dim : 1u) ||
        !read_number(parts[is_vector ? 1 : 0], pressure))
      throw UserError(path + "Value",
                      "is " + in_quotes(traction.value) +
                        ", with a Consolidation",
                      "a number (kPa), the same everywhere and at all times");
    if (is_vector)
      pressure = -pressure;
    if (!(pressure >= 0. && std::isfinite(pressure)))
      throw UserError(path + "Value",
                      "is " + in_quotes(traction.value) +
                        ", upwards, with a Consolidation",
                      "a load downwards: of a pressure at least 0, of a vector "
                      "at most 0");
    return pressure;
  }


  std::vector<double>
  degrees_of_consolidation(const std::string                  &text,
                           const std::vector<LayerParameters> &layers,
                           const std::string                  &path)
  {
    std::string names;
    for (const LayerParameters &layer : layers)
      names += (names.empty() ? "" : ", ") + layer.name;
    const std::string allowed =
      "a degree (-) from 0 to 1 for all layers; or \"layer: degree, ...\" with "
      "layers of " +
      names;
    const auto check = [&](const double degree) {
      if (!(degree >= 0. && degree <= 1.))
        throw UserError(path, "has the degree " + in_digits(degree), allowed);
    };
    double number = 0.;
    if (read_number(text, number))
      {
        check(number);
        return std::vector<double>(layers.size(), number);
      }
    std::vector<double> degrees(layers.size(), 1.);
    std::vector<bool>   is_given(layers.size(), false);
    for (const std::string &item : split(text, ','))
      {
        const std::size_t colon  = item.rfind(':');
        double            degree = 0.;
        if (colon == std::string::npos ||
            !read_number(tidy(item.substr(colon + 1)), degree))
          throw UserError(path,
                          in_quotes(item) + " is no layer and degree",
                          allowed);
        check(degree);
        const std::string name  = tidy(item.substr(0, colon));
        const auto        layer = std::find_if(layers.begin(),
                                        layers.end(),
                                        [&](const LayerParameters &other) {
                                          return other.name == name;
                                        });
        if (layer == layers.end())
          throw UserError(path,
                          "there is no layer " + in_quotes(name),
                          allowed);
        const std::size_t number = layer - layers.begin();
        if (is_given[number])
          throw UserError(path, "has " + in_quotes(name) + " twice", allowed);
        is_given[number] = true;
        degrees[number]  = degree;
      }
    return degrees;
  }


  template <int dim>
  QuickLoads<dim>::QuickLoads(const std::vector<TractionParameters> &tractions,
                              const std::vector<LayerParameters>    &layers,
                              const SoilDepths<dim>                 &depths)
  {
    for (const TractionParameters &traction : tractions)
      {
        if (tidy(traction.consolidation).empty())
          continue;
        const std::string path = "Tractions/" + traction.name + "/";
        Load              load;
        load.pressure = quick_pressure(traction, dim);
        load.tangent  = std::tan(traction.spread * std::acos(-1.) / 180.);
        Point<dim> middle;
        for (unsigned int d = 0; d < dim; d += 2)
          {
            load.from.push_back(traction.from[d]);
            load.to.push_back(traction.to[d]);
            middle[d] = 0.5 * (traction.from[d] + traction.to[d]);
          }
        load.in_grains = degrees_of_consolidation(traction.consolidation,
                                                  layers,
                                                  path + "Consolidation");
        load.top       = -std::numeric_limits<double>::infinity();
        for (const auto &[layer, stretch] : depths.column(middle))
          load.top = std::max(load.top, stretch.high);
        if (!std::isfinite(load.top))
          throw UserError(path + "From",
                          "and To have their middle at x = " +
                            in_digits(middle[0]) + " m, where no soil is",
                          "a load on soil");
        loads.push_back(load);
      }
  }


  template <int dim>
  double
  QuickLoads<dim>::Load::stress(const Point<dim> &x) const
  {
    if (x[1] > top)
      return 0.;
    const double wider = (top - x[1]) * tangent;
    double       share = 1.;
    for (unsigned int d = 0; d < from.size(); ++d)
      {
        if (x[2 * d] < from[d] - wider || x[2 * d] > to[d] + wider)
          return 0.;
        const double width = to[d] - from[d];
        share *= width > 0. ? width / (width + 2. * wider) : 0.;
      }
    return share * pressure;
  }


  template <int dim>
  double
  QuickLoads<dim>::stress(const Point<dim> &x) const
  {
    double sum = 0.;
    for (const Load &load : loads)
      sum += load.stress(x);
    return sum;
  }


  template <int dim>
  double
  QuickLoads<dim>::pore_pressure(const Point<dim>  &x,
                                 const unsigned int layer) const
  {
    double sum = 0.;
    for (const Load &load : loads)
      if (layer < load.in_grains.size())
        sum += (1. - load.in_grains[layer]) * load.stress(x);
    return sum;
  }


  template class QuickLoads<2>;
  template class QuickLoads<3>;
} // namespace Waker
