// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_fields_parameters_h
#define waker_fields_parameters_h

#include <waker/fields/correlation.h>
#include <waker/fields/field_generator.h>
#include <waker/fields/marginal.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  /// What may vary: a variable of a material, of this name.
  enum class FieldProperty
  {
    strength,
    residual_strength,
    cohesion,
    residual_cohesion,
    friction_angle,
    residual_friction_angle
  };

  constexpr const char *
  name_of(const FieldProperty choice)
  {
    switch (choice)
      {
        case FieldProperty::strength:
          return "undrained shear strength";
        case FieldProperty::residual_strength:
          return "residual strength";
        case FieldProperty::cohesion:
          return "cohesion";
        case FieldProperty::residual_cohesion:
          return "residual cohesion";
        case FieldProperty::friction_angle:
          return "friction angle";
        case FieldProperty::residual_friction_angle:
          return "residual friction angle";
      }
    return nullptr;
  }


  /// What the spread of a field belongs to.
  enum class FieldStatistics
  {
    cells, // averages
    points
  };

  constexpr const char *
  name_of(const FieldStatistics choice)
  {
    switch (choice)
      {
        case FieldStatistics::cells:
          return "cells";
        case FieldStatistics::points:
          return "points";
      }
    return nullptr;
  }


  /// A property that varies randomly: subsection "Random fields/<name>".
  struct RandomFieldParameters
  {
    std::string name; // of the subsection

    std::string   material; // a name of "Materials/Names"; empty: the only one
    FieldProperty property = FieldProperty::strength; // of the material
    /// Expression of the place (PlaceExpression); empty: the material's own
    /// value.
    std::string mean;
    double      coefficient_of_variation = 0.2; // of the mean at that place
    /// Unless "0": instead of the former (kPa), likewise an expression.
    std::string           standard_deviation = "0";
    FieldStatistics       statistics         = FieldStatistics::cells;
    Marginal::Kind        distribution       = Marginal::Kind::normal;
    double                minimum            = 0.;
    double                maximum            = 1e300;
    Correlation::Function correlation        = Correlation::Function::markov;
    /// Scales of fluctuation (m), horizontal first, then vertical; in 3D x, y,
    /// z, where y is vertical.
    std::vector<double> scales = {24., 0.5};
    /// Size of the field's cells (m); empty: of the points' support domains.
    std::vector<double> cell_size;
    Generator           generator = Generator::circulant_embedding;
    /// File with measured values, "x, y[, z], value" a line; empty: none.
    std::string measurements;
    double      measurement_error = 0.; // standard deviation, in normal scores

    void
    add_parameters(ParameterHandler &prm);

    /// Instead of the coefficient of variation?
    bool
    has_standard_deviation() const;

    /// @throws UserError "Random fields/<name>/..."
    void
    check(const unsigned int dim) const;
  };

  /// Section "Random fields".
  struct RandomFieldsParameters
  {
    std::vector<RandomFieldParameters> fields;
    /// "a, b: 0.5; a, c: -0.2": of the normal scores of two fields at a place.
    std::string correlations;

    /// The entries of the section itself, without names and subsections.
    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError "Random fields/..."
    void
    check(const unsigned int dim) const;

    /// The correlations as a full matrix, row by row (n x n, n fields).
    /// @throws UserError "Random fields/Correlations"
    std::vector<double>
    correlation_matrix() const;
  };
} // namespace Waker

#endif
