// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/campaign/field_moments.h>

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
          return 89.;
        case FieldProperty::strength:
        case FieldProperty::residual_strength:
        case FieldProperty::cohesion:
        case FieldProperty::residual_cohesion:
          return std::numeric_limits<double>::infinity();
      }
    AssertThrow(false, ExcInternalError());
    return 0.;
  }


  namespace
  {
    /// The number of the property among its material's variables.
    template <int dim>
    unsigned int
    variable_number(const Case<dim>             &the_case,
                    const unsigned int           material,
                    const RandomFieldParameters &field)
    {
      const std::vector<MaterialVariable> variables =
        the_case.materials[material]->variables();
      for (unsigned int v = 0; v < variables.size(); ++v)
        if (variables[v].name == name_of(field.property))
          return v;
      std::string varying;
      for (const MaterialVariable &variable : variables)
        if (is_strength(variable.role))
          varying += (varying.empty() ? "" : ", ") + variable.name;
      throw UserError("Random fields/" + field.name + "/Property",
                      "is \"" + std::string(name_of(field.property)) +
                        "\", which the material \"" +
                        the_case.parameters.materials[material].name +
                        "\" does not have",
                      varying.empty() ? "a material with a strength"
                                      : "a strength that it has: " + varying);
    }
  } // namespace


  template <int dim>
  FieldMoments<dim>::FieldMoments(const Case<dim>             &the_case,
                                  const RandomFieldParameters &field,
                                  const unsigned int           material)
    : the_case(&the_case)
    , field(&field)
    , own(the_case.materials, the_case.ground)
    , material(material)
    , variable(variable_number(the_case, material, field))
    , name(the_case.materials[material]->variables()[variable].name)
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
    const double   m =
      mean ? mean->value(x, place) : own.at(material, x, layer)[variable];
    return {m,
            deviation ? deviation->value(x, place)
                      : field->coefficient_of_variation * m};
  }


  template <int dim>
  bool
  FieldMoments<dim>::is_possible(const double mean) const
  {
    // Only an undrained strength is all that there is.
    return std::isfinite(mean) &&
           (field->property == FieldProperty::strength ? mean > 0.
                                                       : mean >= 0.);
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


  template class FieldMoments<2>;
  template class FieldMoments<3>;
} // namespace Waker
