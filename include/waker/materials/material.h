// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_materials_material_h
#define waker_materials_material_h

#include <deal.II/base/symmetric_tensor.h>

#include <waker/base/numbers.h>
#include <waker/materials/softening_measure.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Waker
{
  using namespace dealii;

  /// What a point's variable is at the start: a number, or what an expression
  /// of the point's place says (simulation/initial_properties.h).
  struct InitialValue
  {
    InitialValue(const double number, const std::string &path = "")
      : number(number)
      , path(path)
    {}

    InitialValue(const std::string &expression, const std::string &path)
      : number(nan)
      , expression(expression)
      , path(path)
    {}

    bool
    varies() const
    {
      return !expression.empty();
    }

    double      number; // NaN if it varies
    std::string expression;
    std::string path; // of the parameter, for errors
  };


  /// A scalar that a material keeps for each point.
  struct MaterialVariable
  {
    /// What a variable is to those who do not know the law.
    enum class Role
    {
      strength,          // divided by a strength reduction
      residual_strength, // what softening leaves of the strength; likewise
      dilatancy,         // change of volume by shear
      stiffness,
      history,    // what the point has gone through
      coefficient // of the strength at the start: of it alone
    };

    std::string  name; // "plastic strain"
    std::string  unit; // "-", "kPa", ...
    InitialValue initial_value;
    Role         role;
    /// Its initial value in the expressions of variables further down the
    /// list; empty: they cannot ask for it.
    std::string symbol = "";
    /// The variable of whose random field it keeps its share, unless it has a
    /// field of its own; empty: of none.
    std::string goes_along_with = "";
    /// Of a coefficient: the least that the law takes (of its unit). One that
    /// is drawn below it counts as this.
    double least = -std::numeric_limits<double>::infinity();
  };

  /// Does a strength reduction divide what has this role?
  bool
  is_strength(const MaterialVariable::Role role);

  class Material;

  /// The material's first variable of a role; none if the law has no such one.
  std::optional<MaterialVariable>
  variable_of(const Material &material, const MaterialVariable::Role role);

  /**
   * A constitutive law, always in 3D stress: plane strain is a strain with
   * zero out-of-plane components. Stress is Cauchy, in kPa, tension positive.
   *
   * Laws are incremental: the stress at the end of a step follows from the
   * stress at its start (already turned with the body, see
   * mechanics/kinematics.h) and the strain increment. They are evaluated from
   * the start of the step in every iteration and keep no state of their own:
   * everything that belongs to a point stands in its variables.
   */
  class Material
  {
  public:
    virtual ~Material() = default;

    /// What the material keeps for each point, in the order of `variables`
    /// below. The same name in two materials means the same thing.
    virtual std::vector<MaterialVariable>
    variables() const = 0;

    /// What the initial values of the variables are made of, where these are
    /// expressions of it (`symbol`), as the S of a SHANSEP soil. The points do
    /// not keep it, unless a random field varies it. By default there is none.
    virtual std::vector<MaterialVariable>
    coefficients() const
    {
      return {};
    }

    /// Can a point start with these variables? If not: the number of the first
    /// that is wrong, and what is allowed. By default anything finite is.
    virtual std::optional<std::pair<unsigned int, std::string>>
    initial_problem(const std::vector<double> &variables) const;

    /// Divide the strengths of a point by a factor, for a strength reduction.
    /// By default each of the variables that is_strength().
    virtual void
    divide_strengths(const double factor, double *variables) const;

    /// A point bears this stress (kPa, as of update()) in situ: it has gone
    /// through what that takes. By default that leaves no trace.
    virtual void
    consolidate(const SymmetricTensor<2, 3> & /*stress*/,
                double * /*variables*/) const
    {}

    /**
     * The stress after a strain increment.
     *
     * @param strain_increment of the step, 3x3 (-)
     * @param stress in: at the start of the step, turned; out: at its end (kPa)
     * @param variables one number per entry of variables(); in: at the start
     *        of the step; out: at its end
     * @param tangent if not null: the algorithmic tangent, d stress_out /
     *        d strain_increment (kPa)
     * @return the plastic dissipation of the step per volume (kPa), >= 0
     */
    virtual double
    update(const SymmetricTensor<2, 3> &strain_increment,
           SymmetricTensor<2, 3>       &stress,
           double                      *variables,
           SymmetricTensor<4, 3>       *tangent) const = 0;

    /// What softens it. Unless that is local, update() does not: it leaves the
    /// strengths as they are, and soften() takes them along after the step.
    virtual SofteningMeasure
    softening_measure() const
    {
      return {};
    }

    /// Is there anything left of a point for soften() to take?
    virtual bool
    can_soften(const double * /*variables*/) const
    {
      return false;
    }

    /// The softening measure of a point has grown by `increment` (-) in a step.
    virtual void
    soften(const double /*increment*/, double * /*variables*/) const
    {}

    /// Points per block of update_block().
    static constexpr unsigned int block_size = 16;

    /// A block of points of this material: component (xx, yy, zz, xy, xz, yz)
    /// or variable first, point second. Unused entries at the end are zero.
    struct Block
    {
      double strain_increment[6][block_size];
      double stress[6][block_size]; // in and out, as in update()
      double (*variables)[block_size];
      double dissipation[block_size]; // out
    };

    /// update() without tangent for `n_points` points at once. By default
    /// they are updated one by one; a law that matters for the speed brings a
    /// loop that the compiler can vectorise, with the same result.
    virtual void
    update_block(const unsigned int n_points, Block &block) const;

    /// Elastic energy per volume (kPa) of a block's stresses, as they are after
    /// update_block(). By default that of bulk_modulus() and shear_modulus().
    virtual void
    elastic_energy(const Block &block, double (&energy)[block_size]) const;

    /// Mass density (Mg/m^3).
    virtual double
    density() const = 0;

    /// Elastic shear and bulk moduli (kPa): wave speed, stable step, energy. Of
    /// a point with a stiffness ratio they are these times the ratio.
    virtual double
    shear_modulus() const = 0;

    virtual double
    bulk_modulus() const = 0;

    /// What the water in the pores of undrained soil adds to the bulk modulus
    /// (kPa). In situ, where the soil has drained, it adds nothing.
    virtual double
    pore_fluid_stiffness() const
    {
      return 0.;
    }

    /// Number of the variable that both moduli are multiplied by at a point,
    /// its "stiffness ratio"; none: they are the same at all points.
    virtual std::optional<unsigned int>
    stiffness_variable() const
    {
      return {};
    }

    /// The stiffness ratio below which softening snaps back.
    virtual double
    least_stiffness_ratio() const
    {
      return 0.;
    }

    /// Is the stress effective: does the water in the ground
    /// (loads/pore_water.h) carry the rest of the total one? By default it is
    /// the total stress.
    virtual bool
    is_of_effective_stress() const
    {
      return false;
    }

    /// Is each algorithmic tangent symmetric, D_ijkl = D_klij? By default yes.
    virtual bool
    has_symmetric_tangent() const
    {
      return true;
    }

    /**
     * The algorithmic tangents that update() would give for the block, which
     * may be overwritten.
     *
     * @param n_components the number of the components that are wanted
     * @param components their numbers, of xx, yy, zz, xy, xz, yz
     * @param tangent out: [n_components a + b][point], d stress_a / d strain_b
     *        (kPa), strain_b as a tensor's entry, taken once
     */
    virtual void
    tangent_block(const unsigned int  n_points,
                  Block              &block,
                  const unsigned int  n_components,
                  const unsigned int *components,
                  double (*tangent)[block_size]) const;
  };


  /// Divide n_rows rows of a block's entries by the points' stiffness ratios,
  /// if they have some.
  void
  divide_by_stiffness(const Material        &material,
                      const unsigned int     n_points,
                      const Material::Block &block,
                      const unsigned int     n_rows,
                      double (*rows)[Material::block_size]);
} // namespace Waker

#endif
