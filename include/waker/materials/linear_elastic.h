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
    /// Has each point a stiffness ratio of its own? Not the user's to say: a
    /// random field asks for it.
    bool varies = false;

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

    /// Give the points a variable "stiffness ratio" (-), at first 1: the last
    /// of all.
    void
    let_stiffness_vary()
    {
      stiffness_varies = true;
    }

    std::optional<unsigned int>
    stiffness_variable() const override
    {
      return stiffness_varies ? std::optional<unsigned int>(n_own_variables())
                              : std::optional<unsigned int>();
    }

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
    /// How many variables the law has besides the stiffness ratio.
    virtual unsigned int
    n_own_variables() const
    {
      return 0;
    }

    void
    add_stiffness_ratio(std::vector<MaterialVariable> &variables) const;

    /// Of a point.
    double
    stiffness_ratio(const double *variables) const
    {
      return stiffness_varies ? variables[n_own_variables()] : 1.;
    }

    /// stress += ratio (K tr(strain) 1 + 2 G dev(strain))
    void
    add_elastic_stress(const SymmetricTensor<2, 3> &strain_increment,
                       const double                 ratio,
                       SymmetricTensor<2, 3>       &stress) const;

    bool stiffness_varies = false;

    double                rho;
    double                G;
    double                K;
    SymmetricTensor<4, 3> elastic_tangent; // kPa
  };
} // namespace Waker

#endif
