// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/expression_pattern.h>
#include <waker/base/numbers.h>
#include <waker/materials/factory.h>
#include <waker/particles/place_expression.h>

#include <cmath>

namespace Waker
{
  void
  MaterialParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Model",
               model,
               "linear elastic: no strength. von Mises softening: "
               "undrained strength c that falls from the initial to the "
               "residual value with plastic strain; plane-strain "
               "strength c, yield at q = sqrt(3) c.");
    prm.add_parameter("Unit weight",
                      unit_weight,
                      "Weight per volume (kN/m^3), above 0.",
                      Patterns::Double(0.));
    prm.add_parameter("Young's modulus",
                      youngs_modulus,
                      "Stiffness (kPa), above 0.",
                      Patterns::Double(0.));
    prm.add_parameter("Poisson's ratio",
                      poissons_ratio,
                      "Ratio of lateral to axial strain (-), above -1 and "
                      "below 0.5.",
                      Patterns::Double(-1., 0.5));
    prm.add_parameter("Initial strength",
                      initial_strength,
                      "Undrained shear strength c_i (kPa) before any plastic "
                      "strain, above 0: a number, or an expression of the "
                      "place at the start: x, y, z, depth below the highest "
                      "soil over it, depth_in_layer below the top of its layer "
                      "(m); for example \"8 + 1.5*depth_in_layer\".",
                      ExpressionPattern());
    prm.add_parameter("Residual strength",
                      residual_strength,
                      "Undrained shear strength c_r (kPa) after softening, at "
                      "least 0 and at most the initial strength: a number, or "
                      "an expression like that, in which initial_strength is "
                      "c_i at the place; for a sensitivity of 2.6: "
                      "\"initial_strength/2.6\".",
                      ExpressionPattern());
    prm.add_parameter("Softening modulus",
                      softening_modulus,
                      "Slope H_s = dc / d(plastic strain) (kPa), at most 0. 0: "
                      "no softening. Results depend on the cell size with it: "
                      "there is no regularisation.",
                      Patterns::Double());
    add_choice(prm,
               "Plastic strain invariant",
               plastic_strain_invariant,
               "Which measure of plastic strain e softens: equivalent = "
               "sqrt(2/3 e:e); half = sqrt(1/2 e:e), 13 % less for the "
               "same shear.");
  }


  namespace
  {
    /// A look at an expression before there is a place to evaluate it at.
    void
    check_expression(const std::string              &path,
                     const std::string              &text,
                     const std::vector<std::string> &more,
                     const unsigned int              dim)
    {
      if (plain_number(text))
        return;
      if (dim == 2)
        PlaceExpression<2>(text, path, more, ", or a number");
      else
        PlaceExpression<3>(text, path, more, ", or a number");
    }
  } // namespace


  void
  MaterialParameters::check(const unsigned int dim) const
  {
    const std::string path = "Materials/" + name + "/";
    const auto number = [](const double value) { return in_digits(value); };

    require_positive(path + "Unit weight", unit_weight, "kN/m^3");
    // Outside of this masses are no numbers that one can compute with.
    if (!(unit_weight >= 1e-9 && unit_weight <= 1e12))
      throw UserError(path + "Unit weight",
                      "is " + in_digits(unit_weight) + " kN/m^3",
                      "1e-9 to 1e12 kN/m^3; soils have 10 to 25");
    require_positive(path + "Young's modulus", youngs_modulus, "kPa");
    if (!(poissons_ratio > -1. && poissons_ratio < 0.5))
      throw UserError(path + "Poisson's ratio",
                      "is " + number(poissons_ratio),
                      "above -1 and below 0.5 (an incompressible soil: 0.49)");
    check_expression(path + "Initial strength", initial_strength, {}, dim);
    check_expression(path + "Residual strength",
                     residual_strength,
                     {"initial_strength"},
                     dim);
    if (model == MaterialModel::linear_elastic)
      return;

    // Expressions are read where the points are.
    const std::optional<double> initial  = plain_number(initial_strength);
    const std::optional<double> residual = plain_number(residual_strength);
    if (initial)
      require_positive(path + "Initial strength", *initial, "kPa");
    if (residual &&
        !(*residual >= 0. && *residual <= initial.value_or(*residual)))
      throw UserError(path + "Residual strength",
                      "is " + number(*residual) +
                        " kPa, the initial strength " + initial_strength +
                        " kPa",
                      "from 0 to the initial strength");
    if (!(softening_modulus <= 0.))
      throw UserError(path + "Softening modulus",
                      "is " + number(softening_modulus) + " kPa",
                      "a negative number, or 0 for no softening");

    // The return to the yield surface, (sqrt(3) c - q) / (3 G + H'), must
    // exist: no snap-back of a point. H' = dq / d(lambda).
    const double shear_modulus = youngs_modulus / (2. * (1. + poissons_ratio));
    const double strain_per_lambda =
      plastic_strain_invariant == VonMisesSoftening::Invariant::half
        ? std::sqrt(3.) / 2.
        : 1.;
    const double limit =
      -3. * shear_modulus / (std::sqrt(3.) * strain_per_lambda);
    if (!(softening_modulus > limit))
      throw UserError(path + "Softening modulus",
                      "is " + number(softening_modulus) +
                        " kPa: steeper than the elastic unloading (snap-back)",
                      "above " + number(limit) +
                        " kPa with this Young's modulus and Poisson's ratio");
  }
} // namespace Waker
