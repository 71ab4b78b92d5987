// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/materials/factory.h>

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
    elastic.add_parameters(prm);
    von_mises.add_parameters(prm);
  }


  void
  MaterialParameters::check(const unsigned int dim) const
  {
    const std::string path = "Materials/" + name + "/";
    require_positive(path + "Unit weight", unit_weight, "kN/m^3");
    // Outside of this masses are no numbers that one can compute with.
    if (!(unit_weight >= 1e-9 && unit_weight <= 1e12))
      throw UserError(path + "Unit weight",
                      "is " + in_digits(unit_weight) + " kN/m^3",
                      "1e-9 to 1e12 kN/m^3; soils have 10 to 25");
    elastic.check(path);
    von_mises.check_expressions(path, dim); // whatever the model
    switch (model)
      {
        case MaterialModel::linear_elastic:
          return;
        case MaterialModel::von_mises_softening:
          von_mises.check(path, elastic);
          return;
      }
  }


  const std::string *
  MaterialParameters::strength() const
  {
    switch (model)
      {
        case MaterialModel::linear_elastic:
          return nullptr;
        case MaterialModel::von_mises_softening:
          return &von_mises.initial_strength;
      }
    return nullptr;
  }
} // namespace Waker
