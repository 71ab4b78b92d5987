// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_implicit_scheme_h
#define waker_mechanics_implicit_scheme_h

#include <waker/mechanics/held_soil.h>
#include <waker/mechanics/newton.h>
#include <waker/mechanics/time_scheme.h>

#include <vector>

namespace Waker
{
  /**
   * The outline of an implicit step: first guess, Newton's method (eq. 2.23 of
   * Remmerswaal 2023), motion of the nodes; then the resistances take the step,
   * the points follow, and the works are summed up. A scheme says what inertia
   * and loads there are in the residual, how nodes and points move, and what
   * the works of the external force are.
   */
  template <int dim>
  class ImplicitScheme : public TimeScheme<dim>
  {
  public:
    ImplicitScheme(const SchemeInput<dim> &in, const LinearMethod method);

    double
    time_step(const MaterialPoints<dim> &) const override
    {
      return in.time.time_step;
    }

    StepReport<dim>
    solve(const MaterialPoints<dim> &points,
          const double               t,
          const double               dt,
          NodalState                &nodes) final;

    void
    to_points(const double         t,
              const double         dt,
              NodalState          &nodes,
              MaterialPoints<dim> &points,
              StepReport<dim>     &report) final;

  protected:
    using ResidualTerms = typename NewtonSolver<dim>::ResidualTerms;

    /// What beside the resistances is in the residual, after the resistances
    /// have begun the step. May guess the increment, which is 0; the removed
    /// dofs are set later.
    virtual ResidualTerms
    begin(const double t, const double dt, NodalState &nodes) = 0;

    /// Velocity and acceleration of the nodes at the end, by the increment.
    virtual void
    move_nodes(const double dt, NodalState &nodes) const = 0;

    /// Carry the motion to the points. Sets kinetic energy and displacement
    /// rate of the report.
    virtual void
    move_points(const double         dt,
                const NodalState    &nodes,
                MaterialPoints<dim> &points,
                StepReport<dim>     &report) = 0;

    /// Works of external force, inertia and removed equations, and their
    /// reaction.
    /// @param internal work of the resistances under the ramp
    virtual void
    add_works(const double          t,
              const double          dt,
              const NodalState     &nodes,
              const ResistanceWork &internal,
              StepReport<dim>      &report) = 0;

    /// Beside soil and supports; before the first step.
    void
    add_resistance(Resistance<dim> &resistance)
    {
      resistances.push_back(&resistance);
    }

    const SchemeInput<dim> in;
    Resistances<dim>       resistances;
    ReachedNodes           reached; // of the step
    std::vector<double>    removed_increments;

  private:
    HeldSoil<dim>     held;
    NewtonSolver<dim> newton;
  };
} // namespace Waker

#endif
