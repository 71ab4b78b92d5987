// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_stress_update_h
#define waker_mechanics_stress_update_h

#include <deal.II/base/symmetric_tensor.h>

#include <waker/mapping/weights.h>
#include <waker/materials/material.h>
#include <waker/mechanics/block_motion.h>
#include <waker/mechanics/logarithmic_strain.h>
#include <waker/nodes/nodal_vector.h>
#include <waker/particles/material_points.h>

#include <memory>
#include <vector>

namespace Waker
{
  /// The materials of a case, by number.
  using Materials = std::vector<std::unique_ptr<Material>>;

  /// Give the points the scalars that their materials declare, at their
  /// initial values.
  template <int dim>
  void
  declare_material_variables(const Materials     &materials,
                             MaterialPoints<dim> &points);

  /// Elastic energy of the points' stresses (kJ).
  template <int dim>
  double
  elastic_energy(const MaterialPoints<dim> &points, const Materials &materials);

  /// Sums over the points, of the last evaluation.
  struct StressReport
  {
    double dissipation    = 0.; // plastic, kJ
    double work_start     = 0.; // sum V stress(t)    : grad(du), kJ
    double work_end       = 0.; // sum V stress(t+dt) : grad(du), kJ
    double elastic_energy = 0.; // at the end, kJ
    double plastic_strain = 0.; // mean increment of "plastic strain", -
  };

  /**
   * From a displacement increment to stresses and internal force: the one
   * place where points are strained. Always from the state at the start of the
   * step, never from the last iteration; the points stay as they are until
   * accept().
   *
   * Logarithmic strain (mechanics/logarithmic_strain.h) needs no state of its
   * own: the elastic strain is that of the Kirchhoff stress, stress times
   * V/V0, where V0 is mass over density. The force is that in the deformed
   * place, and accept() updates the volumes.
   */
  template <int dim>
  class StressUpdate
  {
  public:
    /// @param logarithmic instead of the strain of the step; the objective
    ///        rate is then of no account
    StressUpdate(const Materials &materials,
                 const bool       objective_rate,
                 const bool       logarithmic = false);

    bool
    is_logarithmic() const
    {
      return logarithmic;
    }

    /**
     * Evaluate stress and internal force (eqs. 2.28, 2.33 of Remmerswaal
     * 2023; mechanics/kinematics.h).
     *
     * @param increment displacement increments of the nodes (m)
     * @param internal_force out: sum_p V_p stress_p grad S_ip (kN);
     *        logarithmic: sum_p V0_p P_p grad S_ip with
     *        LogarithmicStep::first_piola()
     */
    void
    evaluate(const MaterialPoints<dim> &points,
             const Weights<dim>        &weights,
             const NodalVector         &increment,
             NodalVector               &internal_force);

    /// The derivatives of V_p stress_p with respect to the gradient of the
    /// increment (see Kinematics::stress_derivative), of the points 16 b + l:
    /// A[a][dim c + d][l].
    struct BlockTangent
    {
      double A[dim * (dim + 1) / 2][dim * dim][Material::block_size];
    };

    /// The tangents of block b at the last evaluation (kN m or kN/m); entries
    /// without a point are zero.
    void
    tangent(const MaterialPoints<dim> &points,
            const std::size_t          b,
            BlockTangent              &tangent) const;

    /// The same with logarithmic strain, where the stress is not symmetric:
    /// A[dim i + j][dim k + l][point].
    struct FullBlockTangent
    {
      double A[dim * dim][dim * dim][Material::block_size];
    };

    void
    tangent(const MaterialPoints<dim> &points,
            const std::size_t          b,
            FullBlockTangent          &tangent) const;

    /// The materials' algorithmic tangents there (kPa), for double mapping;
    /// logarithmic: with respect to the trial strain.
    void
    material_tangents(const MaterialPoints<dim>          &points,
                      std::vector<SymmetricTensor<4, 3>> &tangents) const;

    /// Write the stresses and variables of the last evaluation to the points
    /// (logarithmic: also volume and, if it is kept, deformation), and sum up
    /// what happened. They are computed once more: cheaper than to
    /// keep them.
    StressReport
    accept(MaterialPoints<dim> &points) const;

  private:
    /// Scalars per point that fit on the stack; more is a material's mistake.
    static constexpr unsigned int max_variables = 16;

    /// Points begin..end-1: neighbours of one material, within a block.
    struct Range
    {
      std::size_t begin, end;
    };

    /// The range that starts with the point `begin`.
    static Range
    range_from(const MaterialPoints<dim> &points, const std::size_t begin);

    /// What a block needs for its material, unused entries zero.
    struct Work
    {
      Material::Block  block;
      BlockMotion<dim> motion;
      double           variables[max_variables][Material::block_size];
    };

    /// Take stresses, variables and gradients, and move the block.
    void
    load(const MaterialPoints<dim> &points,
         const Range               &range,
         Work                      &work) const;

    /// What the elastic logarithmic strain of point p was.
    SymmetricTensor<2, 3>
    start_strain(const MaterialPoints<dim> &points, const std::size_t p) const;

    /// Volume of point p without stress (m^dim).
    double
    natural_volume(const MaterialPoints<dim> &points,
                   const std::size_t          p) const;

    /// Make the block one of logarithmic strains, from no stress.
    void
    load_logarithmic(const Range &range, Work &work) const;

    /// accept() for the points of a range, their Kirchhoff stresses in the
    /// block.
    void
    accept_logarithmic(const Range           &range,
                       const Material::Block &block,
                       MaterialPoints<dim>   &points,
                       StressReport          &report) const;

    void
    evaluate_range(const MaterialPoints<dim> &points,
                   const Weights<dim>        &weights,
                   const Range               &range,
                   const double              *increment,
                   double                    *force);

    /// Find the arrays of the materials' variables among the points' scalars.
    void
    find_variables(const MaterialPoints<dim> &points);

    const Materials *materials;
    bool             objective_rate;
    bool             logarithmic;
    /// Names of the materials' variables, and their places among the scalars.
    std::vector<std::vector<std::string>> variable_names;
    std::vector<std::vector<int>>         variable_arrays;
    std::vector<Tensor<2, dim>>           gradients; // of the increment
    std::vector<LogarithmicStep<dim>>     steps;     // logarithmic: the points'
  };
} // namespace Waker

#endif
