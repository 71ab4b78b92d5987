// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/host.h>
#include <waker/case/initial_stress.h>
#include <waker/case/scene.h>
#include <waker/mapping/stencil.h>
#include <waker/mechanics/deformation.h>
#include <waker/mechanics/energy.h>
#include <waker/mechanics/time_scheme.h>

#include <algorithm>
#include <sstream>

namespace Waker
{
  template <int dim>
  GravityReport
  set_initial_stress(const Case<dim>     &the_case,
                     Scene<dim>          &scene,
                     MaterialPoints<dim> &points)
  {
    GravityReport report;
    if (the_case.parameters.gravity.initial_stress)
      {
        const NodalVector full = scene.nodes.external_force;
        scene.nodes.external_force *= the_case.parameters.gravity.initial_share;
        report = gravity_step(the_case.materials,
                              scene.weights,
                              the_case.fixities,
                              the_case.full_node_mass,
                              the_case.parameters.gravity.tolerance,
                              the_case.parameters.mapping,
                              scene.nodes,
                              points,
                              scene.resistances());
        if (!report.converged)
          {
            std::ostringstream message;
            message << "the gravity step stops at a residual of "
                    << (report.residuals.empty() ? 0. : report.residuals.back())
                    << ", above Gravity/Tolerance "
                    << the_case.parameters.gravity.tolerance
                    << ": is the body held, and no Poisson's ratio above 0.49?";
            throw NumericalFailure(message.str());
          }
        scene.nodes.external_force = full; // the rest acts from now on
        give_back_memory();                // what the solver took
      }
    else
      scene.set_internal_force(points);

    // Newmark starts from the acceleration that fits the forces at t = 0.
    const double ramp =
      residual_ramp(0., the_case.parameters.time.ramp_duration);
    const Stencil<dim> stencil(the_case.grid);
    NodalVector       &a = scene.nodes.acceleration;
    a                    = scene.nodes.external_force;
    a -= scene.nodes.internal_force;
    for (unsigned int dof = 0; dof < the_case.grid.n_dofs(); ++dof)
      {
        const double mass = scene.nodes.mass[dof / dim];
        a.begin()[dof] *=
          (mass > 0. && !the_case.fixities.removed()[dof]) ? ramp / mass : 0.;
      }
    for (std::size_t q = 0; q < points.n_points(); ++q)
      points.acceleration[q] = stencil.value(scene.weights[q], a.begin());
    return report;
  }


  template <int dim>
  void
  renew_initial_stress(const Case<dim> &the_case, State<dim> &state)
  {
    MaterialPoints<dim> &points = state.points;
    std::fill(points.stress.begin(),
              points.stress.end(),
              SymmetricTensor<2, 3>());
    prepare_domains(the_case.parameters.mapping.domains, points);
    Scene<dim> scene(the_case);
    scene.set(points);
    scene.walls.reinit(scene.nodes.mass, 0., state.wall_tractions);
    set_initial_stress(the_case, scene, points);
    state.energy.elastic_start = elastic_energy(points, the_case.materials);
    state.energy.elastic       = state.energy.elastic_start;
  }


  template GravityReport
  set_initial_stress(const Case<2> &, Scene<2> &, MaterialPoints<2> &);
  template GravityReport
  set_initial_stress(const Case<3> &, Scene<3> &, MaterialPoints<3> &);
  template void
  renew_initial_stress(const Case<2> &, State<2> &);
  template void
  renew_initial_stress(const Case<3> &, State<3> &);
} // namespace Waker
