// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_nodal_state_h
#define waker_nodes_nodal_state_h

#include <waker/grid/background_grid.h>
#include <waker/nodes/nodal_vector.h>

#include <vector>

namespace Waker
{
  /**
   * What the nodes hold during one step. A node is active if it has mass; all
   * entries of the others are zero.
   */
  struct NodalState
  {
    template <int dim>
    explicit NodalState(const BackgroundGrid<dim> &grid)
      : mass(grid.n_nodes())
      , velocity(grid.n_dofs())
      , acceleration(grid.n_dofs())
      , external_force(grid.n_dofs())
      , internal_force(grid.n_dofs())
      , increment(grid.n_dofs())
      , new_velocity(grid.n_dofs())
      , new_acceleration(grid.n_dofs())
    {}

    std::vector<double> mass;           // lumped, Mg; one per node
    NodalVector         velocity;       // at the start of the step, m/s
    NodalVector         acceleration;   // at the start of the step, m/s^2
    NodalVector         external_force; // weight and loads, kN: at the start
                                        // after look(), at the end while the
                                        // step is solved
    NodalVector start_force;            // the same at its start, kN; empty if
                                        // loads do not change in time
    NodalVector internal_force;         // at the end of the step, kN
    NodalVector increment;              // displacement of the step, m
    NodalVector new_velocity;           // at the end of the step, m/s
    NodalVector new_acceleration;       // at the end of the step, m/s^2
  };
} // namespace Waker

#endif
