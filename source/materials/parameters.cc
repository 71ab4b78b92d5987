// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/expression_pattern.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/materials/factory.h>

#include "initial_expression.h"
#include <cmath>

namespace Waker
{
  namespace
  {
    void
    check_pore_fluid(const MaterialParameters &m)
    {
      constexpr double  largest   = 0.4999; // what steps can be solved with
      const std::string path      = "Materials/" + m.name + "/";
      const double      stiffness = m.pore_fluid_stiffness;
      if (stiffness == 0.)
        return;
      const double of_soil =
        m.elastic.youngs_modulus / (3. * (1. - 2. * m.elastic.poissons_ratio));
      // Of that Poisson's ratio, undrained.
      const double most = 2. * m.elastic.shear_modulus() * (1. + largest) /
                            (3. * (1. - 2. * largest)) -
                          of_soil;
      if (!(stiffness > 0. && stiffness <= most))
        throw UserError(path + "Pore fluid stiffness",
                        "is " + in_digits(stiffness) + " kPa",
                        "0; or at most " + in_digits(most) +
                          " kPa, with which the soil has an undrained "
                          "Poisson's ratio of " +
                          in_digits(largest));
      if (!m.is_drained())
        throw UserError(
          path + "Pore fluid stiffness",
          "is " + in_digits(stiffness) + " kPa, but Model is " +
            name_of(m.model) + ", a law of total stress",
          "0, or a law of effective stress: Mohr-Coulomb, modified "
          "Cam clay");
    }


    /// What K0 may be an expression of, beside the place: see
    /// Material::variables().
    std::vector<std::string>
    k0_symbols(const MaterialModel model)
    {
      switch (model)
        {
          case MaterialModel::linear_elastic:
            return {};
          case MaterialModel::von_mises_softening:
            return {"initial_strength"};
          case MaterialModel::mohr_coulomb:
            return {"cohesion", "friction_angle", "dilatancy_angle"};
          case MaterialModel::modified_cam_clay:
            return {"friction_angle"};
        }
      return {};
    }
  } // namespace


  double
  MaterialParameters::undrained_poissons_ratio() const
  {
    const double G = elastic.shear_modulus();
    const double K =
      elastic.youngs_modulus / (3. * (1. - 2. * elastic.poissons_ratio)) +
      pore_fluid_stiffness;
    return (3. * K - 2. * G) / (2. * (3. * K + G));
  }


  void
  MaterialParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Model",
               model,
               "linear elastic: no strength. von Mises softening: "
               "undrained strength c that falls from the initial to the "
               "residual value with plastic strain; plane-strain "
               "strength c, yield at q = sqrt(3) c. Mohr-Coulomb: cohesion "
               "and friction, with a tension cut-off; may soften. modified Cam "
               "clay: friction at critical state, and compression.");
    prm.add_parameter("Unit weight",
                      unit_weight,
                      "Weight per volume (kN/m^3), above 0.",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Saturated unit weight",
      saturated_unit_weight,
      "Weight per volume (kN/m^3), with its water, of the soil "
      "that lies below the phreatic line at the start; it keeps "
      "it. 0: the unit weight, as above the line.",
      Patterns::Double(0.));
    prm.add_parameter("Below the line",
                      below_line,
                      "Name of another material: soil of this one that lies "
                      "below the phreatic line at the start is of that one, "
                      "with its law and its saturated weight, and stays it; "
                      "as clay that drains above the line and not below. "
                      "Empty: it is the same below.",
                      Patterns::Anything());
    prm.add_parameter(
      "K0",
      k0,
      "Initial stress/From = K0: horizontal over vertical effective stress (-), "
      "at least 0, where the ground is level: a number; an expression of the "
      "place as of Initial strength, in which friction_angle "
      "(degrees) is that at the place, if the law has one; elastic: nu/(1 - nu), of Poisson's "
      "ratio; or Jaky: 1 - sin(friction_angle).",
      ExpressionPattern());
    add_choice(
      prm,
      "Regularisation",
      regularisation,
      "What keeps softening from belonging to the cells. softening "
      "length: plastic strain is scaled by the cell size, see there; "
      "with a length of 0, the default, nothing does. nonlocal: the "
      "strain that softens a point is that of its surroundings, see "
      "Averaging length. Recommended for whether and when soil slides; "
      "a long slide it softens too widely. The thesis has neither.");
    prm.add_parameter(
      "Pore fluid stiffness",
      pore_fluid_stiffness,
      "Laws of effective stress: bulk stiffness of the water in the pores of soil that does "
      "not drain (kPa), that of water over the porosity, at least 0: "
      "volumetric strain makes excess pore pressure, and effective parameters "
      "an undrained soil. It drains in the gravity step. 0: it drains.",
      Patterns::Double(0.));
    prm.add_parameter(
      "Softening length",
      softening_length,
      "Width l_s (m) of the band of slip that the softening of "
      "the soil belongs to, at least 0: in cells of size h soil "
      "softens by h/l_s times its plastic strain, so that a slip "
      "surface takes as much work in cells of any size. 0: soil "
      "softens by its plastic strain, and results depend on "
      "the cell size.",
      Patterns::Double(0.));
    nonlocal.add_parameters(prm);
    elastic.add_parameters(prm);
    von_mises.add_parameters(prm);
    mohr_coulomb.add_parameters(prm);
    cam_clay.add_parameters(prm);
  }


  void
  MaterialParameters::check(const unsigned int dim,
                            const double       cell_size) const
  {
    const std::string path = "Materials/" + name + "/";
    require_positive(path + "Unit weight", unit_weight, "kN/m^3");
    // Outside of this masses are no numbers that one can compute with.
    if (!(unit_weight >= 1e-9 && unit_weight <= 1e12))
      throw UserError(path + "Unit weight",
                      "is " + in_digits(unit_weight) + " kN/m^3",
                      "1e-9 to 1e12 kN/m^3; soils have 10 to 25");
    if (saturated_unit_weight != 0. && !(saturated_unit_weight >= unit_weight &&
                                         saturated_unit_weight <= 1e12))
      throw UserError(path + "Saturated unit weight",
                      "is " + in_digits(saturated_unit_weight) +
                        " kN/m^3, the unit weight " + in_digits(unit_weight) +
                        " kN/m^3",
                      "at least the unit weight, or 0");
    constexpr double longest = 1e6; // m: beyond it nothing softens
    if (!(softening_length >= 0. && softening_length <= longest))
      throw UserError(path + "Softening length",
                      "is " + in_digits(softening_length) + " m",
                      "a width (m) above 0, at most " + in_digits(longest) +
                        "; 0: softening by the cells");
    nonlocal.check(path);
    elastic.check(path);
    check_pore_fluid(*this);
    const auto number = plain_number(k0);
    if (number && !(*number >= 0. && *number <= 1e3))
      throw UserError(path + "K0",
                      "is " + in_digits(*number),
                      "from 0 to 1000 (soils have 0.3 to 2), elastic or Jaky");
    check_expression(path + "K0", k0_expression(), k0_symbols(model), dim);
    von_mises.check_expressions(path, dim); // whatever the model
    mohr_coulomb.check_expressions(path, dim);
    cam_clay.check_always(path, dim);
    const double scale = softening_measure(cell_size).of_uniform_strain();
    switch (model)
      {
        case MaterialModel::linear_elastic:
          return;
        case MaterialModel::von_mises_softening:
          von_mises.check(path, elastic, scale);
          return;
        case MaterialModel::mohr_coulomb:
          mohr_coulomb.check(path, elastic, scale);
          return;
        case MaterialModel::modified_cam_clay:
          cam_clay.check(path,
                         elastic,
                         mohr_coulomb.friction_angle,
                         von_mises.strength.pop);
          return;
      }
  }


  SofteningMeasure
  MaterialParameters::softening_measure(const double cell_size) const
  {
    SofteningMeasure measure;
    if (!softens())
      return measure;
    switch (regularisation)
      {
        case Regularisation::softening_length:
          if (softening_length > 0.)
            measure.own = cell_size / softening_length;
          return measure;
        case Regularisation::nonlocal:
          measure.own      = 1. - nonlocal.over_weight;
          measure.averaged = nonlocal.over_weight;
          measure.length   = nonlocal.length;
          measure.weight   = nonlocal.weight;
          return measure;
      }
    return measure;
  }


  bool
  MaterialParameters::softens() const
  {
    switch (model)
      {
        case MaterialModel::linear_elastic:
          return false;
        case MaterialModel::von_mises_softening:
          return von_mises.softening_modulus < 0.;
        case MaterialModel::mohr_coulomb:
          return mohr_coulomb.softening_strain > 0.;
        case MaterialModel::modified_cam_clay:
          return false; // but on the dry side, of its own
      }
    return false;
  }


  std::string
  MaterialParameters::k0_expression() const
  {
    const std::string text = tidy(k0);
    if (text == "elastic")
      return in_digits(elastic.poissons_ratio / (1. - elastic.poissons_ratio));
    if (text != "Jaky")
      return text;
    if (!is_drained())
      throw UserError("Materials/" + name + "/K0",
                      std::string("is Jaky, but Model = ") + name_of(model) +
                        " has no friction angle",
                      "a number, an expression, or elastic");
    if (model == MaterialModel::mohr_coulomb && mohr_coulomb.has_table())
      throw UserError("Materials/" + name + "/K0",
                      "is Jaky, but a Shear strength table has no friction "
                      "angle",
                      "a number, an expression, or elastic");
    return "1 - sin(friction_angle*pi/180)";
  }


  bool
  MaterialParameters::is_drained() const
  {
    switch (model)
      {
        case MaterialModel::mohr_coulomb:
        case MaterialModel::modified_cam_clay:
          return true;
        case MaterialModel::linear_elastic:
        case MaterialModel::von_mises_softening:
          return false;
      }
    return false;
  }


  bool
  MaterialParameters::has_constant_stiffness() const
  {
    switch (model)
      {
        case MaterialModel::modified_cam_clay:
          return false;
        case MaterialModel::mohr_coulomb:
        case MaterialModel::linear_elastic:
        case MaterialModel::von_mises_softening:
          return true;
      }
    return true;
  }


  bool
  MaterialParameters::has_friction() const
  {
    switch (model)
      {
        case MaterialModel::mohr_coulomb:
          return mohr_coulomb.has_table() ||
                 plain_number(mohr_coulomb.friction_angle).value_or(1.) != 0.;
        case MaterialModel::modified_cam_clay:
          return true;
        case MaterialModel::linear_elastic:
        case MaterialModel::von_mises_softening:
          return false;
      }
    return false;
  }


  std::optional<std::string>
  MaterialParameters::undrained_strength() const
  {
    switch (model)
      {
        case MaterialModel::linear_elastic:
        case MaterialModel::mohr_coulomb:
        case MaterialModel::modified_cam_clay:
          return {};
        case MaterialModel::von_mises_softening:
          return von_mises.strength_expression("Materials/" + name + "/");
      }
    return {};
  }


  bool
  MaterialParameters::strength_follows_stress() const
  {
    if (model == MaterialModel::modified_cam_clay)
      return cam_clay.preconsolidation_expression().find("vertical_stress") !=
             std::string::npos;
    const auto strength = undrained_strength();
    return strength && strength->find("vertical_stress") != std::string::npos;
  }


  unsigned int
  material_below_line(const std::vector<MaterialParameters> &materials,
                      const unsigned int                     number)
  {
    const std::string name = tidy(materials[number].below_line);
    for (unsigned int m = 0; m < materials.size(); ++m)
      if (!name.empty() && materials[m].name == name)
        return m;
    return number;
  }


  double
  unit_weight_below_line(const std::vector<MaterialParameters> &materials,
                         const unsigned int                     number)
  {
    const MaterialParameters &below =
      materials[material_below_line(materials, number)];
    return below.saturated_unit_weight > 0. ? below.saturated_unit_weight
                                            : below.unit_weight;
  }
} // namespace Waker
