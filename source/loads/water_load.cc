// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/loads/water_load.h>
#include <waker/surface/surface_finder.h>

#include <algorithm>

namespace Waker
{
  template <int dim>
  WaterLoad<dim>::WaterLoad(const BackgroundGrid<dim> &grid,
                            const WaterParameters     &parameters)
    : grid(&grid)
    , parameters(parameters)
    , level_in_time(parameters)
    , liquid{parameters.unit_weight, parameters.level}
    , plane_load(Point<2>(grid.origin()[0], grid.origin()[1]),
                 grid.cell_size(),
                 {{grid.n_nodes_per_direction()[0],
                   grid.n_nodes_per_direction()[1]}})
  {}



  template <int dim>
  void
  WaterLoad<dim>::find(const SurfaceFinder<dim> &surfaces)
  {
    if (!surfaces.is_spatial())
      find_wetted_segments(surfaces.chains());
    else if (parameters.stands())
      find_wetted_facets(surfaces.facets());
  }



  template <int dim>
  void
  WaterLoad<dim>::find_wetted_segments(const Surface &surface)
  {
    wetted.clear();
    facets.clear();
    if (parameters.stands())
      Waker::find_wetted_segments(surface,
                                  parameters.side == WaterSide::left,
                                  liquid.level,
                                  grid->lower_corner()[1],
                                  grid->cell_size(),
                                  wetted);
  }



  template <int dim>
  void
  WaterLoad<dim>::find_wetted_facets(const Facets<dim> &surface)
  {
    wetted.clear();
    facets.clear();
    if (!parameters.stands())
      return;
    if constexpr (dim == 3)
      {
        if (!finder)
          finder.emplace();
        finder->find(surface,
                     parameters.side == WaterSide::left,
                     liquid.level,
                     grid->lower_corner()[1],
                     grid->cell_size(),
                     facets);
      }
    else
      {
        (void)surface;
        Assert(false, ExcMessage("In 2D a chain tells what comes next."));
      }
  }



  template <int dim>
  void
  WaterLoad<dim>::add_nodal_forces(const std::vector<double> &node_mass,
                                   const double               full_node_mass,
                                   NodalVector               &force)
  {
    Assert(node_mass.size() == grid->n_nodes(),
           ExcDimensionMismatch(node_mass.size(), grid->n_nodes()));
    Assert(force.locally_owned_size() == grid->n_dofs(),
           ExcDimensionMismatch(force.locally_owned_size(), grid->n_dofs()));

    if (!facets.empty())
      {
        if (!load)
          load.emplace(*grid);
        load->clear();
        for (const Facet<dim> &facet : facets)
          load->add_pressure(facet, [this](const Point<dim> &x) {
            return liquid.pressure(x[1]);
          });
        load->distribute(node_mass,
                         parameters.minimum_support * full_node_mass,
                         force);
      }
    if (wetted.empty())
      return;

    plane_load.clear();
    for (const LoadedSegment &segment : wetted)
      plane_load.add_pressure(
        {{{segment.from, segment.to}}, segment.normal, -1},
        [this](const Point<2> &x) { return liquid.pressure(x[1]); });

    // Planes of nodes along z that hold a part of the box, and the integral of
    // their linear function over it.
    constexpr unsigned int z           = dim - 1;
    const unsigned int     first_plane = dim == 3 ? grid->margin : 0;
    const unsigned int     last_plane =
      dim == 3 ? grid->n_nodes_per_direction()[z] - 1 - grid->margin : 0;
    const unsigned int plane_size =
      grid->n_nodes_per_direction()[0] * grid->n_nodes_per_direction()[1];
    for (unsigned int plane = first_plane; plane <= last_plane; ++plane)
      {
        // At its ends a body reaches half as far along z as inside, and so does
        // the full mass of a node.
        const double share =
          (dim == 3 && (plane == first_plane || plane == last_plane)) ? 0.5
                                                                      : 1.;
        plane_load.distribute(node_mass.data() + plane * plane_size,
                              parameters.minimum_support * share *
                                full_node_mass,
                              dim == 3 ? share * grid->cell_size() : 1.,
                              dim,
                              force.begin() + dim * plane * plane_size);
      }
  }



  template <int dim>
  WaterResultant
  WaterLoad<dim>::resultant() const
  {
    WaterResultant sum;
    if (!facets.empty())
      {
        const SpatialResultant total = spatial_resultant();
        const double           length =
          grid->upper_corner()[dim - 1] - grid->lower_corner()[dim - 1];
        sum.force[0] = total.force[0] / length;
        sum.force[1] = total.force[1] / length;
        sum.moment   = total.moment[2] / length;
        return sum;
      }

    for (const LoadedSegment &segment : wetted)
      {
        // The pressure is linear from p0 to p1.
        const Tensor<1, 2> along  = segment.to - segment.from;
        const double       length = along.norm();
        const double       p0     = liquid.pressure(segment.from[1]);
        const double       p1     = liquid.pressure(segment.to[1]);
        const double       total  = 0.5 * length * (p0 + p1);
        sum.force -= total * segment.normal;

        // Integral of x p over the segment.
        Tensor<1, 2> first = total * segment.from;
        first += length * (p0 / 6. + p1 / 3.) * along;
        sum.moment -=
          first[0] * segment.normal[1] - first[1] * segment.normal[0];
      }
    return sum;
  }



  template <int dim>
  SpatialResultant
  WaterLoad<dim>::spatial_resultant() const
  {
    SpatialResultant sum;
    if constexpr (dim == 3)
      for (const Facet<3> &facet : facets)
        for (unsigned int k = 0; k < 3; ++k)
          {
            // The mid-points of the sides are exact for x p, a quadratic.
            const Point<3>    &a = facet.vertices[k];
            const Point<3>     x = a + 0.5 * (facet.vertices[(k + 1) % 3] - a);
            const Tensor<1, 3> f =
              -facet.measure() / 3. * liquid.pressure(x[1]) * facet.normal;
            sum.force += f;
            sum.moment += cross_product_3d(Tensor<1, 3>(x), f);
          }
    return sum;
  }



  template class WaterLoad<2>;
  template class WaterLoad<3>;
} // namespace Waker
