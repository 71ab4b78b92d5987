// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_stress_update_h
#define waker_mechanics_stress_update_h

#include <deal.II/base/symmetric_tensor.h>

#include <waker/mapping/weights.h>
#include <waker/materials/material.h>
#include <waker/mechanics/nonlocal_softening.h>
#include <waker/mechanics/point_motion.h>
#include <waker/nodes/nodal_vector.h>
#include <waker/particles/material_points.h>

#include <memory>
#include <vector>

namespace Waker
{
  /// The materials of a case, by number.
  using Materials = std::vector<std::unique_ptr<Material>>;

  /// Of a tangent: its isotropic part (kPa).
  struct IsotropicModuli
  {
    double bulk, shear;
  };

  /// Give the points the scalars that their materials declare, at their
  /// initial values.
  template <int dim>
  void
  declare_material_variables(const Materials     &materials,
                             MaterialPoints<dim> &points);

  /// The moduli of point p over those of its material (-).
  template <int dim>
  double
  stiffness_ratio(const MaterialPoints<dim> &points,
                  const Materials           &materials,
                  const std::size_t          p);

  /// The points bear their stress in situ (Material::consolidate()).
  template <int dim>
  void
  consolidate(const Materials &materials, MaterialPoints<dim> &points);

  /// How far a stress lies outside what a law bears after it has consolidated
  /// under it (kPa): what a return without a strain takes away.
  /// @param variables of the law, at the start
  double
  stress_excess(const Material              &law,
                const std::vector<double>   &variables,
                const SymmetricTensor<2, 3> &stress);

  /// Does a law bear this stress? Then a return without a strain leaves it as
  /// it is, to round-off.
  bool
  is_borne(const Material              &law,
           const std::vector<double>   &variables,
           const SymmetricTensor<2, 3> &stress);

  /// The variables of the law of a point's material, in their order.
  template <int dim>
  std::vector<double>
  variables_of(const MaterialPoints<dim> &points,
               const Materials           &materials,
               const std::size_t          p);

  /// Elastic energy of the points' stresses (kJ). Variables that the points
  /// lack are 0.
  template <int dim>
  double
  elastic_energy(const MaterialPoints<dim> &points, const Materials &materials);

  /**
   * From a displacement increment to stresses and internal force: the one
   * place where points are strained. Always from the state at the start of the
   * step, never from the last iteration; the points stay as they are until
   * accept(). What strain is, and what its force, the motion says.
   */
  template <int dim>
  class StressUpdate
  {
  public:
    /// @param materials must outlive this object
    StressUpdate(const Materials                  &materials,
                 std::unique_ptr<PointMotion<dim>> motion);

    const PointMotion<dim> &
    point_motion() const
    {
      return *motion;
    }

    /// Start a step, with the points as they lie.
    void
    begin(const MaterialPoints<dim> &points, const Weights<dim> &weights);

    /**
     * Evaluate stress and internal force, after begin() with the same points
     * and weights.
     *
     * @param increment displacement increments of the nodes (m)
     * @param internal_force out: see PointMotion::scatter() (kN)
     */
    void
    evaluate(const MaterialPoints<dim> &points,
             const Weights<dim>        &weights,
             const NodalVector         &increment,
             NodalVector               &internal_force);

    /// The derivatives of block b at the last evaluation, in the layout of the
    /// motion's tangents; entries without a point are zero.
    /// @param A out: [n_out][n_in][block_size]
    void
    tangent(const MaterialPoints<dim> &points,
            const std::size_t          b,
            double                    *A,
            const unsigned int         n_out,
            const unsigned int         n_in) const;

    /// The materials' algorithmic tangents there (kPa) with respect to the
    /// trial strain, for double mapping.
    void
    material_tangents(const MaterialPoints<dim>          &points,
                      std::vector<SymmetricTensor<4, 3>> &tangents) const;

    /// The isotropic part of each; not less than a thousandth of the elastic
    /// moduli, so that a stiffness made of it is positive.
    void
    isotropic_tangents(const MaterialPoints<dim>    &points,
                       std::vector<IsotropicModuli> &moduli) const;

    /// Are they symmetric, those of all materials?
    bool
    has_symmetric_tangents() const;

    /// Write the stresses and variables of the last evaluation to the points,
    /// and sum up what happened. They are computed once more: cheaper than to
    /// keep them.
    StressReport
    accept(MaterialPoints<dim> &points);

    /// After accept(): points soften by what happened around them
    /// (NonlocalSoftening).
    /// @param grid of this rank's points, and of those around them
    void
    soften(MaterialPoints<dim> &points, const BackgroundGrid<dim> &grid);

  private:
    /// Scalars per point that fit on the stack; more is a material's mistake.
    static constexpr unsigned int max_variables = 16;

    /// f(point, material, tangent) for all of them.
    template <typename Function>
    void
    for_each_tangent(const MaterialPoints<dim> &points,
                     const Function            &f) const;

    /// The range that starts with the point `begin`.
    static PointRange
    range_from(const MaterialPoints<dim> &points, const std::size_t begin);

    /// What a block needs for its material, unused entries zero.
    struct Work
    {
      Material::Block block;
      double          variables[max_variables][Material::block_size];
    };

    /// The block before the material has acted.
    void
    load(const MaterialPoints<dim> &points,
         const PointRange          &range,
         Work                      &work) const;

    /// Find the arrays of the materials' variables among the points' scalars.
    void
    find_variables(const MaterialPoints<dim> &points);

    const Materials                  *materials;
    std::unique_ptr<PointMotion<dim>> motion;
    NonlocalSoftening<dim>            nonlocal;
    std::vector<double>
      increments; // of the plastic strain, for that; else empty
    /// Names of the materials' variables, and their places among the scalars.
    std::vector<std::vector<std::string>> variable_names;
    std::vector<std::vector<int>>         variable_arrays;
    std::size_t n_begun = std::size_t(-1); // points that begin() has seen
  };
} // namespace Waker

#endif
