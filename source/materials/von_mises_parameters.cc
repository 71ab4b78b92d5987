// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/materials/von_mises_softening.h>

#include "initial_expression.h"
#include <cmath>

namespace Waker
{
  void
  VonMisesSofteningParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Initial strength",
                      initial_strength,
                      "Undrained shear strength c_i (kPa) before any plastic "
                      "strain, above 0: a number, or an expression of the "
                      "place at the start: x, y, z, depth below the highest "
                      "soil over it, depth_in_layer below the top of its layer "
                      "(m), vertical_stress and daily_vertical_stress (kPa, "
                      "effective, see Strength from); for example \"8 + "
                      "1.5*depth_in_layer\".",
                      ExpressionPattern());
    strength.add_parameters(prm);
    prm.add_parameter("Residual strength",
                      residual_strength,
                      "Undrained shear strength c_r (kPa) after softening, at "
                      "least 0 and at most the initial strength: a number, or "
                      "an expression like that, in which initial_strength is "
                      "c_i at the place; for a sensitivity of 2.6: "
                      "\"initial_strength/2.6\".",
                      ExpressionPattern());
    prm.add_parameter(
      "Softening modulus",
      softening_modulus,
      "Slope H_s = dc / d(plastic strain) (kPa), at most 0. 0: "
      "no softening. It belongs to the cell size, unless there is "
      "a softening length, or nonlocal softening.",
      Patterns::Double());
    add_choice(prm,
               "Plastic strain invariant",
               plastic_strain_invariant,
               "Which measure of plastic strain e softens: equivalent = "
               "sqrt(2/3 e:e); half = sqrt(1/2 e:e), 13 % less for the "
               "same shear.");
  }


  void
  VonMisesSofteningParameters::check_expressions(const std::string &path,
                                                 const unsigned int dim) const
  {
    check_expression(path + "Initial strength", initial_strength, {}, dim);
    strength.check(path);
    check_expression(path + strength.name_of_parameter(),
                     strength_expression(path),
                     {},
                     dim);
    check_expression(path + "Residual strength",
                     residual_strength,
                     {"initial_strength"},
                     dim);
  }


  void
  VonMisesSofteningParameters::check(const std::string             &path,
                                     const LinearElasticParameters &elastic,
                                     const double softening_scale) const
  {
    if (strength.from == StrengthFrom::shansep)
      require_positive(path + "Strength ratio", strength.ratio);
    // Expressions are read where the points are.
    const std::optional<double> initial =
      plain_number(strength_expression(path));
    const std::optional<double> residual = plain_number(residual_strength);
    if (initial)
      require_positive(path + "Initial strength", *initial, "kPa");
    if (residual &&
        !(*residual >= 0. && *residual <= initial.value_or(*residual)))
      throw UserError(path + "Residual strength",
                      "is " + in_digits(*residual) +
                        " kPa, the initial strength " +
                        strength_expression(path) + " kPa",
                      "from 0 to the initial strength");
    if (!(softening_modulus <= 0.))
      throw UserError(path + "Softening modulus",
                      "is " + in_digits(softening_modulus) + " kPa",
                      "a negative number, or 0 for no softening");

    // A point must not snap back: the return to the yield surface must exist.
    const double limit = -snap_back_modulus(elastic, softening_scale);
    if (!(softening_modulus > limit))
      throw UserError(path + "Softening modulus",
                      "is " + in_digits(softening_modulus) +
                        " kPa: steeper than the elastic unloading (snap-back)",
                      "above " + in_digits(limit) +
                        " kPa with this Young's modulus and Poisson's ratio" +
                        (softening_scale != 1.
                           ? ", this cell size and softening length"
                           : ""));
  }


  double
  VonMisesSofteningParameters::snap_back_modulus(
    const LinearElasticParameters &elastic,
    const double                   softening_scale) const
  {
    // Of the return (sqrt(3) c - q) / (3 G + H'), with H' = dq / d(lambda).
    const double strain_per_lambda =
      plastic_strain_invariant == VonMisesSoftening::Invariant::half
        ? std::sqrt(3.) / 2.
        : 1.;
    return 3. * elastic.shear_modulus() /
           (std::sqrt(3.) * strain_per_lambda * softening_scale);
  }


  std::unique_ptr<Material>
  make_von_mises_softening(const double                       density,
                           const LinearElasticParameters     &elastic,
                           const VonMisesSofteningParameters &parameters,
                           const SofteningMeasure            &measure,
                           const std::string                 &path)
  {
    std::optional<InitialValue> overconsolidation;
    const std::string ratio = parameters.strength.overconsolidation(true);
    if (!ratio.empty())
      overconsolidation = initial_value(ratio, path + "POP");
    auto law = std::make_unique<VonMisesSoftening>(
      density,
      elastic.youngs_modulus,
      elastic.poissons_ratio,
      initial_value(parameters.strength.symbolic_expression(
                      parameters.initial_strength, path),
                    path + parameters.strength.name_of_parameter()),
      initial_value(parameters.residual_strength, path + "Residual strength"),
      parameters.softening_modulus,
      parameters.plastic_strain_invariant,
      overconsolidation,
      measure,
      parameters.strength.coefficients(path));
    if (elastic.varies)
      law->let_stiffness_vary();
    return law;
  }
} // namespace Waker
