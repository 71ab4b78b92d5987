// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/loads/water_load.h>

namespace Waker
{
  template <int dim>
  WaterLoad<dim>::WaterLoad(const BackgroundGrid<dim> &grid,
                            const WaterParameters     &parameters,
                            const SurfaceParameters   &surface)
    : n_nodes(grid.n_nodes())
    , minimum_support(parameters.minimum_support)
    , level_in_time(parameters)
    , liquid{parameters.unit_weight, parameters.level}
    , wet(make_wet_surface(grid, parameters.side, surface))
  {}


  template <int dim>
  void
  WaterLoad<dim>::find(const SurfaceFinder<dim> &surfaces, const double t)
  {
    liquid.level = level_in_time.at(t);
    if (wet)
      wet->find(surfaces, liquid.level);
  }


  template <int dim>
  void
  WaterLoad<dim>::add_nodal_forces(const std::vector<double> &node_mass,
                                   const double               full_node_mass,
                                   NodalVector               &force)
  {
    AssertDimension(node_mass.size(), n_nodes);
    AssertDimension(force.locally_owned_size(), dim * n_nodes);
    if (wet)
      wet->add_nodal_forces(liquid,
                            node_mass,
                            minimum_support * full_node_mass,
                            force);
  }


  template <int dim>
  WaterResultant
  WaterLoad<dim>::resultant() const
  {
    return wet ? wet->resultant(liquid) : WaterResultant();
  }


  template <int dim>
  Facets<dim>
  WaterLoad<dim>::wetted() const
  {
    return wet ? wet->facets() : Facets<dim>();
  }


  template class WaterLoad<2>;
  template class WaterLoad<3>;
} // namespace Waker
