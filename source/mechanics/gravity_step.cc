// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/gravity_step.h>
#include <waker/mechanics/time_scheme.h>

#include <utility>

namespace Waker
{
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
               const Resistances<dim>  &resistances)
  {
    const BackgroundGrid<dim> &grid = weights.background_grid();
    const ElasticMixture       elastic =
      elastic_mixture(materials, grid, weights.functions(), points);
    TimeParameters time;
    time.move_points     = false;
    time.ghost_stiffness = 0.;
    NewtonParameters newton;
    newton.tolerance                 = tolerance;
    newton.linear_tolerance          = 1e-6; // in 3D
    newton.maximum_linear_iterations = 5000;
    // An elastic body on a wall that only pushes is no linear one.
    const bool is_linear = !have_corners(resistances);
    // Its solver lets nodes that soil hardly touches move far: their rotation
    // is none of the body.
    MappingParameters kinematics = mapping;
    if (!is_linear)
      kinematics.objective_rate = false;
    const std::unique_ptr<TimeScheme<dim>> scheme =
      make_quasi_static(SchemeInput<dim>{grid,
                                         weights,
                                         elastic.materials,
                                         fixities,
                                         time,
                                         newton,
                                         kinematics,
                                         /*gravity=*/0., // of works only
                                         full_node_mass,
                                         resistances,
                                         is_linear});

    // For this step, which takes no time, the points are of these materials.
    const std::vector<std::uint32_t> own_materials =
      std::exchange(points.material, elastic.of_point);
    StepReport<dim> step = scheme->solve(points, 0., 0., nodes);
    scheme->to_points(0., 0., nodes, points, step);
    points.material = own_materials;
    return {step.converged,
            step.residuals,
            elastic.cells,
            step.linear_iterations,
            step.strong_iterations,
            step.strong_failures};
  }


  template GravityReport
  gravity_step(const Materials &,
               const Weights<2> &,
               const Fixities<2> &,
               const double,
               const double,
               const MappingParameters &,
               NodalState &,
               MaterialPoints<2> &,
               const Resistances<2> &);
  template GravityReport
  gravity_step(const Materials &,
               const Weights<3> &,
               const Fixities<3> &,
               const double,
               const double,
               const MappingParameters &,
               NodalState &,
               MaterialPoints<3> &,
               const Resistances<3> &);
} // namespace Waker
