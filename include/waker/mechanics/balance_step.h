// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_balance_step_h
#define waker_mechanics_balance_step_h

#include <waker/mechanics/stress_update.h>
#include <waker/nodes/fixities.h>
#include <waker/nodes/nodal_state.h>
#include <waker/nodes/resistance.h>

#include <functional>

namespace Waker
{
  /// How a stress has been brought into balance with the laws of the soil.
  struct BalanceReport
  {
    bool         converged  = false;
    double       share      = 0.; // of what was out of balance, carried so far
    unsigned int steps      = 0;
    unsigned int iterations = 0;      // Newton's, of all attempts
    double       residual   = 0.;     // relative, of the last attempt
    double       yielding   = 0.;     // share of the volume that has yielded
    unsigned int strong_failures = 0; // see NewtonReport
  };

  /// Is told of each load step, converged or not.
  using BalanceWatcher = std::function<void(const BalanceReport &)>;

  /// The force that no stress carries and no fixity holds, over the loads there
  /// (-): 1 for a body without stress.
  /// @param nodes in: mass, external_force, internal_force
  template <int dim>
  double
  out_of_balance(const Fixities<dim> &fixities, const NodalState &nodes);

  /**
   * Brings the points' stress into balance with the external force, in equal
   * quasi-static load steps (make_quasi_static()) of what is out of balance,
   * with the laws as they are; a step that does not converge is halved. Small
   * strain, and the points stay in place. Only their stress changes: what a
   * step has done to strengths and plastic strains is taken back after it, for
   * the soil had more time to get there than any load step.
   *
   * @param nodes in: mass, external_force (weight and water), internal_force
   *        of the stress that is there
   * @param n_steps at least 1
   * @param full_node_mass, mapping, resistances as of gravity_step()
   * @param watcher may be empty
   */
  template <int dim>
  BalanceReport
  balance_step(const Materials         &materials,
               const Weights<dim>      &weights,
               const Fixities<dim>     &fixities,
               const double             full_node_mass,
               const unsigned int       n_steps,
               const MappingParameters &mapping,
               NodalState              &nodes,
               MaterialPoints<dim>     &points,
               const Resistances<dim>  &resistances = {},
               const BalanceWatcher    &watcher     = {});
} // namespace Waker

#endif
