// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mapping_transfer_h
#define waker_mapping_transfer_h

#include <waker/mapping/weights.h>
#include <waker/nodes/nodal_state.h>
#include <waker/particles/material_points.h>

namespace Waker
{
  /**
   * Particles to nodes: lumped mass, velocity and acceleration (eqs. 2.31,
   * 2.32 of Remmerswaal 2023).
   *
   */
  template <int dim>
  void
  to_nodes(const MaterialPoints<dim> &points,
           const Weights<dim>        &weights,
           NodalState                &nodes);

  /// The weight of the points on the nodes, gravity along -y (eq. 2.27):
  /// external_force = m_i g.
  template <int dim>
  void
  set_gravity(const double gravity, NodalState &nodes);

  /// What moving the points back has told.
  struct TransferReport
  {
    double squared_displacement = 0.; // sum m |du|^2, Mg m^2
    double mass                 = 0.; // sum m, Mg
    double largest_displacement = 0.; // of a point in the step, m
    double kinetic_before       = 0.; // kinetic energy of the points, kJ
    double kinetic_after        = 0.;
  };

  /**
   * Nodes to particles after a Newmark step: positions, accelerations and
   * velocities (eqs. 2.38-2.40): v_p += (a_p + N a) dt / 2, a_p = N a.
   */
  template <int dim>
  TransferReport
  to_particles(const NodalState    &nodes,
               const Weights<dim>  &weights,
               const double         dt,
               MaterialPoints<dim> &points);
} // namespace Waker

#endif
