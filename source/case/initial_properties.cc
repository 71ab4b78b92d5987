// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/places.h>
#include <waker/case/initial_properties.h>

#include <algorithm>
#include <sstream>

namespace Waker
{
  namespace
  {
    constexpr double round_off = 1e-9; // kPa
  }


  template <int dim>
  InitialProperties<dim>::InitialProperties(const Materials   &materials,
                                            const Ground<dim> &ground)
    : materials(&materials)
    , ground(&ground)
  {
    for (const auto &material : materials)
      {
        properties.emplace_back();
        std::vector<std::string> symbols; // and those of the variables before
        coefficient_values.emplace_back();
        // Those that follow from others come after all of these.
        for (const MaterialVariable &coefficient : material->coefficients())
          {
            const InitialValue &value = coefficient.initial_value;
            if (value.varies())
              {
                properties.back().push_back({coefficient, {}});
                properties.back().back().expression.emplace(value.expression,
                                                            value.path,
                                                            symbols);
              }
            else
              coefficient_values.back().push_back(value.number);
            symbols.push_back(coefficient.symbol);
          }
        for (const MaterialVariable &variable : material->variables())
          {
            const InitialValue &value = variable.initial_value;
            properties.back().push_back({variable, {}});
            if (value.varies())
              ground.check(
                properties.back().back().expression.emplace(
                  value.expression, value.path, symbols, ", or a number"),
                value.path);
            if (!variable.symbol.empty())
              symbols.push_back(variable.symbol);
          }
      }
  }


  template <int dim>
  std::vector<double>
  InitialProperties<dim>::at(const unsigned int material,
                             const Point<dim>  &x,
                             const unsigned int layer) const
  {
    return at(material, x, ground->at(x, layer), coefficients(material));
  }


  template <int dim>
  std::vector<double>
  InitialProperties<dim>::at(const unsigned int         material,
                             const Point<dim>          &x,
                             const InGround            &place,
                             const std::vector<double> &coefficients) const
  {
    std::vector<double> values, known = coefficients; // to those further down
    for (const Property &property : properties[material])
      {
        const double value = property.expression
                               ? property.expression->value(x, place, known)
                               : property.variable.initial_value.number;
        if (property.variable.role != MaterialVariable::Role::coefficient)
          values.push_back(value);
        if (!property.variable.symbol.empty())
          known.push_back(value);
      }
    return values;
  }


  template <int dim>
  bool
  InitialProperties<dim>::asks_for_stress(const unsigned int material) const
  {
    const std::vector<Property> &list = properties[material];
    return std::any_of(list.begin(), list.end(), [](const Property &property) {
      return property.expression && property.expression->asks_for_stress();
    });
  }


  template <int dim>
  void
  InitialProperties<dim>::set(const std::vector<unsigned int> &layers,
                              MaterialPoints<dim>             &points) const
  {
    for (unsigned int m = 0; m < properties.size(); ++m)
      {
        std::vector<const Property *> list; // of the variables alone
        for (const Property &property : properties[m])
          if (property.variable.role != MaterialVariable::Role::coefficient)
            list.push_back(&property);
        if (std::none_of(list.begin(),
                         list.end(),
                         [](const Property *property) {
                           return property->expression.has_value();
                         }))
          continue;
        for (std::size_t p = 0; p < points.n_points(); ++p)
          {
            if (points.material[p] != m)
              continue;
            const Point<dim>         &x      = points.initial_position[p];
            const std::vector<double> values = at(m, x, layers[p]);
            const auto                refuse = [&](const unsigned int v,
                                    const std::string &allowed) {
              const Property     &property = *list[v];
              const InitialValue &value = property.variable.initial_value;
              std::ostringstream  what;
              if (value.varies())
                what << "\"" << value.expression << "\" ";
              what << "is " << values[v] << " at the point " << place_text(x)
                   << " m";
              if (property.expression && property.expression->asks_for_stress())
                {
                  const InGround place = ground->at(x, layers[p]);
                  what << ", where vertical_stress is " << place.vertical_stress
                       << " and daily_vertical_stress "
                       << place.daily_vertical_stress << " kPa";
                  what << ground->why_uplifted(x, layers[p], place);
                }
              throw UserError(value.path, what.str(), allowed);
            };
            if (const auto problem = (*materials)[m]->initial_problem(values))
              refuse(problem->first, problem->second);
            // Soil that its water carries has no strength to speak of.
            for (unsigned int v = 0; v < values.size(); ++v)
              if (list[v]->expression && list[v]->expression->asks_for_stress())
                {
                  const InGround place = ground->at(x, layers[p]);
                  if (std::min(place.vertical_stress,
                               place.daily_vertical_stress) < -round_off)
                    refuse(v,
                           "soil that is heavy enough not to float up "
                           "(Saturated unit weight), or lower heads");
                }
            for (unsigned int v = 0; v < values.size(); ++v)
              points.scalar(list[v]->variable.name)[p] = values[v];
          }
      }
  }


  template class InitialProperties<2>;
  template class InitialProperties<3>;
} // namespace Waker
