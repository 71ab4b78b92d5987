// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/mapping/stencil.h>
#include <waker/mapping/transfer.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/simulation/case.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Waker
{
  namespace
  {
    template <int dim>
    Point<dim>
    corner(const std::vector<double> &coordinates)
    {
      Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = coordinates[d];
      return x;
    }


    Materials
    make_materials(const Parameters &parameters)
    {
      Materials materials;
      for (const MaterialParameters &material : parameters.materials)
        materials.push_back(
          make_material(material, parameters.gravity.density_acceleration()));
      return materials;
    }


    double
    largest_density(const Materials &materials)
    {
      double largest = 0.;
      for (const auto &material : materials)
        largest = std::max(largest, material->density());
      return largest;
    }
  } // namespace


  template <int dim>
  Case<dim>::Case(const Parameters &p,
                  const MPI_Comm    communicator,
                  Materials         given_materials)
    : parameters(p)
    , grid(corner<dim>(p.grid.lower_corner),
           corner<dim>(p.grid.upper_corner),
           p.grid.cell_size,
           communicator)
    , materials(given_materials.empty() ? make_materials(p)
                                        : std::move(given_materials))
    , flow(grid, materials, p)
    , fixities(grid, flow.conditions())
    , full_node_mass(largest_density(materials) *
                     std::pow(p.grid.cell_size, dim))
  {
    std::vector<std::string> names;
    std::vector<double>      densities;
    for (unsigned int m = 0; m < materials.size(); ++m)
      {
        names.push_back(m < p.materials.size() ? p.materials[m].name : "");
        densities.push_back(materials[m]->density());
      }
    initial_points =
      make_material_points(grid, p.layers, p.points, names, densities);
    flow.fill(initial_points);
    declare_material_variables(materials, initial_points);
    set_initial_state();
  }


  template <int dim>
  void
  Case<dim>::set_initial_state()
  {
    MaterialPoints<dim> &points = initial_points;
    Scene<dim>           scene(*this);
    scene.set(points);
    if (parameters.gravity.initial_stress)
      {
        gravity_report = gravity_step(materials,
                                      scene.weights,
                                      fixities,
                                      full_node_mass,
                                      parameters.gravity.tolerance,
                                      scene.nodes,
                                      points);
        if (!gravity_report.converged)
          {
            std::ostringstream message;
            message << "the gravity step stops at a residual of "
                    << (gravity_report.residuals.empty()
                          ? 0.
                          : gravity_report.residuals.back())
                    << ", above Gravity/Tolerance "
                    << parameters.gravity.tolerance;
            throw NumericalFailure(message.str());
          }
      }

    // Newmark starts from the acceleration that fits the forces at t = 0.
    const double       ramp = residual_ramp(0., parameters.time.ramp_duration);
    const Stencil<dim> stencil(grid);
    NodalVector       &a = scene.nodes.acceleration;
    a                    = scene.nodes.external_force;
    if (parameters.gravity.initial_stress)
      a -= scene.nodes.internal_force;
    for (unsigned int dof = 0; dof < grid.n_dofs(); ++dof)
      {
        const double mass = scene.nodes.mass[dof / dim];
        a.begin()[dof] *=
          (mass > 0. && !fixities.removed()[dof]) ? ramp / mass : 0.;
      }
    for (std::size_t q = 0; q < points.n_points(); ++q)
      points.acceleration[q] = stencil.value(scene.weights[q], a.begin());
  }


  template <int dim>
  Scene<dim>::Scene(const Case<dim> &the_case)
    : weights(the_case.grid,
              the_case.parameters.mapping.functions == "GIMP"
                ? ShapeFunctions::gimp
                : ShapeFunctions::linear)
    , nodes(the_case.grid)
    , proximity(the_case.grid,
                the_case.parameters.surface,
                the_case.fixities.closed_faces())
    , water(the_case.grid, the_case.parameters.water)
    , the_case(&the_case)
  {}


  template <int dim>
  void
  Scene<dim>::set(const MaterialPoints<dim> &points)
  {
    weights.reinit(points);
    to_nodes(points, weights, nodes);
    proximity.detect(points, surface);
    set_gravity<dim>(the_case->parameters.gravity.acceleration, nodes);
    water.find_wetted_segments(surface);
    water.add_nodal_forces(nodes.mass,
                           the_case->full_node_mass,
                           nodes.external_force);
    water_resultant = water.resultant();
  }


  template struct Case<2>;
  template struct Case<3>;
  template class Scene<2>;
  template class Scene<3>;
} // namespace Waker
