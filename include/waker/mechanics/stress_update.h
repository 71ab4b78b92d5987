// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_stress_update_h
#define waker_mechanics_stress_update_h

#include <deal.II/base/symmetric_tensor.h>

#include <waker/mapping/weights.h>
#include <waker/materials/material.h>
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
   */
  template <int dim>
  class StressUpdate
  {
  public:
    StressUpdate(const Materials &materials, const bool objective_rate);

    /**
     * Evaluate stress and internal force (eqs. 2.28, 2.33 of Remmerswaal
     * 2023; mechanics/kinematics.h).
     *
     * @param increment displacement increments of the nodes (m)
     * @param internal_force out: sum_p V_p stress_p grad S_ip (kN)
     */
    void
    evaluate(const MaterialPoints<dim> &points,
             const Weights<dim>        &weights,
             const NodalVector         &increment,
             NodalVector               &internal_force);

    /// The derivative of V_p stress_p with respect to the gradient of the
    /// increment (see Kinematics::stress_derivative).
    struct PointTangent
    {
      double A[dim * (dim + 1) / 2][dim * dim];
    };

    /// The tangents of all points at the last evaluation (kN m or kN/m).
    void
    tangents(const MaterialPoints<dim> &points,
             std::vector<PointTangent> &tangents) const;

    /// The materials' algorithmic tangents there (kPa), for double mapping.
    void
    material_tangents(const MaterialPoints<dim>          &points,
                      std::vector<SymmetricTensor<4, 3>> &tangents) const;

    /// Write the stresses and variables of the last evaluation to the points,
    /// and sum up what happened.
    StressReport
    accept(MaterialPoints<dim> &points) const;

  private:
    /// evaluate() for points begin..end-1, at most Material::block_size and of
    /// one material.
    void
    evaluate_block(const MaterialPoints<dim> &points,
                   const Weights<dim>        &weights,
                   const std::size_t          begin,
                   const std::size_t          end,
                   const double              *increment,
                   double                    *force);

    /// Find the arrays of the materials' variables among the points' scalars.
    void
    find_variables(const MaterialPoints<dim> &points);

    const Materials              *materials;
    bool                          objective_rate;
    std::vector<std::vector<int>> variable_arrays; // per material
    unsigned int                  n_variables; // largest number per material
    std::vector<Tensor<2, dim>>   gradients;   // of the increment
    std::vector<SymmetricTensor<2, 3>> new_stress;    // per point
    std::vector<double>                new_variables; // n_variables per point
    std::vector<double>                dissipation;   // per point, kPa
  };
} // namespace Waker

#endif
