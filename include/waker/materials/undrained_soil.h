// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_materials_undrained_soil_h
#define waker_materials_undrained_soil_h

#include <waker/materials/material.h>

#include <memory>

namespace Waker
{
  /**
   * Soil of any law of effective stress that keeps its water: undrained by
   * effective parameters. A volumetric strain presses the water in the pores,
   *   du = -K_f tr(d eps),  K_f = K_w / porosity,
   * and the stress is sigma' - u 1 (tension positive): effective stress less
   * the excess pore pressure u, which is a variable of the point. The bulk
   * modulus of undrained soil is K' + K_f, and Skempton's B is K_f/(K' + K_f).
   * In situ u is 0.
   */
  class UndrainedSoil final : public Material
  {
  public:
    /// @param soil its law of effective stress
    /// @param stiffness K_f (kPa), above 0
    UndrainedSoil(std::unique_ptr<Material> soil, const double stiffness);

    /// Those of the soil, and "excess pore pressure" (kPa).
    std::vector<MaterialVariable>
    variables() const override;

    std::vector<MaterialVariable>
    coefficients() const override
    {
      return soil->coefficients();
    }

    std::optional<std::pair<unsigned int, std::string>>
    initial_problem(const std::vector<double> &variables) const override;

    void
    divide_strengths(const double factor, double *variables) const override;

    /// By the effective stress.
    void
    consolidate(const SymmetricTensor<2, 3> &stress,
                double                      *variables) const override;

    SofteningMeasure
    softening_measure() const override
    {
      return soil->softening_measure();
    }

    bool
    can_soften(const double *variables) const override
    {
      return soil->can_soften(variables);
    }

    void
    soften(const double increment, double *variables) const override
    {
      soil->soften(increment, variables);
    }

    double
    update(const SymmetricTensor<2, 3> &strain_increment,
           SymmetricTensor<2, 3>       &stress,
           double                      *variables,
           SymmetricTensor<4, 3>       *tangent) const override;

    void
    update_block(const unsigned int n_points, Block &block) const override;

    void
    tangent_block(const unsigned int  n_points,
                  Block              &block,
                  const unsigned int  n_components,
                  const unsigned int *components,
                  double (*tangent)[block_size]) const override;

    /// That of the effective stress and of the water.
    void
    elastic_energy(const Block &block,
                   double (&energy)[block_size]) const override;

    double
    density() const override
    {
      return soil->density();
    }

    double
    shear_modulus() const override
    {
      return soil->shear_modulus();
    }

    /// K' (kPa), of the drained soil.
    double
    bulk_modulus() const override
    {
      return soil->bulk_modulus();
    }

    double
    pore_fluid_stiffness() const override
    {
      return stiffness;
    }

    bool
    is_of_effective_stress() const override
    {
      return soil->is_of_effective_stress();
    }

    bool
    has_symmetric_tangent() const override
    {
      return soil->has_symmetric_tangent();
    }

  private:
    const std::unique_ptr<Material> soil;
    const double                    stiffness; // K_f, kPa
    const unsigned int              number;    // of the excess pore pressure
  };
} // namespace Waker

#endif
