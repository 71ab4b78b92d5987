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
  } // namespace


  template <int dim>
  StepControl<dim>::StepControl(const TimeParameters &parameters,
                                State<dim>           &state)
    : parameters(&parameters)
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
    if (state->halvings > 0 &&
        ++state->steps_since_change >= steps_before_doubling)
      {
        --state->halvings;
        state->steps_since_change = 0;
      }
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
