// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_materials_mohr_coulomb_h
#define waker_materials_mohr_coulomb_h

#include <waker/materials/linear_elastic.h>

#include <array>
#include <memory>
#include <string>

namespace Waker
{
  class MohrCoulombLanes;
  struct MohrCoulombStrength;

  /**
   * Drained soil: linear elastic, Mohr-Coulomb's yield surface
   *   (s_1 - s_3) + (s_1 + s_3) sin phi = 2 c cos phi
   * of the largest and the smallest principal stress (tension positive), the
   * same with the dilatancy angle psi as plastic potential, and a tension
   * cut-off s_1 <= tensile strength, with flow along s_1. The cut-off never
   * lies beyond the apex, c cot phi.
   *
   * Cohesion and both angles may fall linearly with the plastic strain
   * sqrt(2/3 e:e), of the deviator, to residual values. The return in principal
   * stresses is exact, with softening up to round-off; the tangent is the
   * algorithmic one, unsymmetric unless psi = phi without softening.
   */
  class MohrCoulomb final : public LinearElastic
  {
  public:
    /// Cohesion (kPa), friction angle and dilatancy angle (degrees).
    struct Angles
    {
      InitialValue cohesion;
      InitialValue friction_angle;
      InitialValue dilatancy_angle; // at most the friction angle
    };

    /// Perfectly plastic.
    /// @param tensile_strength kPa; may be infinite
    MohrCoulomb(const double  density,
                const double  youngs_modulus,
                const double  poissons_ratio,
                const Angles &peak,
                const double  tensile_strength);

    /// @param residual what is left from a plastic strain of
    ///        `softening_strain` (-) on
    /// @param measure of the plastic strain that softens
    MohrCoulomb(const double            density,
                const double            youngs_modulus,
                const double            poissons_ratio,
                const Angles           &peak,
                const double            tensile_strength,
                const Angles           &residual,
                const double            softening_strain,
                const SofteningMeasure &measure = {});

    /// "cohesion" (kPa), "friction angle", "dilatancy angle" (degrees), if it
    /// softens the residual ones of each, all constant; "plastic strain" (-);
    /// the two of softening_history() if softening is not local.
    std::vector<MaterialVariable>
    variables() const override;

    std::optional<std::pair<unsigned int, std::string>>
    initial_problem(const std::vector<double> &variables) const override;

    /// Cohesion and tan(friction angle); the dilatancy angle is kept, but is at
    /// most the friction angle that is left.
    void
    divide_strengths(const double factor, double *variables) const override;

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
    bool
    softens() const
    {
      return softening_strain > 0.;
    }

    /// Does it soften within a step?
    bool
    softens_in_step() const
    {
      return softens() && measure.is_local();
    }

    unsigned int
    n_own_variables() const override
    {
      return number_of_softening_strain() + 1;
    }

    unsigned int
    n_variables() const
    {
      return n_own_variables() + (stiffness_varies ? 1 : 0);
    }

    /// find_elastic(), of the stresses alone.
    template <bool varies>
    void
    find_trial(const Block &block,
               double (&trial)[6][block_size],
               double (&half)[block_size],
               double (&middle)[block_size],
               double (&largest)[block_size]) const;

    unsigned int
    number_of_plastic_strain() const
    {
      return softens() ? 6 : 3;
    }

    /// Of what has softened it.
    unsigned int
    number_of_softening_strain() const
    {
      return number_of_plastic_strain() + (measure.is_local() ? 0 : 2);
    }

    static constexpr unsigned int most_variables = 10;

    /// The elastic stresses (kPa) of a block's points, and which of these stay
    /// as they are: surely, of others it is not known. And the strengths with
    /// which the points begin.
    void
    find_elastic(const unsigned int n_points,
                 const Block       &block,
                 double (&trial)[6][block_size],
                 bool (&is_elastic)[block_size],
                 MohrCoulombStrength (&strengths)[block_size]) const;

    /// use(l, strain increment, stress, variables) of points not elastic, each
    /// with copies of its own.
    template <typename Use>
    void
    each_yielding(const unsigned int n_points,
                  const Block       &block,
                  const bool (&is_elastic)[block_size],
                  const Use &use) const;

    /// Take in all that are not elastic.
    /// @param point out: their numbers
    /// @return how many there are
    unsigned int
    fill_lanes(const unsigned int n_points,
               const Block       &block,
               const double (&trial)[6][block_size],
               const bool (&is_elastic)[block_size],
               const MohrCoulombStrength (&strengths)[block_size],
               unsigned int (&point)[block_size],
               MohrCoulombLanes &lanes) const;

    /// update() of a point that begins with this strength.
    double
    update(const SymmetricTensor<2, 3> &strain_increment,
           const MohrCoulombStrength   &strength_before,
           SymmetricTensor<2, 3>       &stress,
           double                      *variables,
           SymmetricTensor<4, 3>       *tangent) const;

    /// At a plastic strain, or its nonlocal measure.
    /// @param rate if not null: its derivative
    MohrCoulombStrength
    strength_at(const double         plastic_strain,
                const double        *variables,
                MohrCoulombStrength *rate = nullptr) const;

    Angles peak;
    Angles residual;
    double tensile_strength; // kPa
    double softening_strain; // within a step, if it softens there; 0: none
    SofteningMeasure measure;
  };


  /// Degrees. Beyond it tangents (57) are no friction of soil.
  constexpr double largest_friction_angle = 89.;


  /// What the user says of it: in "Materials/<name>".
  struct MohrCoulombParameters
  {
    std::string cohesion           = "5";  // c, kPa; may be an expression
    std::string friction_angle     = "30"; // phi, degrees; likewise
    std::string dilatancy_angle    = "0";  // psi, degrees; likewise
    std::string tensile_strength   = "0";  // kPa, or "apex"
    std::string residual_cohesion  = "cohesion";
    std::string residual_friction  = "friction_angle";
    std::string residual_dilatancy = "dilatancy_angle";
    double      softening_strain   = 0.; // -
    /// Shear strength by normal stress, "0: 2, 50: 30, ..." (kPa), instead of
    /// cohesion and friction angle; empty: these.
    std::string strength_table;

    /// Is the strength a table (ShearStrengthTable)?
    bool
    has_table() const;

    void
    add_parameters(ParameterHandler &prm);

    /// Can they be read?
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

    /**
     * The softening strain (-) below which a point loses its strength with less
     * strain than it unloads elastically.
     *
     * @param pressure -(s_1 + s_3) / 2 (kPa) of the point; with 0 it is the
     *        cohesion alone. What are expressions does not count.
     */
    double
    snap_back_strain(const LinearElasticParameters &elastic,
                     const double                   softening_scale,
                     const double                   pressure) const;
  };


  /// @param path "Materials/<name>/"
  std::unique_ptr<Material>
  make_mohr_coulomb(const double                   density,
                    const LinearElasticParameters &elastic,
                    const MohrCoulombParameters   &parameters,
                    const SofteningMeasure        &measure,
                    const std::string             &path);
} // namespace Waker

#endif
