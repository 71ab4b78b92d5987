// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/simulation/step_control.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// After this many steps at a halved time step it is doubled again.
    constexpr unsigned int steps_before_doubling = 4;

    /// The rest that long steps wait for doubles with each failure, so often.
    constexpr unsigned int most_doublings = 6;
  } // namespace


  template <int dim>
  StepControl<dim>::StepControl(const TimeParameters &parameters,
                                State<dim>           &state)
    : parameters(&parameters)
    , has_long_steps(scheme_traits(parameters).has_long_steps)
    , state(&state)
  {}


  template <int dim>
  double
  StepControl<dim>::next(const double wanted) const
  {
    const double dt = std::ldexp(wanted, -static_cast<int>(state->halvings));
    return std::min(dt, parameters->end_time - state->time);
  }


  template <int dim>
  void
  StepControl<dim>::accept(const double dt, const StepReport<dim> &report)
  {
    state->time += dt;
    ++state->step;
    state->last_dt             = dt;
    state->mean_plastic_strain = report.mean_plastic_strain;
    state->displacement_rate   = report.displacement_rate;
    LongSteps &long_steps      = state->long_steps;
    if (long_steps.active)
      {
        // Whatever it took to get there, now the body is in balance.
        state->mean_plastic_strain = 0.;
        state->displacement_rate   = 0.;
        ++long_steps.n;
        long_steps.time += dt;
      }
    else if (has_long_steps && (long_steps.last || state->step == 1))
      ++long_steps.motions;
    long_steps.last = long_steps.active;
    if (state->halvings > 0 &&
        ++state->steps_since_change >= steps_before_doubling)
      {
        --state->halvings;
        state->steps_since_change = 0;
        if (long_steps.active)
          long_steps.failures = 0;
      }
  }


  template <int dim>
  void
  StepControl<dim>::try_long_steps(const double rest_duration)
  {
    LongSteps &long_steps = state->long_steps;
    if (!has_long_steps || long_steps.active)
      return;
    const double wait =
      std::ldexp(rest_duration, std::min(long_steps.failures, most_doublings));
    if (state->time < long_steps.given_up + wait)
      return;
    long_steps.active         = true;
    state->halvings           = parameters->maximum_halvings;
    state->steps_since_change = 0;
  }


  template <int dim>
  void
  StepControl<dim>::leave_long_steps()
  {
    state->long_steps.active   = false;
    state->long_steps.given_up = state->time;
    ++state->long_steps.failures;
    state->halvings = 0;
    state->rest     = RestRecord(); // it moves
  }


  template <int dim>
  void
  StepControl<dim>::count(const StepReport<dim> &report)
  {
    state->newton_iterations += report.newton_iterations;
    state->linear_iterations += report.linear_iterations;
    state->unconverged_steps += !report.converged;
  }


  template <int dim>
  void
  StepControl<dim>::halve(const double dt, const StepReport<dim> &report)
  {
    state->steps_since_change = 0;
    if (state->halvings == parameters->maximum_halvings)
      {
        if (is_long())
          return leave_long_steps();
        std::ostringstream message;
        message << "the step from t = " << state->time
                << " s does not converge, not even with dt = " << dt
                << " s (residual " << report.residuals.back() << ")";
        throw NumericalFailure(message.str());
      }
    ++state->halvings;
  }


  template class StepControl<2>;
  template class StepControl<3>;
} // namespace Waker
