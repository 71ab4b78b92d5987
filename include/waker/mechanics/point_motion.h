// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_point_motion_h
#define waker_mechanics_point_motion_h

#include <waker/mapping/weights.h>
#include <waker/materials/material.h>
#include <waker/mechanics/filled_cells.h>
#include <waker/mechanics/parameters.h>
#include <waker/nodes/nodal_vector.h>
#include <waker/particles/material_points.h>

#include <memory>

namespace Waker
{
  template <int dim>
  class PointTangents;


  /// Of the numbers in products with a tangent.
  enum class Precision
  {
    single_precision,
    double_precision
  };


  /// Sums over the points, of the last evaluation.
  struct StressReport
  {
    double dissipation    = 0.; // plastic, kJ
    double work_start     = 0.; // of the internal force at t, kJ
    double work_end       = 0.; // at t + dt, kJ
    double elastic_energy = 0.; // at the end, kJ
    double plastic_strain = 0.; // mean increment of "plastic strain", -
  };


  /// Points begin..end-1: neighbours of one material, within a block.
  struct PointRange
  {
    std::size_t begin, end;

    unsigned int
    size() const
    {
      return end - begin;
    }
  };


  /**
   * How a point's motion becomes strain, and its stress a force: the
   * kinematics of a step. A material knows nothing of it; StressUpdate and the
   * tangents know nothing else of it. A case of it offers, for points of one
   * material at a time, the trial strain that the material acts on, the force
   * that is conjugate to it, their derivative, and what the points take over at
   * the end of the step.
   */
  template <int dim>
  class PointMotion
  {
  public:
    virtual ~PointMotion() = default;

    /// At the start of a step, before all else: for the points as they lie.
    virtual void
    start(const MaterialPoints<dim> &points, const Weights<dim> &weights) = 0;

    /// Take the motion of a range from the nodes' displacement increments (m).
    virtual void
    gather(const Material            &material,
           const MaterialPoints<dim> &points,
           const Weights<dim>        &weights,
           const PointRange          &range,
           const double              *increment) = 0;

    /// What the material acts on: strain increments, and the stresses at the
    /// start of the step as they are turned. Unused entries are zero.
    virtual void
    trial(const MaterialPoints<dim> &points,
          const PointRange          &range,
          Material::Block           &block) const = 0;

    /// force += that of the material's stresses (kN)
    virtual void
    scatter(const Material            &material,
            const MaterialPoints<dim> &points,
            const Weights<dim>        &weights,
            const PointRange          &range,
            const Material::Block     &block,
            double                    *force) const = 0;

    /// force += that of the points' own stresses, at rest (kN)
    virtual void
    add_force_of_stress(const MaterialPoints<dim> &points,
                        const Weights<dim>        &weights,
                        NodalVector               &force) const = 0;

    /// The points take the material's stresses, and what else has changed;
    /// works and energies are added to the report.
    virtual void
    commit(const Material        &material,
           const PointRange      &range,
           const Material::Block &block,
           MaterialPoints<dim>   &points,
           StressReport          &report) const = 0;

    /// Does derivative() need the stresses at the end of the step?
    virtual bool
    derivative_needs_stress() const
    {
      return false;
    }

    /**
     * The derivatives of what scatter() takes with respect to what gather()
     * finds, in the layout of make_tangents().
     *
     * @param trial the block before the material has acted; may be overwritten
     * @param end the block after it, if it is needed
     * @param A out: for the points of the range, as first entries
     */
    virtual void
    derivative(const Material            &material,
               const MaterialPoints<dim> &points,
               const PointRange          &range,
               Material::Block           &trial,
               const Material::Block     *end,
               double                    *A) const = 0;

    /// Storage for the derivatives of all points, and their product. Single
    /// precision is there in 3D only: it does not pay in 2D.
    virtual std::unique_ptr<PointTangents<dim>>
    make_tangents(const Precision precision) const = 0;

    /// Is the dilatation that of the cells' centres? An element's stiffness
    /// (DoubleMappedTangent) takes its own from there, too.
    virtual bool
    has_mean_dilatation() const
    {
      return false;
    }

    /// In which of them, if it is.
    virtual BBarCells
    b_bar_cells() const
    {
      return BBarCells::filled;
    }

    /// How far, and from which part of its domain, at each point: since
    /// start(). Null if it is not.
    virtual const FilledCells<dim> *
    filled_cells() const
    {
      return nullptr;
    }
  };


  /// The kinematics of "Kinematics and mapping".
  template <int dim>
  std::unique_ptr<PointMotion<dim>>
  make_point_motion(const MappingParameters &parameters);

  /// The same for strains that are small in each step, without rotation: for
  /// in-situ stresses, with points that stay in place.
  template <int dim>
  std::unique_ptr<PointMotion<dim>>
  make_small_motion(const MappingParameters &parameters);
} // namespace Waker

#endif
