// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_wet_section_h
#define waker_loads_wet_section_h

#include <waker/loads/facet_load.h>
#include <waker/loads/wet_surface.h>
#include <waker/loads/wetted_segments.h>

namespace Waker
{
  /**
   * The wet part of a section (find_wetted_segments()): in 2D of the body, in
   * 3D of one that is prismatic. There the load of the plane is integrated with
   * the linear functions along z over the extent of the grid's box, and support
   * is judged in each plane of nodes: so a slice gets what the plane gets.
   */
  template <int dim>
  class WetSection : public WetSurface<dim>
  {
  public:
    /// @param side not none
    WetSection(const BackgroundGrid<dim> &grid, const WaterSide side);

    void
    find(const SurfaceFinder<dim> &surfaces, const double level) override;

    /// On any section.
    void
    find(const Facets<2> &section, const double level);

    void
    add_nodal_forces(const Liquid              &liquid,
                     const std::vector<double> &node_mass,
                     const double               minimum_mass,
                     NodalVector               &force) override;

    WaterResultant
    resultant(const Liquid &liquid) const override;

    bool
    is_empty() const override
    {
      return wetted.empty();
    }

    Facets<dim>
    facets() const override;

    /// From the toe up.
    const Facets<2> &
    segments() const
    {
      return wetted;
    }

  private:
    const BackgroundGrid<dim>       *grid;
    bool                             water_left;
    Facets<2>                        wetted;
    FacetLoad<2>                     load; // kN/m
    std::vector<FacetLoad<2>::Plane> planes;
  };
} // namespace Waker

#endif
