// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_field_moments_h
#define waker_campaign_field_moments_h

#include <waker/case/case.h>
#include <waker/case/initial_properties.h>
#include <waker/fields/parameters.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Waker
{
  /// The largest value that a property can have: of angles 89 degrees, of an
  /// exponent 1, else no limit.
  double
  largest_possible(const FieldProperty property);

  /// What a random field may vary of a material: variables of its law,
  /// coefficients of these, or what the material is without a law.
  struct RandomProperty
  {
    enum class Kind
    {
      variable,
      coefficient,
      unit_weight,
      stiffness
    };

    Kind         kind;
    unsigned int number; // of a variable or coefficient, in the law's order
    std::string  name;
    std::string  unit;
  };

  /// Nothing if the material does not have it.
  template <int dim>
  std::optional<RandomProperty>
  random_property(const Case<dim>    &the_case,
                  const unsigned int  material,
                  const FieldProperty property);

  /// The materials whose points a field is for.
  /// @throws UserError "Random fields/<name>/..."
  template <int dim>
  std::vector<unsigned int>
  materials_of(const Case<dim> &the_case, const RandomFieldParameters &field);

  /// Mean and standard deviation (of the property's unit) of a random field,
  /// anywhere in the soil.
  template <int dim>
  class FieldMoments
  {
  public:
    /// @param the_case must outlive this object
    /// @throws UserError "Random fields/<name>/...": an unknown property, no
    /// expression
    FieldMoments(const Case<dim>             &the_case,
                 const RandomFieldParameters &field,
                 const unsigned int           material);

    /// At x, in the layer of this number. Not checked.
    std::pair<double, double>
    at(const Point<dim> &x, const unsigned int layer) const;

    /// The property that varies; the points have a scalar of its name.
    const RandomProperty &
    varied() const
    {
      return property;
    }

    /// The material's value at x, whatever mean the field has.
    double
    of_material(const Point<dim> &x, const InGround &place) const;

    /// Can the property have this mean?
    bool
    is_possible(const double mean) const;

    /// The layer that x belongs to: one that holds it, of those that these
    /// points lie in, or any of them.
    unsigned int
    layer_at(const Point<dim> &x, const std::vector<std::size_t> &points) const;

  private:
    const Case<dim>                    *the_case;
    RandomFieldParameters               field;
    InitialProperties<dim>              own; // of the material
    unsigned int                        material;
    RandomProperty                      property;
    std::optional<PlaceExpression<dim>> mean;      // none: the material's
    std::optional<PlaceExpression<dim>> deviation; // none: from the mean
  };
} // namespace Waker

#endif
