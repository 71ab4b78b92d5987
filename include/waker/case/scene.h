// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_scene_h
#define waker_case_scene_h

#include <waker/base/last_change.h>
#include <waker/case/case.h>
#include <waker/case/driven_loads.h>
#include <waker/case/state.h>
#include <waker/loads/tractions.h>
#include <waker/loads/water_load.h>
#include <waker/mapping/weights.h>
#include <waker/nodes/nodal_state.h>
#include <waker/nodes/resistance.h>
#include <waker/nodes/wall.h>
#include <waker/surface/surface_finder.h>

#include <string>

namespace Waker
{
  template <int dim>
  class RankPart;


  /**
   * The nodes' side of a moment: weights, nodal state, surfaces and loads of
   * the points as they lie. Work space, made once and used in every step.
   */
  template <int dim>
  class Scene
  {
  public:
    /// @param part on several ranks that of this one, in which nodes, weights
    ///        and loads are: complete() makes the scene's own ones known
    explicit Scene(const Case<dim> &the_case, RankPart<dim> *part = nullptr);

    /// The part has got new windows: loads act on those.
    void
    follow_part();

    // The moment of a state, in this order.

    /// Mass, velocity and acceleration of the nodes (eqs. 2.31, 2.32).
    void
    map(const MaterialPoints<dim> &points);

    /// From now on the surfaces are those of these points; each is found when
    /// it is asked for (SurfaceFinder), by the tractions now, by the water when
    /// its level is known. And those that the material carries.
    /// @throws NumericalFailure if what the input allowed at the start is lost
    void
    find_surfaces(const State<dim> &state);

    /// Weight, water and tractions: the nodes' external force. What befalls a
    /// traction for the first time is written into the state.
    /// @throws NumericalFailure as above
    void
    set_loads(State<dim> &state);

    /// What touches the walls.
    void
    meet_walls(State<dim> &state);

    /// At the start the internal force of the stress that is there; later it is
    /// that of the step that has ended.
    void
    set_first_force(const State<dim> &state);

    /**
     * Map the points, find the surfaces, load them.
     * @param time of the loads (s)
     * @param vertices that the material carries
     */
    void
    set(const MaterialPoints<dim>  &points,
        const double                time,
        const SurfaceVertices<dim> &vertices);

    /// The same at t = 0.
    void
    set(const MaterialPoints<dim> &points);

    /// Height and width of the dyke on the surfaces found last: of their
    /// outline in the plane, in space of the case's sections.
    /// @param level at which W is measured (m), or NaN
    DykeGeometry
    measure_dyke(const double level);

    /// Do loads change in time even if the points do not move?
    bool
    loads_move() const;

    /// A step begins: the loads are those at its start.
    void
    begin_step();

    /// The loads at the time (s) of its end, on the surfaces at its start; they
    /// stay as they are if none of them changes in time.
    void
    set_end_loads(const State<dim> &state, const double time);

    /// The last time at which one of water, tractions, walls and boundary
    /// conditions changes, or the share of them that acts (s). Those of which
    /// it is not known count as `unknown`. Of load programmes the records know.
    double
    last_load_change(const double unknown = LastChange::unknown) const;

    /// The path of a load that changes between two times on the surfaces found
    /// last; empty if none does.
    std::string
    varying_load(const double from, const double to) const;

    /// The nodes' internal force, from the stress of the points and the walls
    /// (kN).
    void
    set_internal_force(const MaterialPoints<dim> &points);

    /// What resists the points beside soil and penalty supports.
    Resistances<dim>
    resistances();

    /// The nodes that a step is solved on.
    NodalState &
    step_nodes();

    /// On several ranks: what files show of the whole body, whose points are
    /// known now.
    /// @param forces are those of the tractions on all nodes asked for?
    void
    complete(const MaterialPoints<dim> &points, const bool forces);

    /// Level of the water at a time (m).
    double
    water_level(const double time) const;

    Weights<dim>       weights;
    NodalState         nodes;
    SurfaceFinder<dim> surfaces;
    WaterLoad<dim>     water;
    WaterResultant     water_resultant;
    Tractions<dim>     tractions;
    Walls<dim>         walls;

  private:
    /// Weight, water, tractions and point loads at a time (s), on the surfaces
    /// found last: the nodes' external force.
    /// @param records of the load programmes, at the start of the step
    void
    add_up_loads(const MaterialPoints<dim>     &points,
                 const double                   time,
                 const std::vector<LoadRecord> &records);

    const Case<dim> *the_case;
    RankPart<dim>   *part;      // none on one rank
    NodalVector      of_points; // forces, kN: work space, on several ranks
    DrivenLoads<dim> driven;
  };
} // namespace Waker

#endif
