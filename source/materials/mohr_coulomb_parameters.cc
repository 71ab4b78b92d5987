// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/materials/mohr_coulomb.h>
#include <waker/materials/shear_strength_table.h>

#include "initial_expression.h"
#include "mohr_coulomb_return.h"
#include <cmath>
#include <limits>

namespace Waker
{
  namespace
  {
    const char *const apex = "apex";
  }


  void
  MohrCoulombParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Cohesion",
                      cohesion,
                      "Cohesion c (kPa) before any plastic strain, at least 0: "
                      "a number, or an expression as of Initial strength.",
                      ExpressionPattern());
    prm.add_parameter(
      "Friction angle",
      friction_angle,
      "Angle of internal friction phi (degrees) before any "
      "plastic strain, from 0 to 89: a number, or an expression.",
      ExpressionPattern());
    prm.add_parameter(
      "Dilatancy angle",
      dilatancy_angle,
      "Angle psi (degrees) of the plastic potential, from 0 to "
      "the friction angle: a number, or an expression, in which "
      "friction_angle is phi at the place. 0: no change of "
      "volume by shear.",
      ExpressionPattern());
    prm.add_parameter("Tensile strength",
                      tensile_strength,
                      "Largest principal stress (kPa), tension, that the soil "
                      "bears: at least 0. Never more than c cot(phi), which "
                      "\"apex\" takes.",
                      NumberOrWordPattern(apex));
    prm.add_parameter(
      "Residual cohesion",
      residual_cohesion,
      "c (kPa) after softening, at most the cohesion: a number, "
      "or an expression, in which cohesion, friction_angle and "
      "dilatancy_angle are those at the place.",
      ExpressionPattern());
    prm.add_parameter("Residual friction angle",
                      residual_friction,
                      "phi (degrees) after softening, at most the friction "
                      "angle: likewise.",
                      ExpressionPattern());
    prm.add_parameter("Residual dilatancy angle",
                      residual_dilatancy,
                      "psi (degrees) after softening, from 0 to the residual "
                      "friction angle: likewise.",
                      ExpressionPattern());
    prm.add_parameter(
      "Softening strain",
      softening_strain,
      "Plastic strain sqrt(2/3 e:e) (-), of the deviator, at "
      "which cohesion and angles have fallen to their residual "
      "values, linearly. 0: no softening. It belongs to the cell "
      "size, unless there is a softening length, or nonlocal softening.",
      Patterns::Double(0.));
    prm.add_parameter(
      "Shear strength table",
      strength_table,
      "Shear strength by effective normal stress, \"0: t0, s1: t1, ...\" "
      "(kPa), instead of cohesion and friction angle: straight lines whose "
      "slopes fall, the last of which goes on. It follows the stress of the "
      "moment. Empty: cohesion and friction angle.",
      Patterns::Anything());
  }


  namespace
  {
    const std::vector<std::string> peak_names = {"cohesion",
                                                 "friction_angle",
                                                 "dilatancy_angle"};
  }


  bool
  MohrCoulombParameters::has_table() const
  {
    return !tidy(strength_table).empty();
  }


  void
  MohrCoulombParameters::check_expressions(const std::string &path,
                                           const unsigned int dim) const
  {
    if (has_table())
      shear_strength_entries(strength_table, path + "Shear strength table");
    check_expression(path + "Cohesion", cohesion, {}, dim);
    check_expression(path + "Friction angle",
                     friction_angle,
                     {"cohesion"},
                     dim);
    check_expression(path + "Dilatancy angle",
                     dilatancy_angle,
                     {"cohesion", "friction_angle"},
                     dim);
    check_expression(path + "Residual cohesion",
                     residual_cohesion,
                     peak_names,
                     dim);
    check_expression(path + "Residual friction angle",
                     residual_friction,
                     peak_names,
                     dim);
    check_expression(path + "Residual dilatancy angle",
                     residual_dilatancy,
                     peak_names,
                     dim);
  }


  void
  MohrCoulombParameters::check(const std::string             &path,
                               const LinearElasticParameters &elastic,
                               const double softening_scale) const
  {
    // Expressions are read where the points are.
    const auto c = plain_number(cohesion), phi = plain_number(friction_angle),
               psi         = plain_number(dilatancy_angle);
    const auto wrong_angle = [](const std::optional<double> &angle) {
      return angle && !(*angle >= 0. && *angle <= largest_friction_angle);
    };
    if (c && !(*c >= 0.))
      throw UserError(path + "Cohesion",
                      "is " + in_digits(*c) + " kPa",
                      "at least 0");
    if (wrong_angle(phi))
      throw UserError(path + "Friction angle",
                      "is " + in_digits(*phi) + " degrees",
                      "from 0 to " + in_digits(largest_friction_angle) +
                        "; soils have 15 to 45");
    if (c && phi && *c == 0. && *phi == 0.)
      throw UserError(path + "Cohesion",
                      "is 0, as is the friction angle: no strength",
                      "above 0, or a friction angle above 0");
    if (psi && (wrong_angle(psi) || (phi && !(*psi <= *phi))))
      throw UserError(path + "Dilatancy angle",
                      "is " + in_digits(*psi) +
                        " degrees, the friction angle " + friction_angle +
                        " degrees",
                      "from 0 to the friction angle");
    const auto tension = plain_number(tensile_strength);
    if (tension && !(*tension >= 0.))
      throw UserError(path + "Tensile strength",
                      "is " + in_digits(*tension) + " kPa",
                      "at least 0, or \"apex\"");
    if (has_table() && softening_strain != 0.)
      throw UserError(path + "Softening strain",
                      "is " + in_digits(softening_strain) +
                        ", with a Shear strength table",
                      "0: a table does not soften");
    if (has_table() && !psi)
      throw UserError(path + "Dilatancy angle",
                      "is " + in_quotes(dilatancy_angle) +
                        ", with a Shear strength table",
                      "a number (degrees)");
    constexpr double widest = 1e6; // beyond it nothing softens
    if (!(softening_strain >= 0. && softening_strain <= widest))
      throw UserError(path + "Softening strain",
                      "is " + in_digits(softening_strain),
                      "above 0, at most " + in_digits(widest) +
                        ", or 0 for no softening");

    // What is not given is as before.
    const MohrCoulombParameters usual;
    const auto                  left = [](const std::string           &text,
                         const std::string           &same,
                         const std::optional<double> &before) {
      return text == same ? before : plain_number(text);
    };
    const auto c_r   = left(residual_cohesion, usual.residual_cohesion, c);
    const auto phi_r = left(residual_friction, usual.residual_friction, phi);
    const auto psi_r = left(residual_dilatancy,
                            usual.residual_dilatancy,
                            dilatancy_angle == "friction_angle" ? phi : psi);

    if (!(softening_strain > 0.))
      {
        if (residual_cohesion != usual.residual_cohesion ||
            residual_friction != usual.residual_friction ||
            residual_dilatancy != usual.residual_dilatancy)
          throw UserError(path + "Softening strain",
                          "is 0, but there are residual strengths",
                          "above 0 with softening; without, no residual "
                          "strengths");
        return;
      }
    if (c_r && !(*c_r >= 0. && (!c || *c_r <= *c)))
      throw UserError(path + "Residual cohesion",
                      "is " + in_digits(*c_r) + " kPa, the cohesion " +
                        cohesion + " kPa",
                      "from 0 to the cohesion");
    if (phi_r && (wrong_angle(phi_r) || (phi && !(*phi_r <= *phi))))
      throw UserError(path + "Residual friction angle",
                      "is " + in_digits(*phi_r) +
                        " degrees, the friction angle " + friction_angle +
                        " degrees",
                      "from 0 to the friction angle");
    if (psi_r && (wrong_angle(psi_r) || (phi_r && !(*psi_r <= *phi_r))))
      throw UserError(path + "Residual dilatancy angle",
                      "is " + in_digits(*psi_r) +
                        " degrees, the residual friction angle " +
                        (phi_r ? in_digits(*phi_r) : residual_friction) +
                        " degrees",
                      "from 0 to the residual friction angle");

    const double least = snap_back_strain(elastic, softening_scale, 0.);
    if (!(softening_strain > least))
      throw UserError(path + "Softening strain",
                      "is " + in_digits(softening_strain) +
                        ": the cohesion falls more steeply than elastic "
                        "unloading (snap-back)",
                      "above " + in_digits(least) +
                        " with this Young's modulus and Poisson's ratio" +
                        (softening_scale != 1.
                           ? ", this cell size and softening length"
                           : ""));
  }


  double
  MohrCoulombParameters::snap_back_strain(
    const LinearElasticParameters &elastic,
    const double                   softening_scale,
    const double                   pressure) const
  {
    const auto c     = plain_number(cohesion),
               c_r   = plain_number(residual_cohesion),
               phi   = plain_number(friction_angle),
               phi_r = plain_number(residual_friction),
               psi   = plain_number(dilatancy_angle);
    if (!phi)
      return 0.;
    // With psi = 0 it is the least stiff.
    const double degree  = std::acos(-1.) / 180.;
    const double sin_phi = std::sin(*phi * degree);
    const double sin_psi = psi ? std::sin(*psi * degree) : 0.;
    // The loss is per cos(phi), which grows as phi falls.
    const double cos_phi =
      std::cos(phi_r                                   ? *phi_r * degree
               : residual_friction == "friction_angle" ? *phi * degree
                                                       : 0.);
    const double fallen = c && c_r ? *c - *c_r : 0.; // kPa
    const double turned = phi_r ? (*phi - *phi_r) * degree : 0.;
    const double G      = elastic.shear_modulus();
    const double lame =
      2. * G * elastic.poissons_ratio / (1. - 2. * elastic.poissons_ratio);
    return MohrCoulombReturn(G, lame).strain_of_loss(
             sin_phi, sin_psi, 2. * cos_phi * (fallen + turned * pressure)) *
           softening_scale;
  }


  std::unique_ptr<Material>
  make_mohr_coulomb(const double                   density,
                    const LinearElasticParameters &elastic,
                    const MohrCoulombParameters   &p,
                    const SofteningMeasure        &measure,
                    const std::string             &path)
  {
    // What is as before softening is a number where that is one.
    const std::string dilatancy = p.dilatancy_angle == "friction_angle"
                                    ? p.friction_angle
                                    : p.dilatancy_angle;
    const auto        residual  = [&](const std::string &text,
                              const std::string &name,
                              const std::string &before,
                              const std::string &entry) {
      return initial_value(text == name ? before : text, path + entry);
    };
    const double tensile_strength =
      plain_number(p.tensile_strength)
        .value_or(std::numeric_limits<double>::infinity());
    if (p.has_table())
      {
        auto law = std::make_unique<ShearStrengthTable>(
          density,
          elastic.youngs_modulus,
          elastic.poissons_ratio,
          lines_through(shear_strength_entries(p.strength_table,
                                               path + "Shear strength table")),
          plain_number(p.dilatancy_angle).value_or(0.),
          tensile_strength);
        if (elastic.varies)
          law->let_stiffness_vary();
        return law;
      }
    auto law = std::make_unique<MohrCoulomb>(
      density,
      elastic.youngs_modulus,
      elastic.poissons_ratio,
      MohrCoulomb::Angles{initial_value(p.cohesion, path + "Cohesion"),
                          initial_value(p.friction_angle,
                                        path + "Friction angle"),
                          residual(p.dilatancy_angle,
                                   "friction_angle",
                                   p.friction_angle,
                                   "Dilatancy angle")},
      tensile_strength,
      MohrCoulomb::Angles{residual(p.residual_cohesion,
                                   "cohesion",
                                   p.cohesion,
                                   "Residual cohesion"),
                          residual(p.residual_friction,
                                   "friction_angle",
                                   p.friction_angle,
                                   "Residual friction angle"),
                          residual(p.residual_dilatancy,
                                   "dilatancy_angle",
                                   dilatancy,
                                   "Residual dilatancy angle")},
      p.softening_strain,
      measure);
    if (elastic.varies)
      law->let_stiffness_vary();
    return law;
  }
} // namespace Waker
