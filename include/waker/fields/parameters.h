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

  /// What may vary: a variable or a coefficient of a material, of this name;
  /// or its weight.
  enum class FieldProperty
  {
    strength,
    residual_strength,
    cohesion,
    residual_cohesion,
    friction_angle,
    residual_friction_angle,
    dilatancy_angle,
    residual_dilatancy_angle,
    strength_ratio,
    strength_exponent,
    pop,
    ocr,
    preconsolidation_pressure,
    strength_at_top,
    strength_growth,
    strength_factor,
    unit_weight,
    youngs_modulus
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
        case FieldProperty::dilatancy_angle:
          return "dilatancy angle";
        case FieldProperty::residual_dilatancy_angle:
          return "residual dilatancy angle";
        case FieldProperty::strength_ratio:
          return "strength ratio";
        case FieldProperty::strength_exponent:
          return "strength exponent";
        case FieldProperty::pop:
          return "POP";
        case FieldProperty::ocr:
          return "OCR";
        case FieldProperty::preconsolidation_pressure:
          return "preconsolidation pressure";
        case FieldProperty::strength_at_top:
          return "strength at top";
        case FieldProperty::strength_growth:
          return "strength growth";
        case FieldProperty::strength_factor:
          return "strength factor";
        case FieldProperty::unit_weight:
          return "unit weight";
        case FieldProperty::youngs_modulus:
          return "Young's modulus";
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

    /// Names of "Materials/Names", or "all" that have the property; empty: the
    /// only one.
    std::string   material;
    FieldProperty property = FieldProperty::strength; // of the material
    /// Expression of the place (PlaceExpression); empty: the material's own
    /// value.
    std::string mean;
    double      coefficient_of_variation = 0.2; // of the mean at that place
    /// Unless "0": instead of the former (kPa), likewise an expression.
    std::string     standard_deviation = "0";
    FieldStatistics statistics         = FieldStatistics::cells;
    Marginal::Kind  distribution       = Marginal::Kind::normal;
    double          minimum            = 0.;
    double          maximum            = 1e300;
    /// Share of the variance that varies from place to place; the rest is of
    /// the average, one number per realisation.
    double                local_share = 1.;
    Correlation::Function correlation = Correlation::Function::markov;
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

    /// The materials that it names, without spaces around them.
    std::vector<std::string>
    material_names() const;

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
