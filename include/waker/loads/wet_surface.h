// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_wet_surface_h
#define waker_loads_wet_surface_h

#include <waker/grid/background_grid.h>
#include <waker/loads/liquid.h>
#include <waker/loads/parameters.h>
#include <waker/nodes/nodal_vector.h>
#include <waker/surface/parameters.h>
#include <waker/surface/shape/facet.h>

#include <memory>
#include <optional>
#include <vector>

namespace Waker
{
  /// What the water does to the body, for checks and output. Per m of length
  /// along z, also in 3D.
  struct WaterResultant
  {
    Tensor<1, 2> force;       // kN/m
    double       moment = 0.; // kNm/m, about the origin, anticlockwise
  };

  /// Where water gets over a body in space.
  struct Spill
  {
    double height; // m, of the highest place on the lowest way
    double z;      // m, of that place
  };

  template <int dim>
  class SurfaceFinder;

  /**
   * What water wets of a body, and what its pressure does there. Where the
   * surface is that of a section, one walks up its chain (WetSection); in space
   * one floods (WetBody).
   */
  template <int dim>
  class WetSurface
  {
  public:
    virtual ~WetSurface() = default;

    /// Find it anew.
    /// @param level of the water (m)
    virtual void
    find(const SurfaceFinder<dim> &surfaces, const double level) = 0;

    /**
     * Add the nodal forces of the liquid's pressure to `force` (kN), integrated
     * exactly, with linear functions also under GIMP (FacetLoad, eq. 3.4 of
     * Remmerswaal 2023). Of a node that carries no load the share goes to nodes
     * nearby that do, with the same resultant and moment.
     *
     * @param node_mass of each node (Mg)
     * @param minimum_mass of a node inside the body that carries load (Mg)
     */
    virtual void
    add_nodal_forces(const Liquid              &liquid,
                     const std::vector<double> &node_mass,
                     const double               minimum_mass,
                     NodalVector               &force) = 0;

    /// Exact resultant of the liquid's pressure.
    virtual WaterResultant
    resultant(const Liquid &liquid) const = 0;

    virtual bool
    is_empty() const = 0;

    /// Does the water reach the toe on the other side, and where does it get
    /// over? Nothing is known of that by default.
    virtual std::optional<Spill>
    spill() const
    {
      return {};
    }

    /// For output.
    virtual Facets<dim>
    facets() const = 0;
  };

  /// The one that fits the surface.
  template <int dim>
  std::unique_ptr<WetSurface<dim>>
  make_wet_surface(const BackgroundGrid<dim> &grid,
                   const WaterSide            side,
                   const SurfaceParameters   &surface);
} // namespace Waker

#endif
