// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/loads/wet_section.h>
#include <waker/surface/surface_finder.h>

#include <utility>

namespace Waker
{
  template <int dim>
  WetSection<dim>::WetSection(const BackgroundGrid<dim> &grid,
                              const WaterSide            side)
    : grid(&grid)
    , water_left(side == WaterSide::left)
    , load(grid)
  {
    Assert(side != WaterSide::none, ExcInternalError());
    if constexpr (dim == 2)
      planes = {{}};
    else
      {
        // Those that hold a part of the box, with the integral of their linear
        // function over it. At its ends a body reaches half as far along z as
        // inside, and so does the full mass of a node.
        const int first = grid.margin;
        const int last =
          grid.lattice_nodes_per_direction()[2] - 1 - grid.margin;
        for (unsigned int k = 0; k < grid.n_nodes_per_direction()[2]; ++k)
          {
            const int    z     = grid.offset()[2] + static_cast<int>(k);
            const double share = z == first || z == last ? 0.5 : 1.;
            if (z >= first && z <= last)
              planes.push_back({k, share, share * grid.cell_size()});
          }
      }
  }


  template <int dim>
  void
  WetSection<dim>::find(const SurfaceFinder<dim> &surfaces, const double level)
  {
    find(surfaces.section(), level);
  }


  template <int dim>
  void
  WetSection<dim>::find(const Facets<2> &section, const double level)
  {
    find_wetted_segments(section,
                         water_left,
                         level,
                         grid->lower_corner()[1],
                         grid->cell_size(),
                         wetted);
  }


  template <int dim>
  void
  WetSection<dim>::add_nodal_forces(const Liquid              &liquid,
                                    const std::vector<double> &node_mass,
                                    const double               minimum_mass,
                                    NodalVector               &force)
  {
    if (wetted.empty())
      return;
    load.clear();
    for (const Facet<2> &segment : wetted)
      load.add_pressure(segment, [&](const Point<2> &x) {
        return liquid.pressure(x[1]);
      });
    load.distribute(node_mass, minimum_mass, force, planes);
  }


  template <int dim>
  WaterResultant
  WetSection<dim>::resultant(const Liquid &liquid) const
  {
    WaterResultant sum;
    for (const Facet<2> &segment : wetted)
      {
        // The pressure is linear from p0 to p1.
        const Point<2>     from   = segment.vertices[0];
        const Point<2>     to     = segment.vertices[1];
        const Tensor<1, 2> along  = to - from;
        const double       length = along.norm();
        const double       p0     = liquid.pressure(from[1]);
        const double       p1     = liquid.pressure(to[1]);
        const double       total  = 0.5 * length * (p0 + p1);
        sum.force -= total * segment.normal;

        // Integral of x p over the segment.
        Tensor<1, 2> first = total * from;
        first += length * (p0 / 6. + p1 / 3.) * along;
        sum.moment -=
          first[0] * segment.normal[1] - first[1] * segment.normal[0];
      }
    return sum;
  }


  template <int dim>
  Facets<dim>
  WetSection<dim>::facets() const
  {
    if constexpr (dim == 2)
      return wetted;
    else
      {
        Facets<2> with_body_on_left = wetted;
        for (Facet<2> &segment : with_body_on_left)
          if (make_facet<2>(segment.vertices).normal * segment.normal < 0.)
            std::swap(segment.vertices[0], segment.vertices[1]);
        return extrude(with_body_on_left,
                       grid->lower_corner()[2],
                       grid->upper_corner()[2]);
      }
  }


  template class WetSection<2>;
  template class WetSection<3>;
} // namespace Waker
