// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_initial_stress_h
#define waker_case_initial_stress_h

#include <waker/case/case.h>
#include <waker/case/state.h>

namespace Waker
{
  /// The acceleration of the points that fits the forces at t = 0.
  /// @param scene of the points, with their loads and internal forces
  template <int dim>
  void
  set_initial_acceleration(const Case<dim>     &the_case,
                           Scene<dim>          &scene,
                           MaterialPoints<dim> &points);

  /**
   * The initial stress of a state at t = 0 whose points have got other masses
   * than those of the case, in balance with these: as the case finds its own,
   * by one gravity step.
   *
   * @throws NumericalFailure the gravity step does not converge
   */
  template <int dim>
  void
  renew_initial_stress(const Case<dim> &the_case, State<dim> &state);
} // namespace Waker

#endif
