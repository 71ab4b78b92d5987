// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_materials_modified_cam_clay_h
#define waker_materials_modified_cam_clay_h

#include <waker/materials/linear_elastic.h>

#include <memory>
#include <string>
#include <vector>

namespace Waker
{
  struct CamClayEnd;

  /// In which test the friction angle at critical state is mobilised at
  /// q = M p'.
  enum class FrictionHolds
  {
    triaxial_compression,
    plane_strain
  };

  constexpr const char *
  name_of(const FrictionHolds choice)
  {
    switch (choice)
      {
        case FrictionHolds::triaxial_compression:
          return "triaxial compression";
        case FrictionHolds::plane_strain:
          return "plane strain";
      }
    return nullptr;
  }

  /// M (-) of a friction angle (degrees): 6 sin(phi) / (3 - sin(phi)) in
  /// triaxial compression, sqrt(3) sin(phi) in plane strain, where the stress
  /// out of the plane is the mean of the other two.
  double
  critical_state_ratio(const double friction_angle, const FrictionHolds holds);


  /**
   * Modified Cam clay (Roscoe & Burland 1968), of effective stress: the yield
   * surface
   *   f = q^2 / M^2 + p' (p' - p_c),
   * a circle in the deviatoric plane, associated flow, and a preconsolidation
   * pressure that follows the plastic volumetric strain. Compression lines are
   * straight in ln v over ln p' (Butterfield 1979),
   *   d eps_v = lambda* dp'/p' (virgin), kappa* dp'/p' (swelling),
   * with lambda* = lambda / v_0 and kappa* = kappa / v_0, so that
   *   K = p' / kappa*,  p_c = p_c0 exp(eps_v^p / (lambda* - kappa*)).
   * With a constant G that elasticity has an energy. Below a least pressure K
   * stays as it is there, and p_c does not fall below it.
   *
   * The return is implicit and exact to round-off, the tangent the algorithmic
   * one. It is unsymmetric. On the dry side, p' < p_c / 2, the soil softens.
   */
  class ModifiedCamClay final : public Material
  {
  public:
    struct Constants
    {
      double        youngs_modulus; // kPa, with Poisson's ratio: G
      double        poissons_ratio; // -
      double        compression;    // lambda*, -
      double        swelling;       // kappa*, -, below lambda*
      double        least_pressure; // kPa, above 0
      FrictionHolds holds = FrictionHolds::triaxial_compression;
    };

    /// @param friction_angle at critical state (degrees)
    /// @param preconsolidation p_c at the start (kPa); of an expression, of the
    ///        coefficients and "friction_angle"
    ModifiedCamClay(const double                         density,
                    const Constants                     &constants,
                    const InitialValue                  &friction_angle,
                    const InitialValue                  &preconsolidation,
                    const std::vector<MaterialVariable> &coefficients = {});

    /// "friction angle" (degrees), "preconsolidation pressure" (kPa), "plastic
    /// strain" (-): sqrt(2/3 e:e), of the deviator.
    std::vector<MaterialVariable>
    variables() const override;

    std::vector<MaterialVariable>
    coefficients() const override
    {
      return initial_coefficients;
    }

    std::optional<std::pair<unsigned int, std::string>>
    initial_problem(const std::vector<double> &variables) const override;

    /// tan(friction angle); the preconsolidation pressure stays.
    void
    divide_strengths(const double factor, double *variables) const override;

    /// The preconsolidation pressure is at least what the stress needs, if it
    /// is on the wet side; above critical state twice the pressure.
    void
    consolidate(const SymmetricTensor<2, 3> &stress,
                double                      *variables) const override;

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

    void
    elastic_energy(const Block &block,
                   double (&energy)[block_size]) const override;

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

    /// Of the in-situ stress, waves and supports, of Young's modulus and
    /// Poisson's ratio: the law itself has p'/kappa*.
    double
    bulk_modulus() const override
    {
      return in_situ_bulk_modulus;
    }

    bool
    is_of_effective_stress() const override
    {
      return true;
    }

    bool
    has_symmetric_tangent() const override
    {
      return false;
    }

  private:
    /// One point: stress in and out, variables in and out.
    /// @param trial out: deviator of the elastic trial stress
    CamClayEnd
    step(const double (&strain)[6],
         double (&stress)[6],
         double (&variables)[3],
         double (&trial)[6],
         double &dissipation) const;

    /// d stress_a / d strain_b after a step.
    double
    slope(const CamClayEnd &end,
          const double (&trial)[6],
          const unsigned int a,
          const unsigned int b) const;

    double        rho;
    double        G;
    double        in_situ_bulk_modulus;
    double        compression;
    double        swelling;
    double        least_pressure;
    FrictionHolds holds;
    InitialValue  friction_angle;
    InitialValue  preconsolidation;

    std::vector<MaterialVariable> initial_coefficients;
  };


  /// What the user says of it alone: in "Materials/<name>".
  struct ModifiedCamClayParameters
  {
    FrictionHolds holds      = FrictionHolds::triaxial_compression;
    double        lambda     = 0.2;  // -, of v over ln p'
    double        kappa      = 0.04; // -, likewise
    double        void_ratio = 1.;   // -, at the start
    double        ocr        = 1.;   // -
    /// p_c (kPa): an expression; empty: from OCR and POP.
    std::string preconsolidation;
    double      least_pressure = 1.; // kPa

    double
    compression() const // lambda*, -
    {
      return lambda / (1. + void_ratio);
    }

    double
    swelling() const // kappa*, -
    {
      return kappa / (1. + void_ratio);
    }

    /// p_c as an expression of the place, OCR, POP and the friction angle.
    std::string
    preconsolidation_expression() const;

    /**
     * The preconsolidation pressure (kPa) below which no point snaps back on
     * the dry side: there
     *   (1 - 2 p'/p_c) / kappa* + 6 G / (M^2 p_c (1 - 2 p'/p_c))
     * is above 1 / (lambda* - kappa*) at any p'.
     */
    double
    snap_back_pressure(const LinearElasticParameters &elastic,
                       const double                   friction_angle) const;

    void
    add_parameters(ParameterHandler &prm);

    /// Whatever the model.
    /// @param path "Materials/<name>/"
    /// @throws UserError path + ...
    void
    check_always(const std::string &path, const unsigned int dim) const;

    /// @param friction_angle, pop of "Friction angle" and "POP"
    void
    check(const std::string             &path,
          const LinearElasticParameters &elastic,
          const std::string             &friction_angle,
          const double                   pop) const;
  };


  /// @param path "Materials/<name>/"
  std::unique_ptr<Material>
  make_modified_cam_clay(const double                     density,
                         const LinearElasticParameters   &elastic,
                         const ModifiedCamClayParameters &parameters,
                         const std::string               &friction_angle,
                         const double                     pop,
                         const std::string               &path);
} // namespace Waker

#endif
