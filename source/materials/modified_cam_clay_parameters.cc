// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/materials/modified_cam_clay.h>
#include <waker/materials/mohr_coulomb.h>

#include "initial_expression.h"
#include <cmath>

namespace Waker
{
  namespace
  {
    constexpr double largest_index    = 10.; // lambda, of the softest peat 4
    constexpr double largest_pressure = 1e6; // kPa


    /// Over p_c of the yield stress: with K0 = 1 - sin(phi) (Jaky) at the
    /// yield stress, that stress lies on the yield surface.
    std::string
    isotropic_share(const FrictionHolds holds)
    {
      const std::string s = "sin(friction_angle*pi/180)";
      const std::string t = "(3 - 2*" + s + ")"; // 3 p'/sigma'_v
      switch (holds)
        {
          case FrictionHolds::triaxial_compression:
            return "(" + t + "/3 + (3 - " + s + ")^2/(12*" + t + "))";
          case FrictionHolds::plane_strain:
            return "(" + t + "/3 + 1/" + t + ")";
        }
      AssertThrow(false, ExcInternalError());
      return "";
    }


    void
    check_range(const std::string &path,
                const double       value,
                const double       low,
                const double       high,
                const std::string &allowed)
    {
      if (!(value >= low && value <= high))
        throw UserError(path, "is " + in_digits(value), allowed);
    }
  } // namespace


  void
  ModifiedCamClayParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Friction angle holds in",
               holds,
               "Modified Cam clay: the test in which the soil has its friction "
               "angle at critical state. triaxial compression: M = 6 "
               "sin(phi)/(3 - sin(phi)); as the surface is a circle, in plane "
               "strain the soil is stronger, sin(phi') = M/sqrt(3). plane "
               "strain: M = sqrt(3) sin(phi).");
    prm.add_parameter("Lambda",
                      lambda,
                      "Modified Cam clay: slope (-) of the virgin compression "
                      "line, -dv/d(ln p'), C_c/2.303; above Kappa, at most 10.",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Kappa",
      kappa,
      "Modified Cam clay: slope (-) of the swelling line, above "
      "0; usual is 0.1 to 0.3 times Lambda.",
      Patterns::Double(0.));
    prm.add_parameter("Void ratio",
                      void_ratio,
                      "Modified Cam clay: volume of the pores over that of the "
                      "grains (-) at the start, above 0, at most 100; v = 1 + "
                      "e. Strain goes with Lambda/v and Kappa/v.",
                      Patterns::Double(0.));
    prm.add_parameter(
      "OCR",
      ocr,
      "Modified Cam clay: overconsolidation ratio (-), at least "
      "1: the vertical yield stress is OCR "
      "daily_vertical_stress + POP.",
      Patterns::Double(0.));
    prm.add_parameter(
      "Preconsolidation pressure",
      preconsolidation,
      "Modified Cam clay: p_c (kPa) at the start, where the yield surface meets "
      "the axis of p': a number or an expression as of Initial strength, of "
      "friction_angle, too. Empty: that of the vertical yield stress with K0 = "
      "1 - sin(friction_angle). In any case at least what the stress in situ "
      "needs.",
      Patterns::Anything());
    prm.add_parameter("Least pressure",
                      least_pressure,
                      "Modified Cam clay: p' (kPa), above 0, below which the "
                      "stiffness falls no further, and which the "
                      "preconsolidation pressure keeps: near the surface, and "
                      "in soil that has come loose.",
                      Patterns::Double(0.));
  }


  std::string
  ModifiedCamClayParameters::preconsolidation_expression() const
  {
    const std::string own = tidy(preconsolidation);
    return own.empty() ? "(max(ocr, 1)*daily_vertical_stress + pop)*" +
                           isotropic_share(holds)
                       : own;
  }


  double
  ModifiedCamClayParameters::snap_back_pressure(
    const LinearElasticParameters &elastic,
    const double                   friction_angle) const
  {
    const double M     = critical_state_ratio(friction_angle, holds);
    const double theta = compression() - swelling();
    return 24. * elastic.shear_modulus() * theta * theta / (swelling() * M * M);
  }


  void
  ModifiedCamClayParameters::check_always(const std::string &path,
                                          const unsigned int dim) const
  {
    check_range(path + "Lambda",
                lambda,
                0.,
                largest_index,
                "above Kappa, at most 10; clay has 0.05 to 0.5, peat up to 4");
    if (!(kappa > 0. && kappa < lambda))
      throw UserError(path + "Kappa",
                      "is " + in_digits(kappa) + ", Lambda " +
                        in_digits(lambda),
                      "above 0 and below Lambda; usual is 0.1 to 0.3 times "
                      "Lambda");
    if (!(kappa >= 1e-6))
      throw UserError(path + "Kappa",
                      "is " + in_digits(kappa),
                      "at least 1e-6");
    if (!(lambda - kappa >= 1e-6))
      throw UserError(path + "Kappa",
                      "is " + in_digits(kappa) + ", as good as Lambda",
                      "at least 1e-6 below Lambda");
    if (!(void_ratio > 0. && void_ratio <= 100.))
      throw UserError(path + "Void ratio",
                      "is " + in_digits(void_ratio),
                      "above 0, at most 100; clay has 0.5 to 3, peat 5 to 15");
    check_range(path + "OCR", ocr, 1., 1000., "from 1 to 1000");
    if (!(least_pressure >= 1e-3 && least_pressure <= 1000.))
      throw UserError(path + "Least pressure",
                      "is " + in_digits(least_pressure) + " kPa",
                      "from 0.001 to 1000; 0.5 to 5 is usual");
    const std::string own = tidy(preconsolidation);
    if (own.empty())
      return;
    if (const auto number = plain_number(own))
      check_range(path + "Preconsolidation pressure",
                  *number,
                  0.,
                  largest_pressure,
                  "from 0 to 1e6 (kPa)");
    check_expression(path + "Preconsolidation pressure",
                     own,
                     {"friction_angle"},
                     dim);
  }


  void
  ModifiedCamClayParameters::check(const std::string             &path,
                                   const LinearElasticParameters &elastic,
                                   const std::string &friction_angle,
                                   const double       pop) const
  {
    const auto phi = plain_number(friction_angle);
    if (phi && !(*phi >= 0.1 && *phi <= largest_friction_angle))
      throw UserError(path + "Friction angle",
                      "is " + in_digits(*phi) + " degrees",
                      "from 0.1 to 89: M is above 0; soils have 15 to 45");
    check_range(path + "POP", pop, 0., largest_pressure, "from 0 to 1e6 (kPa)");
    const auto number = plain_number(preconsolidation);
    if (!phi || !number)
      return;
    const double limit = snap_back_pressure(elastic, *phi);
    if (!(*number < limit))
      throw UserError(path + "Preconsolidation pressure",
                      "is " + in_digits(*number) +
                        " kPa: on the dry side the soil softens more steeply "
                        "than it unloads elastically (snap-back)",
                      "below " + in_digits(limit) +
                        " kPa with this Young's modulus, Lambda and Kappa");
  }


  std::unique_ptr<Material>
  make_modified_cam_clay(const double                     density,
                         const LinearElasticParameters   &elastic,
                         const ModifiedCamClayParameters &p,
                         const std::string               &friction_angle,
                         const double                     pop,
                         const std::string               &path)
  {
    std::vector<MaterialVariable> coefficients;
    if (tidy(p.preconsolidation).empty())
      {
        const auto role = MaterialVariable::Role::coefficient;
        coefficients    = {
             {"OCR", "-", InitialValue(p.ocr, path + "OCR"), role, "ocr", "", 1.},
             {"POP", "kPa", InitialValue(pop, path + "POP"), role, "pop"}};
      }
    return std::make_unique<ModifiedCamClay>(
      density,
      ModifiedCamClay::Constants{elastic.youngs_modulus,
                                 elastic.poissons_ratio,
                                 p.compression(),
                                 p.swelling(),
                                 p.least_pressure,
                                 p.holds},
      initial_value(friction_angle, path + "Friction angle"),
      initial_value(p.preconsolidation_expression(),
                    path + (coefficients.empty() ? "Preconsolidation pressure"
                                                 : "OCR")),
      coefficients);
  }
} // namespace Waker
