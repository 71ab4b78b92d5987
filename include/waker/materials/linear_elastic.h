// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_materials_linear_elastic_h
#define waker_materials_linear_elastic_h

#include <waker/materials/material.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  /// What the user says of a law's elasticity: in "Materials/<name>".
  struct LinearElasticParameters
  {
    double youngs_modulus = 1000.; // kPa
    double poissons_ratio = 0.45;  // -

    double
    shear_modulus() const
    {
      return youngs_modulus / (2. * (1. + poissons_ratio));
    }

    void
    add_parameters(ParameterHandler &prm);

    /// @param path "Materials/<name>/"
    /// @throws UserError path + ...
    void
    check(const std::string &path) const;
  };


  /// Isotropic linear (hypo-)elasticity: stress += D : strain increment.
  class LinearElastic : public Material
  {
  public:
    /**
     * @param density Mg/m^3
     * @param youngs_modulus E (kPa)
     * @param poissons_ratio nu, -1 < nu < 1/2
     */
    LinearElastic(const double density,
                  const double youngs_modulus,
                  const double poissons_ratio);

    std::vector<MaterialVariable>
    variables() const override;

    double
    update(const SymmetricTensor<2, 3> &strain_increment,
           SymmetricTensor<2, 3>       &stress,
           double                      *variables,
           SymmetricTensor<4, 3>       *tangent) const override;

    double
    density() const override
    {
      return rho;
    }

    double
    shear_modulus() const override
    {
      return G;
    }

    double
    bulk_modulus() const override
    {
      return K;
    }

  protected:
    /// stress += K tr(strain) 1 + 2 G dev(strain)
    void
    add_elastic_stress(const SymmetricTensor<2, 3> &strain_increment,
                       SymmetricTensor<2, 3>       &stress) const;

    double                rho;
    double                G;
    double                K;
    SymmetricTensor<4, 3> elastic_tangent; // kPa
  };
} // namespace Waker

#endif
