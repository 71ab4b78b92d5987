// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_case_h
#define waker_simulation_case_h

#include <waker/boundary/proximity_field.h>
#include <waker/boundary/water_load.h>
#include <waker/mapping/weights.h>
#include <waker/mechanics/gravity_step.h>
#include <waker/mechanics/stress_update.h>
#include <waker/nodes/fixities.h>
#include <waker/nodes/nodal_state.h>
#include <waker/simulation/flow.h>
#include <waker/simulation/parameters.h>

namespace Waker
{
  /**
   * What all realisations of one dyke share, and none changes: grid,
   * materials, supports, and the points with their in-situ stress.
   */
  template <int dim>
  struct Case
  {
    /**
     * @param materials instead of those of the parameters, by number, for
     *        programs that bring their own; empty: made from the parameters
     * @throws UserError for whatever is wrong with the input
     */
    Case(const Parameters &parameters,
         const MPI_Comm    communicator,
         Materials         materials = {});

    const Parameters          parameters;
    const BackgroundGrid<dim> grid;
    const Materials           materials;
    const Flow<dim>           flow;
    const Fixities<dim>       fixities;
    const double              full_node_mass; // Mg, of a node inside the body
    MaterialPoints<dim>       initial_points;
    GravityReport             gravity_report;

  private:
    void
    set_initial_state();
  };


  /**
   * The nodes' side of a moment: weights, nodal state, surface and load of the
   * points as they lie. Work space, made once and used in every step.
   */
  template <int dim>
  class Scene
  {
  public:
    explicit Scene(const Case<dim> &the_case);

    /// Map the points, find the surface, load it with weight and water.
    void
    set(const MaterialPoints<dim> &points);

    Weights<dim>        weights;
    NodalState          nodes;
    ProximityField<dim> proximity;
    Surface             surface;
    WaterLoad<dim>      water;
    WaterResultant      water_resultant;

  private:
    const Case<dim> *the_case;
  };
} // namespace Waker

#endif
