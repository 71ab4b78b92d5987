// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/loads/wet_body.h>
#include <waker/surface/surface_finder.h>

namespace Waker
{
  WetBody::WetBody(const BackgroundGrid<3> &grid, const WaterSide side)
    : grid(&grid)
    , water_left(side == WaterSide::left)
    , load(grid)
  {
    Assert(side != WaterSide::none, ExcInternalError());
  }


  void
  WetBody::find(const SurfaceFinder<3> &surfaces, const double level)
  {
    find(surfaces.facets(), level);
  }


  void
  WetBody::find(const Facets<3> &surface, const double level)
  {
    finder.find(surface,
                water_left,
                level,
                grid->lower_corner()[1],
                grid->cell_size(),
                wetted);
  }


  void
  WetBody::add_nodal_forces(const Liquid              &liquid,
                            const std::vector<double> &node_mass,
                            const double               minimum_mass,
                            NodalVector               &force)
  {
    if (wetted.empty())
      return;
    load.clear();
    for (const Facet<3> &facet : wetted)
      load.add_pressure(facet, [&](const Point<3> &x) {
        return liquid.pressure(x[1]);
      });
    load.distribute(node_mass, minimum_mass, force);
  }


  WaterResultant
  WetBody::resultant(const Liquid &liquid) const
  {
    const SpatialResultant total = spatial_resultant(liquid);
    const double   length = grid->upper_corner()[2] - grid->lower_corner()[2];
    WaterResultant sum;
    sum.force[0] = total.force[0] / length;
    sum.force[1] = total.force[1] / length;
    sum.moment   = total.moment[2] / length;
    return sum;
  }


  SpatialResultant
  WetBody::spatial_resultant(const Liquid &liquid) const
  {
    SpatialResultant sum;
    for (const Facet<3> &facet : wetted)
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
} // namespace Waker
