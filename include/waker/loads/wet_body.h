// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_wet_body_h
#define waker_loads_wet_body_h

#include <waker/loads/facet_load.h>
#include <waker/loads/wet_surface.h>
#include <waker/loads/wetted_facets.h>

namespace Waker
{
  /// In space.
  struct SpatialResultant
  {
    Tensor<1, 3> force;  // kN
    Tensor<1, 3> moment; // kNm, about the origin
  };

  /// The wet part of a body's surface in space (WettedFacets).
  class WetBody : public WetSurface<3>
  {
  public:
    /// @param side not none
    WetBody(const BackgroundGrid<3> &grid, const WaterSide side);

    void
    find(const SurfaceFinder<3> &surfaces, const double level) override;

    /// On any closed surface.
    void
    find(const Facets<3> &surface, const double level);

    void
    add_nodal_forces(const Liquid              &liquid,
                     const std::vector<double> &node_mass,
                     const double               minimum_mass,
                     NodalVector               &force) override;

    /// Force and moment about the z axis, by the length of the grid's box.
    WaterResultant
    resultant(const Liquid &liquid) const override;

    SpatialResultant
    spatial_resultant(const Liquid &liquid) const;

    bool
    is_empty() const override
    {
      return wetted.empty();
    }

    std::optional<Spill>
    spill() const override
    {
      return finder.spill();
    }

    Facets<3>
    facets() const override
    {
      return wetted;
    }

  private:
    const BackgroundGrid<3> *grid;
    bool                     water_left;
    Facets<3>                wetted;
    WettedFacets             finder;
    FacetLoad<3>             load;
  };
} // namespace Waker

#endif
