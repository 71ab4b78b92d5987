// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_materials_von_mises_softening_h
#define waker_materials_von_mises_softening_h

#include <waker/materials/linear_elastic.h>
#include <waker/materials/undrained_strength.h>

#include <memory>
#include <optional>

namespace Waker
{
  /**
   * Undrained clay: linear elastic, von Mises yield f = q - sqrt(3) c with
   * q = sqrt(3/2 s:s), and an undrained shear strength c that falls linearly
   * with the plastic strain to its residual value (section 5.2 and fig. 5.3 of
   * Remmerswaal 2023, after Wang et al. 2016):
   *   c = max(c_r, c_i + H_s eps_p),  H_s <= 0.
   *
   * or with the plastic strain's nonlocal measure (SofteningMeasure). The
   * return is radial and in closed form, the tangent is the algorithmic one. In
   * local softening it is indefinite. It needs 3 G + sqrt(3) H_s > 0.
   */
  class VonMisesSoftening final : public LinearElastic
  {
  public:
    /// Which invariant of the plastic strain softens: sqrt(2/3 e:e), the
    /// equivalent plastic strain, or sqrt(1/2 e:e), 0.866 times as much.
    enum class Invariant
    {
      equivalent,
      half
    };

    /// @param initial_strength, residual_strength, softening_modulus in kPa;
    /// the strengths are the points' default, each point has its own
    /// @param overconsolidation_ratio at the start, if the strength knows it
    /// @param measure of the plastic strain that softens
    /// @param coefficients that the four initial values may be expressions of
    VonMisesSoftening(
      const double                         density,
      const double                         youngs_modulus,
      const double                         poissons_ratio,
      const InitialValue                  &initial_strength,
      const InitialValue                  &residual_strength,
      const double                         softening_modulus,
      const Invariant                      invariant = Invariant::equivalent,
      const std::optional<InitialValue>   &overconsolidation_ratio = {},
      const SofteningMeasure              &measure                 = {},
      const std::vector<MaterialVariable> &coefficients            = {});

    /// "undrained shear strength" (now, kPa), "residual strength" (kPa),
    /// "plastic strain" (-), "overconsolidation ratio" (-) if it is known, and
    /// the two of softening_history() if softening is not local; of soil whose
    /// stiffness varies, its ratio.
    /// The residual strength may be an expression of "initial_strength".
    std::vector<MaterialVariable>
    variables() const override;

    std::vector<MaterialVariable>
    coefficients() const override
    {
      return strength_coefficients;
    }

    std::optional<std::pair<unsigned int, std::string>>
    initial_problem(const std::vector<double> &variables) const override;

    double
    update(const SymmetricTensor<2, 3> &strain_increment,
           SymmetricTensor<2, 3>       &stress,
           double                      *variables,
           SymmetricTensor<4, 3>       *tangent) const override;

    SofteningMeasure
    softening_measure() const override
    {
      return measure;
    }

    bool
    can_soften(const double *variables) const override;

    void
    soften(const double increment, double *variables) const override;

    void
    update_block(const unsigned int n_points, Block &block) const override;

    void
    tangent_block(const unsigned int  n_points,
                  Block              &block,
                  const unsigned int  n_components,
                  const unsigned int *components,
                  double (*tangent)[block_size]) const override;

    double
    least_stiffness_ratio() const override;

  private:
    unsigned int
    n_own_variables() const override
    {
      return (overconsolidation_ratio ? 4 : 3) + (measure.is_local() ? 0 : 2);
    }

    template <bool varies>
    void
    update_lanes(Block &block) const;

    template <bool varies>
    void
    tangent_lanes(Block              &block,
                  const unsigned int  n_components,
                  const unsigned int *components,
                  double (*tangent)[block_size]) const;

    InitialValue initial_strength;
    InitialValue residual_strength;
    double       plastic_strain_factor; // invariant / equivalent plastic strain
    double       softening; // dc / d(equivalent plastic strain) in a step, kPa
    std::optional<InitialValue>   overconsolidation_ratio;
    SofteningMeasure              measure;
    double                        softening_modulus; // H_s, kPa
    std::vector<MaterialVariable> strength_coefficients;
  };

  constexpr const char *
  name_of(const VonMisesSoftening::Invariant invariant)
  {
    switch (invariant)
      {
        case VonMisesSoftening::Invariant::equivalent:
          return "equivalent";
        case VonMisesSoftening::Invariant::half:
          return "half";
      }
    return nullptr;
  }


  /// What the user says of its strength: in "Materials/<name>".
  struct VonMisesSofteningParameters
  {
    /// c_i (kPa): a number, or an expression of the place; unless it follows
    /// from a stress.
    std::string                 initial_strength = "13";
    UndrainedStrengthParameters strength;
    /// c_r (kPa), likewise; it may contain "initial_strength".
    std::string residual_strength = "5";
    double      softening_modulus = -50.; // H_s = dc / d(plastic strain), kPa
    /// Which invariant softens (the thesis does not print it).
    VonMisesSoftening::Invariant plastic_strain_invariant =
      VonMisesSoftening::Invariant::equivalent;

    void
    add_parameters(ParameterHandler &prm);

    /// c_i as an expression of the place, wherever it comes from.
    /// @param path "Materials/<name>/"
    std::string
    strength_expression(const std::string &path) const
    {
      return strength.expression(initial_strength, path);
    }

    /// Can the strengths be read?
    /// @param path "Materials/<name>/"
    /// @throws UserError path + ...
    void
    check_expressions(const std::string &path, const unsigned int dim) const;

    /// @param softening_scale SofteningMeasure::of_uniform_strain()
    /// @throws UserError path + ...
    void
    check(const std::string             &path,
          const LinearElasticParameters &elastic,
          const double                   softening_scale) const;

    /// -H_s (kPa), above 0, from which a point loses its strength with less
    /// strain than it unloads elastically.
    double
    snap_back_modulus(const LinearElasticParameters &elastic,
                      const double                   softening_scale) const;
  };


  /// @param path "Materials/<name>/"
  std::unique_ptr<Material>
  make_von_mises_softening(const double                       density,
                           const LinearElasticParameters     &elastic,
                           const VonMisesSofteningParameters &parameters,
                           const SofteningMeasure            &measure,
                           const std::string                 &path);
} // namespace Waker

#endif
