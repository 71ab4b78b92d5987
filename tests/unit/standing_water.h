// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_standing_water_h
#define waker_tests_standing_water_h

#include <waker/loads/wet_body.h>
#include <waker/loads/wet_section.h>
#include <waker/surface/shape/surface.h>

namespace Waker
{
  /// Water that stands against a surface of the test's own: chains of a section
  /// in 2D and 3D, or facets in 3D.
  template <int dim>
  class StandingWater
  {
  public:
    StandingWater(const BackgroundGrid<dim> &grid,
                  const WaterParameters     &parameters)
      : full_share(parameters.minimum_support)
      , liquid{parameters.unit_weight, parameters.level}
      , section(grid, parameters.side)
      , body(grid, parameters.side)
    {}

    void
    set_level(const double level)
    {
      liquid.level = level;
    }

    void
    find(const Surface &chains)
    {
      section.find(to_facets(chains), liquid.level);
      wet = &section;
    }

    void
    find(const Facets<3> &surface)
    {
      body.find(surface, liquid.level);
      wet = &body;
    }

    /// From the toe up; of a section.
    const Facets<2> &
    segments() const
    {
      return section.segments();
    }

    Facets<dim>
    facets() const
    {
      return wet->facets();
    }

    void
    add_nodal_forces(const std::vector<double> &node_mass,
                     const double               full_node_mass,
                     NodalVector               &force)
    {
      wet->add_nodal_forces(liquid,
                            node_mass,
                            full_share * full_node_mass,
                            force);
    }

    std::optional<Spill>
    spill() const
    {
      return wet->spill();
    }

    WaterResultant
    resultant() const
    {
      return wet->resultant(liquid);
    }

    SpatialResultant
    spatial_resultant() const
    {
      return body.spatial_resultant(liquid);
    }

  private:
    // There is no body in space in the plane.
    struct NoBody
    {
      NoBody(const BackgroundGrid<2> &, const WaterSide)
      {}
    };

    double                                        full_share;
    Liquid                                        liquid;
    WetSection<dim>                               section;
    std::conditional_t<dim == 3, WetBody, NoBody> body;
    WetSurface<dim>                              *wet = nullptr;
  };
} // namespace Waker

#endif
