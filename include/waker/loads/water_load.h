// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_water_load_h
#define waker_loads_water_load_h

#include <waker/base/time_function.h>
#include <waker/grid/background_grid.h>
#include <waker/loads/facet_load.h>
#include <waker/loads/liquid.h>
#include <waker/loads/parameters.h>
#include <waker/loads/wetted_surface.h>
#include <waker/nodes/nodal_vector.h>
#include <waker/surface/shape/surface.h>

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

  /// The same in space.
  struct SpatialResultant
  {
    Tensor<1, 3> force;  // kN
    Tensor<1, 3> moment; // kNm, about the origin
  };

  template <int dim>
  class SurfaceFinder;

  /**
   * The water beside the dyke: its level in time, its pressure, where it acts,
   * and what it does.
   *
   * Hydrostatic pressure on the outer slope: from the outer toe of the largest
   * body along its surface up to where it first reaches the water level
   * (find_wetted_segments(), in 3D WettedFacets).
   *
   * The pressure is integrated exactly, with linear functions also under GIMP
   * (FacetLoad, eq. 3.4 of Remmerswaal 2023). The share of a node with less
   * mass than `minimum_support` goes to supported nodes nearby, with weights
   * that reproduce linear functions: resultant and moment are kept.
   *
   * In 3D the surface is that of the body itself (find_wetted_facets()), or
   * that of the x-y plane, if the body is prismatic (find_wetted_segments()):
   * then the load of the plane is integrated with the linear functions along z
   * over the extent of the grid's box, and support is judged in each plane of
   * nodes.
   */
  template <int dim>
  class WaterLoad
  {
  public:
    WaterLoad(const BackgroundGrid<dim> &grid,
              const WaterParameters     &parameters);

    /// Level at time t (s), in m.
    double
    level(const double t) const
    {
      return parameters.level + rise.value(t) + added_rise;
    }

    /// What a load programme adds to the level from now on (m).
    void
    set_added_rise(const double height)
    {
      added_rise = height;
    }

    /// Does the level depend on the time?
    bool
    moves() const
    {
      return parameters.stands() && rise.moves();
    }

    /// The last time at which the load changes (s): see LastChange.
    double
    last_change() const;

    /// Does the load change between two times?
    bool
    varies(const double from, const double to) const;

    /// From now on the water stands as at time t (s).
    void
    set_time(const double t)
    {
      set_level(level(t));
    }

    /// From now on the water stands at this level (m).
    void
    set_level(const double level)
    {
      liquid.level = level;
    }

    /// The water as it stands.
    const Liquid &
    now() const
    {
      return liquid;
    }

    /// Find what is wet, on the surface that is found for it.
    void
    find(const SurfaceFinder<dim> &surfaces);

    /// The wetted part of the surface, from the toe up. Empty without water.
    void
    find_wetted_segments(const Surface &surface);

    /// 3D: the wetted part of the surface of the body itself.
    void
    find_wetted_facets(const Facets<dim> &surface);

    /// As found last; empty if it was facets that were found last.
    const std::vector<LoadedSegment> &
    wetted_segments() const
    {
      return wetted;
    }

    /// As found last; empty if it was segments.
    const Facets<dim> &
    wetted_facets() const
    {
      return facets;
    }

    /**
     * Add the nodal forces of what is wet to `force` (kN).
     *
     * @param node_mass mass of each node (Mg), n_nodes long
     * @param full_node_mass mass of a node inside the body (Mg)
     *
     * If no node has support, nothing is added.
     */
    void
    add_nodal_forces(const std::vector<double> &node_mass,
                     const double               full_node_mass,
                     NodalVector               &force);

    /// Exact resultant of the pressure on what is wet. Of facets: their force
    /// and their moment about the z axis, by the length of the grid's box.
    WaterResultant
    resultant() const;

    /// 3D: exact resultant of the pressure on the wetted facets.
    SpatialResultant
    spatial_resultant() const;

  private:
    const BackgroundGrid<dim> *grid;
    WaterParameters            parameters;
    TimeFunction               rise;
    double                     added_rise = 0.; // m
    Liquid                     liquid;
    std::vector<LoadedSegment> wetted;
    Facets<dim>                facets;

    // Work space; that of facets when they are first needed.
    FacetLoad<2>                  plane_load; // kN/m
    std::optional<FacetLoad<dim>> load;
    std::optional<WettedFacets>   finder;
  };
} // namespace Waker

#endif
