// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_water_load_h
#define waker_loads_water_load_h

#include <waker/loads/water_level.h>
#include <waker/loads/wet_surface.h>

#include <memory>
#include <vector>

namespace Waker
{
  /**
   * The water beside the dyke: its level in time, its pressure, where it acts,
   * and what it does.
   *
   * Hydrostatic pressure on the outer slope: from the outer toe of the largest
   * body, in the plane along its surface up to where it first reaches the water
   * level (WetSection), in space over all that the water reaches (WetBody). The
   * share of a node with less mass than `minimum_support` goes to supported
   * nodes nearby, with weights that reproduce linear functions: resultant and
   * moment are kept.
   */
  template <int dim>
  class WaterLoad
  {
  public:
    WaterLoad(const BackgroundGrid<dim> &grid,
              const WaterParameters     &parameters,
              const SurfaceParameters   &surface);

    /// Of the water in time.
    const WaterLevel &
    level() const
    {
      return level_in_time;
    }

    /// What a load programme adds to the level from now on (m).
    void
    set_added_rise(const double height)
    {
      level_in_time.set_added_rise(height);
    }

    /// From now on the water stands as at time t (s), and wets what it reaches
    /// of these surfaces.
    void
    find(const SurfaceFinder<dim> &surfaces, const double t);

    /// The water as it stands.
    const Liquid &
    now() const
    {
      return liquid;
    }

    /// Does it reach the body?
    bool
    touches() const
    {
      return wet && !wet->is_empty();
    }

    /// See WetSurface.
    std::optional<Spill>
    spill() const
    {
      return wet ? wet->spill() : std::optional<Spill>();
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

    /// Exact resultant of the pressure on what is wet.
    WaterResultant
    resultant() const;

    /// What is wet, for output.
    Facets<dim>
    wetted() const;

  private:
    std::size_t                      n_nodes;
    double                           minimum_support;
    WaterLevel                       level_in_time;
    Liquid                           liquid;
    std::unique_ptr<WetSurface<dim>> wet; // null: no water stands
  };
} // namespace Waker

#endif
