// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/places.h>
#include <waker/campaign/dependent_properties.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  template <int dim>
  typename Ground<dim>::WeightRatio
  weight_ratio(const Case<dim>                &the_case,
               const std::vector<CellWeights> &weights)
  {
    if (weights.empty())
      return {};
    return [&](const unsigned int material,
               const Point<dim>  &x,
               const double       low,
               const double       high) {
      const auto of_material =
        std::find_if(weights.begin(), weights.end(), [&](const auto &w) {
          return w.material == material;
        });
      if (of_material == weights.end())
        return 1.;
      const FieldLattice   &lattice = of_material->lattice;
      const double          origin  = lattice.origin[1];
      const double          h       = lattice.cell_size[1];
      std::array<double, 3> place   = field_coordinates(the_case, x);
      const auto            row     = [&](const double y) {
        place[1] = y;
        return lattice.index(lattice.cell_of(place))[1];
      };
      const unsigned int first = row(low), last = row(high);
      double             sum = 0.;
      for (unsigned int j = first; j <= last; ++j)
        {
          // Beyond the lattice as in its last cell.
          const double from = j == first ? low : origin + j * h;
          const double to   = j == last ? high : origin + (j + 1) * h;
          place[1]          = origin + (j + 0.5) * h;
          sum += (to - from) * of_material->ratio[lattice.cell_of(place)];
        }
      return sum / (high - low);
    };
  }


  template <int dim>
  DependentProperties<dim>::DependentProperties(
    const Case<dim>                     &the_case,
    const std::vector<FieldTarget<dim>> &targets)
    : the_case(&the_case)
    , own(the_case.materials, the_case.ground)
  {
    using Kind      = RandomProperty::Kind;
    const auto kind = [](const auto &target) {
      return target.moments.varied().kind;
    };
    const bool weights_vary =
      std::any_of(targets.begin(), targets.end(), [&](const auto &target) {
        return kind(target) == Kind::unit_weight;
      });
    const MaterialPoints<dim> &points = the_case.initial_points;
    for (unsigned int m = 0; m < the_case.materials.size(); ++m)
      {
        bool has_random = false;
        for (const FieldTarget<dim> &target : targets)
          has_random = has_random || (target.material == m &&
                                      kind(target) == Kind::coefficient);
        if (!has_random && !(weights_vary && own.asks_for_stress(m)))
          continue;

        Soil soil;
        soil.material = m;
        for (std::size_t q = 0; q < points.n_points(); ++q)
          if (points.material[q] == m)
            {
              soil.points.push_back(q);
              if (!weights_vary)
                soil.places.push_back(
                  the_case.ground.at(points.initial_position[q],
                                     the_case.layers_of_points[q]));
            }
        // Of those that do not vary in this material there is no name.
        if (has_random)
          for (const auto &c : the_case.materials[m]->coefficients())
            soil.coefficients.push_back(
              std::any_of(targets.begin(),
                          targets.end(),
                          [&](const auto &target) {
                            return target.material == m &&
                                   kind(target) == Kind::coefficient &&
                                   target.moments.varied().name == c.name;
                          })
                ? c.name
                : "");

        const auto variables = the_case.materials[m]->variables();
        for (unsigned int v = 0; v < variables.size(); ++v)
          {
            soil.variables.push_back(variables[v].name);
            if (!has_random)
              continue;
            for (const FieldTarget<dim> &target : targets)
              if (target.material == m && kind(target) == Kind::variable &&
                  target.moments.varied().name == variables[v].name &&
                  variables[v].initial_value.varies() &&
                  variables[v].role !=
                    MaterialVariable::Role::residual_strength)
                throw UserError(target.path + "/Property",
                                "is \"" + variables[v].name +
                                  "\", which in the material \"" +
                                  the_case.parameters.materials[m].name +
                                  "\" follows from what has a field, too",
                                "a field of the one or of the other");
            for (unsigned int w = 0; w < variables.size(); ++w)
              if (variables[v].goes_along_with == variables[w].name)
                {
                  Along       along{v, w, {}};
                  const auto &part  = points.scalar(variables[v].name);
                  const auto &whole = points.scalar(variables[w].name);
                  for (const std::size_t q : soil.points)
                    along.ratio.push_back(whole[q] > 0. ? part[q] / whole[q]
                                                        : 1.);
                  soil.along.push_back(std::move(along));
                }
          }
        soils.push_back(std::move(soil));
      }
  }


  template <int dim>
  void
  DependentProperties<dim>::set(const typename Ground<dim>::WeightRatio &ratio,
                                State<dim> &state) const
  {
    for (const Soil &soil : soils)
      {
        std::vector<double> coefficients = own.coefficients(soil.material);
        std::vector<const std::vector<double> *> varying;
        std::vector<std::vector<double> *>       variables;
        // Addresses stay: no scalar is new here.
        for (const std::string &name : soil.coefficients)
          {
            const int i = state.points.find_scalar(name);
            varying.push_back(i < 0 ? nullptr
                                    : &state.points.scalars[i].values);
          }
        for (const std::string &name : soil.variables)
          variables.push_back(&state.points.scalar(name));

        // What is drawn and printed, if it is.
        const int vertical_stress =
          state.points.find_scalar("initial vertical stress");

        for (std::size_t i = 0; i < soil.points.size(); ++i)
          {
            const std::size_t q = soil.points[i];
            const Point<dim> &x = state.points.initial_position[q];
            for (unsigned int c = 0; c < varying.size(); ++c)
              if (varying[c] != nullptr)
                coefficients[c] = (*varying[c])[q];
            const InGround place =
              soil.places.empty()
                ? the_case->ground.at(x, the_case->layers_of_points[q], ratio)
                : soil.places[i];
            if (vertical_stress >= 0)
              state.points.scalars[vertical_stress].values[q] =
                place.vertical_stress;
            std::vector<double> values =
              own.at(soil.material, x, place, coefficients);
            for (const Along &along : soil.along)
              values[along.variable] = along.ratio[i] * values[along.with];
            for (unsigned int v = 0; v < values.size(); ++v)
              {
                if (!std::isfinite(values[v]))
                  throw NumericalFailure(
                    "Random fields: the " + soil.variables[v] + " at " +
                    place_text(x) +
                    " is not finite, where the vertical stress is " +
                    std::to_string(place.vertical_stress) + " kPa" +
                    the_case->ground.why_uplifted(x,
                                                  the_case->layers_of_points[q],
                                                  place));
                (*variables[v])[q] = values[v];
              }
          }
      }
  }


  template Ground<2>::WeightRatio
  weight_ratio(const Case<2> &, const std::vector<CellWeights> &);
  template Ground<3>::WeightRatio
  weight_ratio(const Case<3> &, const std::vector<CellWeights> &);
  template class DependentProperties<2>;
  template class DependentProperties<3>;
} // namespace Waker
