// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_gravity_step_h
#define waker_mechanics_gravity_step_h

#include <waker/mechanics/mixed_cells.h>
#include <waker/mechanics/stress_update.h>
#include <waker/nodes/fixities.h>
#include <waker/nodes/nodal_state.h>
#include <waker/nodes/resistance.h>

#include <vector>

namespace Waker
{
  struct GravityReport
  {
    bool                converged = false;
    std::vector<double> residuals; // relative, before and after each iteration
    MixedCells          mixed_cells;
    // See NewtonReport.
    unsigned int linear_iterations = 0, strong_iterations = 0,
                 strong_failures = 0;
  };

  /**
   * The in-situ stress: a quasi-static step (make_quasi_static()) of an elastic
   * body with the points fixed in place (section 5.3 of Remmerswaal 2023). Sets
   * the points' stress; nothing moves.
   *
   * The tangent of the internal force has no stiffness for some motions of
   * nodes that only one support domain touches: a millionth of its diagonal (a
   * ten-millionth in space) is added, and the residual iterated away
   * (LinearMethod::elastic). Cells with points of two stiffnesses get one of
   * their own: see mixed_cells.h.
   *
   * @param nodes in: mass, external_force (weight and water, or a share of
   *        them)
   * @param full_node_mass see NewtonSolver: the norm of the residual is its
   * @param tolerance of the relative residual
   * @param mapping the strain, small here, and its volumetric part
   * @param resistances beside soil and penalty supports: walls off the grid
   */
  template <int dim>
  GravityReport
  gravity_step(const Materials         &materials,
               const Weights<dim>      &weights,
               const Fixities<dim>     &fixities,
               const double             full_node_mass,
               const double             tolerance,
               const MappingParameters &mapping,
               NodalState              &nodes,
               MaterialPoints<dim>     &points,
               const Resistances<dim>  &resistances = {});
} // namespace Waker

#endif
