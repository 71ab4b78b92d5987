// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/expression_pattern.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/fields/parameters.h>

namespace Waker
{
  void
  RandomFieldParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Material",
                      material,
                      "Name of the material whose points get the field, or "
                      "several, separated by commas, or all: those that have "
                      "the property. One field then runs through all of them, "
                      "with the same normal scores and each one's own mean. "
                      "Empty: the only material there is.",
                      Patterns::Anything());
    add_choice(
      prm,
      "Property",
      property,
      "The property that varies, one that the law of the material "
      "has. A field of a strength takes what is left of it after "
      "softening with it, in the ratio that the material has (fully "
      "correlated), unless that has a field of its own. Angles are "
      "in degrees, and cut off at 89. Strength ratio, strength "
      "exponent and POP (kPa) are those of Strength from = SHANSEP, "
      "strength at top (kPa) and strength growth (kPa/m) those of "
      "depth and depth in layer: each point gets the strength that "
      "follows from them. Modified Cam clay has a friction angle, OCR (-; below 1 "
      "it counts as 1) and POP, or, instead of these two, a preconsolidation "
      "pressure (kPa). Strength factor (-): by which a Shear "
      "strength table is multiplied, on the average 1. Unit weight (kN/m^3; what is below the "
      "phreatic line varies in the same ratio): also masses, the "
      "vertical stress and the initial stress follow. Young's "
      "modulus (kPa): also the initial stress.");
    prm.add_parameter(
      "Mean",
      mean,
      "Mean (of the property's unit): a number, or an expression of x, y, z, "
      "depth, depth_in_layer (m), vertical_stress, "
      "daily_vertical_stress (kPa; see Materials/<name>/Initial "
      "strength), for example \"5 + 1.5*depth\". Empty: the "
      "material's own value. Of a unit weight a number, or nothing.",
      ExpressionPattern());
    prm.add_parameter(
      "Coefficient of variation",
      coefficient_of_variation,
      "Standard deviation divided by the mean of the place (-), "
      "0 or more.",
      Patterns::Double(0.));
    prm.add_parameter("Standard deviation",
                      standard_deviation,
                      "Not 0: standard deviation (in that unit) instead of the "
                      "coefficient of variation: a number, or an expression "
                      "like that of the mean.",
                      ExpressionPattern());
    add_choice(prm,
               "Statistics of",
               statistics,
               "What the standard deviation belongs to: the cells, which "
               "are averages, or the points of the field. Averaging "
               "reduces that of the points (0.20 becomes 0.185 for the "
               "dyke of chapter 5).");
    add_choice(prm,
               "Distribution",
               distribution,
               "\"normal\" and \"lognormal\" are cut off at the limits, "
               "\"truncated normal\" is conditional on them, \"beta\" "
               "lies between them.");
    prm.add_parameter("Minimum",
                      minimum,
                      "Least value (in the property's unit), 0 or more; of a "
                      "unit weight or Young's modulus above 0, unless it is "
                      "lognormal.",
                      Patterns::Double(0.));
    prm.add_parameter("Maximum",
                      maximum,
                      "Largest value (in the property's unit).",
                      Patterns::Double(0.));
    prm.add_parameter("Local share",
                      local_share,
                      "Share of the variance (-), 0 to 1, that varies from "
                      "place to place; the rest is of the average of the "
                      "soil, one random number per realisation, which the "
                      "records keep. 1: a field without it. 0: nothing but "
                      "it, the same everywhere.",
                      Patterns::Double(0., 1.));
    add_choice(prm,
               "Correlation function",
               correlation,
               "\"Markov\": exp(-2 r), r from lags divided by scales "
               "(ellipsoidal); \"separable Markov\": a product of one per "
               "direction; \"Gaussian\": exp(-pi r^2).");
    prm.add_parameter("Scales of fluctuation",
                      scales,
                      "Horizontal and vertical scale (m), above 0; in 3D those "
                      "along x, y (vertical) and z.",
                      Patterns::List(Patterns::Double(0.), 1, 3));
    prm.add_parameter(
      "Cell size",
      cell_size,
      "Size of the field's cells (m), one number per direction. "
      "Empty: that of the points' support domains, one cell per "
      "point.",
      Patterns::List(Patterns::Double(0.), 0, 3));
    add_choice(prm,
               "Generator",
               generator,
               "\"circulant embedding\": exact, fast. \"local average "
               "subdivision\": as in the thesis, with a pattern in the "
               "variance. \"Cholesky\": exact, for small fields.");
    prm.add_parameter(
      "Measurements",
      measurements,
      "File of measured values, one \"x, y, value\" (3D: \"x, y, "
      "z, value\"; m, kPa) a line: every realisation has them "
      "there. Empty: none.",
      Patterns::FileName(Patterns::FileName::input));
    prm.add_parameter("Measurement error",
                      measurement_error,
                      "Standard deviation of the measurements, as a share of "
                      "that of the field (-), 0 or more.",
                      Patterns::Double(0.));
  }


  std::vector<std::string>
  RandomFieldParameters::material_names() const
  {
    return split(material, ',');
  }


  bool
  RandomFieldParameters::has_standard_deviation() const
  {
    return plain_number(standard_deviation).value_or(1.) != 0.;
  }


  void
  RandomFieldParameters::check(const unsigned int dim) const
  {
    const std::string path = "Random fields/" + name;
    const auto text = [](const double value) { return in_digits(value); };
    if (scales.size() != dim)
      throw UserError(path + "/Scales of fluctuation",
                      "has " + counted(scales.size(), "number"),
                      std::to_string(dim) + " numbers above 0" +
                        decimals_with_a_point);
    for (const double scale : scales)
      if (!(scale > 0.))
        throw UserError(path + "/Scales of fluctuation",
                        "contains " + text(scale),
                        "numbers above 0");
    if (!cell_size.empty() && cell_size.size() != dim)
      throw UserError(path + "/Cell size",
                      "has " + counted(cell_size.size(), "number"),
                      "nothing, or " + std::to_string(dim) +
                        " numbers above 0" + decimals_with_a_point);
    for (const double size : cell_size)
      if (!(size > 0.))
        throw UserError(path + "/Cell size",
                        "contains " + text(size),
                        "numbers above 0");
    if (!(local_share >= 0. && local_share <= 1.))
      throw UserError(path + "/Local share",
                      "is " + text(local_share),
                      "0 to 1");
    if (!(maximum > minimum))
      throw UserError(path + "/Maximum",
                      "is " + text(maximum),
                      "a number above Minimum, " + text(minimum));
    if (distribution == Marginal::Kind::beta && !(maximum < 1e299))
      throw UserError(path + "/Maximum",
                      "is not given",
                      "a number above Minimum: a beta distribution lies "
                      "between the two");
    if (property == FieldProperty::unit_weight ||
        property == FieldProperty::youngs_modulus)
      {
        if (distribution != Marginal::Kind::lognormal && !(minimum > 0.))
          throw UserError(path + "/Minimum",
                          "is " + text(minimum) + " of a " + name_of(property) +
                            ", whose \"" + std::string(name_of(distribution)) +
                            "\" distribution reaches down to it",
                          "a number above 0, or a lognormal distribution");
      }
    if (property == FieldProperty::unit_weight)
      {
        // The weight of a column is summed up cell by cell.
        if (!mean.empty() && !plain_number(mean))
          throw UserError(path + "/Mean",
                          "is " + in_quotes(mean) + ", of a unit weight",
                          "a number (kN/m^3), or nothing: the material's own");
        if (!plain_number(standard_deviation))
          throw UserError(path + "/Standard deviation",
                          "is " + in_quotes(standard_deviation) +
                            ", of a unit weight",
                          "a number (kN/m^3)");
      }
    // Its scores vary less than a standard normal number: these two
    // distributions would keep neither mean nor form.
    if (statistics == FieldStatistics::points &&
        (distribution == Marginal::Kind::beta ||
         distribution == Marginal::Kind::truncated_normal))
      throw UserError(path + "/Statistics of",
                      "is \"points\" with the distribution \"" +
                        std::string(name_of(distribution)) +
                        "\", whose averages are not known",
                      "cells; points with a normal or lognormal distribution");
  }


  void
  RandomFieldsParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Correlations",
      correlations,
      "Correlation of the normal scores of two fields at the "
      "same place, \"a, b: 0.5; a, c: -0.2\", -1 to 1; those not "
      "named are independent. Correlated fields must have the "
      "same correlation function, scales, cells, generator, "
      "statistics and local share.",
      Patterns::Anything());
  }


  std::vector<double>
  RandomFieldsParameters::correlation_matrix() const
  {
    const std::size_t   n = fields.size();
    std::vector<double> matrix(n * n, 0.);
    for (std::size_t i = 0; i < n; ++i)
      matrix[i * n + i] = 1.;

    const auto refuse = [](const std::string &problem) {
      throw UserError(
        "Random fields/Correlations",
        problem,
        "\"a, b: 0.5; ...\" with two names of fields and a number "
        "from -1 to 1, each pair once" +
          std::string(decimals_with_a_point));
    };
    const auto number = [&](const std::string &field) {
      for (std::size_t i = 0; i < n; ++i)
        if (fields[i].name == field)
          return i;
      refuse("names \"" + field + "\", which is no field");
      return n;
    };

    for (const std::string &item : split(correlations, ';'))
      {
        if (item.empty())
          continue;
        const std::size_t comma = item.find(','), colon = item.rfind(':');
        if (comma == std::string::npos || colon == std::string::npos ||
            comma > colon)
          refuse("contains " + in_quotes(item));
        const std::size_t a = number(tidy(item.substr(0, comma)));
        const std::size_t b =
          number(tidy(item.substr(comma + 1, colon - comma - 1)));
        const std::string value = tidy(item.substr(colon + 1));
        double            rho   = 0.;
        if (!read_number(value, rho) || !(rho >= -1. && rho <= 1.))
          refuse("contains " + in_quotes(item));
        if (a == b || matrix[a * n + b] != 0.)
          refuse("gives the pair \"" + item +
                 "\" twice, or a field with itself");
        matrix[a * n + b] = matrix[b * n + a] = rho;
      }
    return matrix;
  }


  void
  RandomFieldsParameters::check(const unsigned int dim) const
  {
    for (const RandomFieldParameters &field : fields)
      field.check(dim);

    const std::size_t         n      = fields.size();
    const std::vector<double> matrix = correlation_matrix();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j)
        {
          const RandomFieldParameters &a = fields[j], &b = fields[i];
          const bool                   same_target =
            a.material == b.material && a.property == b.property;
          if (same_target)
            throw UserError("Random fields/" + b.name + "/Property",
                            "is \"" + std::string(name_of(b.property)) +
                              "\", of which the material has a field already, "
                              "\"" +
                              a.name + "\"",
                            "one field per property and material");
          if (matrix[i * n + j] == 0.)
            continue;
          if (a.correlation != b.correlation || a.scales != b.scales ||
              a.cell_size != b.cell_size || a.generator != b.generator ||
              a.statistics != b.statistics || a.local_share != b.local_share)
            throw UserError("Random fields/Correlations",
                            "correlates \"" + a.name + "\" and \"" + b.name +
                              "\", which are made in different ways",
                            "the same correlation function, scales, cell size, "
                            "generator, statistics and local share for both");
          if (!b.measurements.empty())
            throw UserError("Random fields/" + b.name + "/Measurements",
                            "of a field that is correlated with one before it",
                            "measurements of the first of correlated fields");
        }
  }
} // namespace Waker
