// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_initial_stress_h
#define waker_case_initial_stress_h

#include <waker/case/case.h>
#include <waker/case/state.h>

namespace Waker
{
  /**
   * Stress in situ of points in a scene of theirs (gravity step), or none, and
   * the acceleration that fits the forces at t = 0.
   *
   * @throws NumericalFailure the gravity step does not converge
   */
  template <int dim>
  GravityReport
  set_initial_stress(const Case<dim>     &the_case,
                     Scene<dim>          &scene,
                     MaterialPoints<dim> &points);

  /**
   * The initial stress of a state at t = 0 whose points have got other masses
   * than those of the case, in balance with these: as the case finds its own.
   *
   * @throws NumericalFailure the gravity step does not converge
   */
  template <int dim>
  void
  renew_initial_stress(const Case<dim> &the_case, State<dim> &state);
} // namespace Waker

#endif
