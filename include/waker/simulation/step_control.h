// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_step_control_h
#define waker_simulation_step_control_h

#include <waker/case/state.h>
#include <waker/mechanics/time_scheme.h>

namespace Waker
{
  /**
   * The length of a realisation's steps, and the count of its work: a step that
   * does not converge is tried again with half the length; after some steps
   * that do, the length is doubled again. Both are kept in the state.
   *
   * With a scheme that has long steps (SchemeTraits) it also says which steps
   * come: long ones until even the shortest of them does not converge; then the
   * body moves, until it has been at rest for a while (try_long_steps()).
   */
  template <int dim>
  class StepControl
  {
  public:
    /// Both must outlive this object.
    StepControl(const TimeParameters &parameters, State<dim> &state);

    /// The step that is tried next (s).
    /// @param wanted by the scheme (s)
    double
    next(const double wanted) const;

    /// Is the next step a long one?
    bool
    is_long() const
    {
      return state->long_steps.active;
    }

    /// The body has been at rest for this time (s): a long step may be tried,
    /// the shortest first. Where they have failed, only after a longer rest.
    void
    try_long_steps(const double rest_duration);

    /**
     * Solve a step, shorter and shorter until that converges.
     * @param wanted the step that the scheme of now wants (s), when asked
     * @param attempt solves a step of the given length (s), returns its report
     * @return the length (s)
     * @throws NumericalFailure if the smallest one does not converge
     */
    template <typename Wanted, typename Attempt>
    double
    solve(const Wanted &wanted, const Attempt &attempt)
    {
      while (true)
        {
          const double           dt     = next(wanted());
          const StepReport<dim> &report = attempt(dt);
          count(report);
          if (report.converged)
            return dt;
          halve(dt, report);
        }
    }

    /// The step is done: time goes on, and longer steps may come.
    void
    accept(const double dt, const StepReport<dim> &report);

  private:
    void
    count(const StepReport<dim> &report);

    void
    halve(const double dt, const StepReport<dim> &report);

    void
    leave_long_steps();

    const TimeParameters *parameters;
    bool                  has_long_steps;
    State<dim>           *state;
  };
} // namespace Waker

#endif
