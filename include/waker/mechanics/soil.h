// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_soil_h
#define waker_mechanics_soil_h

#include <waker/mechanics/consistent_tangent.h>
#include <waker/mechanics/double_mapped_tangent.h>
#include <waker/mechanics/parameters.h>
#include <waker/mechanics/stress_update.h>
#include <waker/nodes/reached_nodes.h>
#include <waker/nodes/resistance.h>

#include <variant>

namespace Waker
{
  /**
   * The resistance of the soil: the internal force of the points' stresses at
   * the end of the step (eq. 2.28 of Remmerswaal 2023; StressUpdate), and a
   * tangent to it (eq. 2.30). Their stresses are what is carried from step to
   * step.
   */
  template <int dim>
  class Soil : public Resistance<dim>
  {
  public:
    /// @param weights of the points; must outlive this object
    /// @param tangent NewtonParameters::tangent
    Soil(const Weights<dim> &weights,
         StressUpdate<dim>   stress_update,
         const Tangent       tangent);

    typename Resistance<dim>::Role
    role() const override
    {
      return Resistance<dim>::Role::body;
    }

    void
    begin(const MaterialPoints<dim> &points,
          const NodalState          &nodes,
          const double               t,
          const double               dt) override;

    void
    add_force(const NodalVector &increment, NodalVector &internal) override;

    void
    add_start_force(NodalVector &internal) override;

    void
    linearise() override;

    void
    vmult_add(NodalVector &dst, const NodalVector &src) const override;

    void
    add_diagonal(NodalVector &diagonal) const override;

    /// Of the points, whatever the tangent (add_point_stiffness()).
    void
    add_entries(MatrixEntries &entries) const override;

    bool
    is_symmetric() const override;

    /// The stresses of the last add_force().
    Tensor<1, dim>
    accept(const NodalVector &increment, MaterialPoints<dim> &points) override;

    ResistanceWork
    work(const NodalVector &increment) const override;

    /// Of the step that has been accepted.
    const StressReport &
    report() const
    {
      return stress_report;
    }

  private:
    using TangentOperator =
      std::variant<ConsistentTangent<dim>, DoubleMappedTangent<dim>>;

    const Operator &
    stiffness() const;

    const Weights<dim>        *weights;
    StressUpdate<dim>          stress_update;
    StressReport               stress_report;
    TangentOperator            tangent;
    ReachedNodes               reached;
    const MaterialPoints<dim> *points = nullptr; // of the step
    mutable NodalVector        work_space;       // force or product of the soil
  };
} // namespace Waker

#endif
