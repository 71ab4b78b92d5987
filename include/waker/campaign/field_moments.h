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
  /// The largest value that a property can have: of angles 89 degrees, else no
  /// limit.
  double
  largest_possible(const FieldProperty property);

  /// Mean and standard deviation (of the property's unit) of a random field,
  /// anywhere in the soil.
  template <int dim>
  class FieldMoments
  {
  public:
    /// The first two are kept by reference.
    /// @throws UserError "Random fields/<name>/...": an unknown property, no
    /// expression
    FieldMoments(const Case<dim>             &the_case,
                 const RandomFieldParameters &field,
                 const unsigned int           material);

    /// At x, in the layer of this number. Not checked.
    std::pair<double, double>
    at(const Point<dim> &x, const unsigned int layer) const;

    /// The name of the property that varies, among the points' scalars.
    const std::string &
    variable_name() const
    {
      return name;
    }

    /// Can the property have this mean?
    bool
    is_possible(const double mean) const;

    /// The layer that x belongs to: one that holds it, of those that these
    /// points lie in, or any of them.
    unsigned int
    layer_at(const Point<dim> &x, const std::vector<std::size_t> &points) const;

  private:
    const Case<dim>                    *the_case;
    const RandomFieldParameters        *field;
    InitialProperties<dim>              own; // of the material
    unsigned int                        material;
    unsigned int                        variable;
    std::string                         name;      // of the variable
    std::optional<PlaceExpression<dim>> mean;      // none: the material's
    std::optional<PlaceExpression<dim>> deviation; // none: from the mean
  };
} // namespace Waker

#endif
