// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/materials/linear_elastic.h>

namespace Waker
{
  void
  LinearElasticParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Young's modulus",
                      youngs_modulus,
                      "Stiffness (kPa), above 0.",
                      Patterns::Double(0.));
    prm.add_parameter("Poisson's ratio",
                      poissons_ratio,
                      "Ratio of lateral to axial strain (-), above -1 and "
                      "below 0.5.",
                      Patterns::Double(-1., 0.5));
  }


  void
  LinearElasticParameters::check(const std::string &path) const
  {
    require_positive(path + "Young's modulus", youngs_modulus, "kPa");
    if (!(poissons_ratio > -1. && poissons_ratio < 0.5))
      throw UserError(path + "Poisson's ratio",
                      "is " + in_digits(poissons_ratio),
                      "above -1 and below 0.5 (an incompressible soil: 0.49)");
  }


  LinearElastic::LinearElastic(const double density,
                               const double youngs_modulus,
                               const double poissons_ratio)
    : rho(density)
    , G(youngs_modulus / (2. * (1. + poissons_ratio)))
    , K(youngs_modulus / (3. * (1. - 2. * poissons_ratio)))
    , elastic_tangent(K * outer_product(unit_symmetric_tensor<3>(),
                                        unit_symmetric_tensor<3>()) +
                      2. * G * deviator_tensor<3>())
  {}


  void
  LinearElastic::add_elastic_stress(
    const SymmetricTensor<2, 3> &strain_increment,
    const double                 ratio,
    SymmetricTensor<2, 3>       &stress) const
  {
    stress += (2. * ratio * G) * strain_increment;
    const double mean = ratio * (K - 2. / 3. * G) * trace(strain_increment);
    for (unsigned int d = 0; d < 3; ++d)
      stress[d][d] += mean;
  }


  std::vector<MaterialVariable>
  LinearElastic::variables() const
  {
    std::vector<MaterialVariable> list;
    add_stiffness_ratio(list);
    return list;
  }


  void
  LinearElastic::add_stiffness_ratio(std::vector<MaterialVariable> &list) const
  {
    if (stiffness_varies)
      list.push_back(
        {"stiffness ratio", "-", 1., MaterialVariable::Role::stiffness});
  }


  double
  LinearElastic::update(const SymmetricTensor<2, 3> &strain_increment,
                        SymmetricTensor<2, 3>       &stress,
                        double                      *variables,
                        SymmetricTensor<4, 3>       *tangent) const
  {
    const double ratio = stiffness_ratio(variables);
    add_elastic_stress(strain_increment, ratio, stress);
    if (tangent != nullptr)
      *tangent = ratio * elastic_tangent;
    return 0.;
  }
} // namespace Waker
