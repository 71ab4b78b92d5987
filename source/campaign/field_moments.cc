// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/campaign/field_moments.h>
#include <waker/materials/mohr_coulomb.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Waker
{
  double
  largest_possible(const FieldProperty property)
  {
    switch (property)
      {
        case FieldProperty::friction_angle:
        case FieldProperty::residual_friction_angle:
        case FieldProperty::dilatancy_angle:
        case FieldProperty::residual_dilatancy_angle:
          return largest_friction_angle;
        case FieldProperty::strength_exponent:
          return 1.;
        case FieldProperty::strength:
        case FieldProperty::residual_strength:
        case FieldProperty::cohesion:
        case FieldProperty::residual_cohesion:
        case FieldProperty::strength_ratio:
        case FieldProperty::pop:
        case FieldProperty::ocr:
        case FieldProperty::preconsolidation_pressure:
        case FieldProperty::strength_at_top:
        case FieldProperty::strength_growth:
        case FieldProperty::strength_factor:
        case FieldProperty::unit_weight:
        case FieldProperty::youngs_modulus:
          return std::numeric_limits<double>::infinity();
      }
    AssertThrow(false, ExcInternalError());
    return 0.;
  }


  namespace
  {
    /// Can it not be 0 on the average?
    bool
    is_positive(const FieldProperty property)
    {
      return property == FieldProperty::strength ||
             property == FieldProperty::strength_ratio ||
             property == FieldProperty::strength_factor ||
             property == FieldProperty::unit_weight ||
             property == FieldProperty::youngs_modulus;
    }


    /// All properties that a material has, for an error.
    template <int dim>
    std::string
    properties_of(const Case<dim> &the_case, const unsigned int material)
    {
      std::string names;
      for (const MaterialVariable &variable :
           the_case.materials[material]->variables())
        if (is_strength(variable.role) ||
            variable.role == MaterialVariable::Role::dilatancy)
          names += variable.name + ", ";
      for (const MaterialVariable &coefficient :
           the_case.materials[material]->coefficients())
        if (!coefficient.initial_value.varies())
          names += coefficient.name + ", ";
      return names + name_of(FieldProperty::unit_weight) + ", " +
             name_of(FieldProperty::youngs_modulus);
    }


    template <int dim>
    RandomProperty
    required_property(const Case<dim>             &the_case,
                      const unsigned int           material,
                      const RandomFieldParameters &field)
    {
      if (const auto found =
            random_property(the_case, material, field.property))
        return *found;
      throw UserError("Random fields/" + field.name + "/Property",
                      "is \"" + std::string(name_of(field.property)) +
                        "\", which the material \"" +
                        the_case.parameters.materials[material].name +
                        "\" does not have",
                      "one that it has: " + properties_of(the_case, material));
    }
  } // namespace


  template <int dim>
  std::optional<RandomProperty>
  random_property(const Case<dim>    &the_case,
                  const unsigned int  material,
                  const FieldProperty property)
  {
    using Kind             = RandomProperty::Kind;
    const std::string name = name_of(property);
    if (property == FieldProperty::unit_weight)
      return RandomProperty{Kind::unit_weight, 0, name, "kN/m^3"};
    if (property == FieldProperty::youngs_modulus)
      {
        if (the_case.materials[material]->stiffness_variable())
          return RandomProperty{Kind::stiffness, 0, name, "kPa"};
        return {};
      }
    const auto find = [&](const std::vector<MaterialVariable> &list,
                          const Kind kind) -> std::optional<RandomProperty> {
      for (unsigned int v = 0; v < list.size(); ++v)
        if (list[v].name == name)
          return RandomProperty{kind, v, name, list[v].unit};
      return {};
    };
    const Material &law = *the_case.materials[material];
    if (const auto found = find(law.variables(), Kind::variable))
      return found;
    return find(law.coefficients(), Kind::coefficient);
  }


  template <int dim>
  std::vector<unsigned int>
  materials_of(const Case<dim> &the_case, const RandomFieldParameters &field)
  {
    const auto                    &materials = the_case.parameters.materials;
    const std::string              path      = "Random fields/" + field.name;
    const std::vector<std::string> names     = field.material_names();
    std::vector<unsigned int>      numbers;
    if (names == std::vector<std::string>{"all"})
      {
        for (unsigned int m = 0; m < materials.size(); ++m)
          if (random_property(the_case, m, field.property))
            numbers.push_back(m);
        if (numbers.empty())
          throw UserError(path + "/Property",
                          "is \"" + std::string(name_of(field.property)) +
                            "\", which no material has",
                          "one that a material has: of the first " +
                            properties_of(the_case, 0));
        return numbers;
      }
    if (tidy(field.material).empty() && materials.size() == 1)
      return {0};

    std::string all;
    for (const auto &material : materials)
      all += (all.empty() ? "" : ", ") + material.name;
    for (const std::string &name : names)
      {
        const auto found =
          std::find_if(materials.begin(), materials.end(), [&](const auto &m) {
            return m.name == name;
          });
        const unsigned int m = found - materials.begin();
        const bool         again =
          std::find(numbers.begin(), numbers.end(), m) != numbers.end();
        if (found == materials.end() || again)
          throw UserError(path + "/Material",
                          "is \"" + field.material + "\"" +
                            (again ? ", which names one twice" : ""),
                          "some of the materials: " + all + "; or all");
        numbers.push_back(m);
      }
    if (numbers.empty())
      throw UserError(path + "/Material",
                      "is \"" + field.material + "\"",
                      "some of the materials: " + all + "; or all");
    return numbers;
  }


  template <int dim>
  FieldMoments<dim>::FieldMoments(const Case<dim>             &the_case,
                                  const RandomFieldParameters &field,
                                  const unsigned int           material)
    : the_case(&the_case)
    , field(field)
    , own(the_case.materials, the_case.ground)
    , material(material)
    , property(required_property(the_case, material, field))
  {
    const std::string              path = "Random fields/" + field.name;
    const std::vector<std::string> none;
    if (!field.mean.empty())
      the_case.ground.check(mean.emplace(field.mean,
                                         path + "/Mean",
                                         none,
                                         ", nothing, or a number"),
                            path + "/Mean");
    if (field.has_standard_deviation())
      the_case.ground.check(deviation.emplace(field.standard_deviation,
                                              path + "/Standard deviation",
                                              none,
                                              ", or a number"),
                            path + "/Standard deviation");
  }


  template <int dim>
  std::pair<double, double>
  FieldMoments<dim>::at(const Point<dim> &x, const unsigned int layer) const
  {
    const InGround place = the_case->ground.at(x, layer);
    const double   m     = mean ? mean->value(x, place) : of_material(x, place);
    return {m,
            deviation ? deviation->value(x, place)
                      : field.coefficient_of_variation * m};
  }


  template <int dim>
  double
  FieldMoments<dim>::of_material(const Point<dim> &x,
                                 const InGround   &place) const
  {
    const MaterialParameters &parameters =
      the_case->parameters.materials[material];
    switch (property.kind)
      {
        case RandomProperty::Kind::variable:
          return own.at(material,
                        x,
                        place,
                        own.coefficients(material))[property.number];
        case RandomProperty::Kind::coefficient:
          return own.coefficients(material)[property.number];
        case RandomProperty::Kind::unit_weight:
          return parameters.unit_weight;
        case RandomProperty::Kind::stiffness:
          return parameters.elastic.youngs_modulus;
      }
    AssertThrow(false, ExcInternalError());
    return nan;
  }


  template <int dim>
  bool
  FieldMoments<dim>::is_possible(const double mean) const
  {
    return std::isfinite(mean) &&
           (is_positive(field.property) ? mean > 0. : mean >= 0.);
  }


  template <int dim>
  unsigned int
  FieldMoments<dim>::layer_at(const Point<dim>               &x,
                              const std::vector<std::size_t> &points) const
  {
    const unsigned int n_layers = the_case->ground.depths().n_layers();
    unsigned int       layer    = n_layers;
    for (const std::size_t q : points)
      {
        layer = the_case->layers_of_points[q];
        if (layer < n_layers && the_case->ground.depths().holds(x, layer))
          break;
      }
    return layer;
  }


  template std::optional<RandomProperty>
  random_property(const Case<2> &, const unsigned int, const FieldProperty);
  template std::optional<RandomProperty>
  random_property(const Case<3> &, const unsigned int, const FieldProperty);
  template std::vector<unsigned int>
  materials_of(const Case<2> &, const RandomFieldParameters &);
  template std::vector<unsigned int>
  materials_of(const Case<3> &, const RandomFieldParameters &);
  template class FieldMoments<2>;
  template class FieldMoments<3>;
} // namespace Waker
