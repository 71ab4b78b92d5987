// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_case_h
#define waker_case_case_h

#include <waker/base/numbers.h>
#include <waker/case/flow.h>
#include <waker/case/ground.h>
#include <waker/case/load_programmes.h>
#include <waker/case/parameters.h>
#include <waker/loads/tractions.h>
#include <waker/measures/crest.h>
#include <waker/measures/sliding_masses.h>
#include <waker/mechanics/balance_step.h>
#include <waker/mechanics/gravity_step.h>
#include <waker/mechanics/stress_update.h>
#include <waker/nodes/fixities.h>
#include <waker/nodes/wall.h>
#include <waker/surface/user_surface.h>

#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  template <int dim>
  class Scene;


  /// How the stress of a stage has come about.
  struct StageReport
  {
    std::string name;
    /// See out_of_balance(): of the stress that it began with.
    double imbalance = 1.;
    /// Plastic laws; else there is a gravity step.
    std::optional<BalanceReport> balance;
    GravityReport                gravity;
    /// Of the effective vertical stress, from that of columns, and their mean
    /// over the volume (kPa); NaN if those are not known.
    double difference_rms = nan, mean_vertical_stress = nan;
  };


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
     * @param watcher of Initial stress/Laws = plastic, while it is computed
     * @throws UserError for whatever is wrong with the input
     */
    Case(const Parameters     &parameters,
         const MPI_Comm        communicator,
         Materials             materials = {},
         const BalanceWatcher &watcher   = {});

    /// Of a case of which nobody asks for them again: the only realisation has
    /// begun, or begins with them.
    MaterialPoints<dim>
    take_initial_points();

    const Parameters          parameters;
    const BackgroundGrid<dim> grid;
    /// Of the tractions, one each.
    const std::vector<UserSurface<dim>> user_surfaces;
    const Materials                     materials;
    const Flow<dim>                     flow;
    const Fixities<dim>                 fixities;
    const LoadProgrammes<dim>           programmes;
    const PoreWater<dim>                pore_water;
    const Ground<dim>                   ground;
    const double full_node_mass; // Mg, of a node inside the body
    /// At t = 0; empty after take_initial_points().
    MaterialPoints<dim> initial_points;
    bool                has_point_loads = false; // on any of them
    /// Height to which their soil reaches (m).
    double initial_height = nan;
    /// If they are watched.
    std::optional<SlidingMassFinder<dim>> slides;
    /// Number of each one's layer; no layer has the number of what flows in.
    std::vector<unsigned int>      layers_of_points;
    typename Walls<dim>::Tractions initial_wall_tractions; // kPa
    /// Numbers of the walls that no soil touches.
    std::vector<unsigned int> idle_walls;
    /// Of the tractions, one each; without pieces for those that do not ride.
    std::vector<RidingLoad<dim>> riding_loads;
    /// Of the tractions, one each.
    std::vector<typename Tractions<dim>::Resultant> initial_tractions;
    GravityReport                                   gravity_report;
    /// Of the stress at t = 0, the daily one first; empty without any.
    std::vector<StageReport> stages;
    /// The time at which the loads settle (s), the last one at which any of
    /// them changes: as known from the loads, or as the user says; see
    /// LastChange. Of load programmes the records know.
    double last_load_change = LastChange::never;
    /// Where W is measured (m); NaN: nowhere, as there is no level, or no soil
    /// at it.
    double measuring_level = nan;
    /// z at which H and W are measured (m), ascending; empty in the plane and
    /// if the surface is prismatic.
    std::vector<double> sections;
    /// Does the water load anything at t = 0?
    bool water_touches = false;

  private:
    double
    declared_last_load_change(const Scene<dim> &scene) const;

    double
    checked_measuring_level(Scene<dim> &scene) const;

    void
    set_initial_state(const BalanceWatcher &watcher);

    /// The stress of the points, in balance with the scene's external force:
    /// source/case/initial_stress.cc.
    void
    set_stress(Scene<dim> &scene, const BalanceWatcher &watcher);

    /// The stress of the daily stage, for the laws at t = 0.
    void
    carry_daily_stress(const BalanceWatcher &watcher);
  };


  /// The crest that sliding masses are measured on.
  /// @throws UserError "Sliding masses/Crest edge" if it is none of the crest
  template <int dim>
  Crest<dim>
  initial_crest(const Case<dim> &the_case);


  /// The vertices that the material carries, at t = 0.
  template <int dim>
  SurfaceVertices<dim>
  initial_vertices(const Case<dim> &the_case);
} // namespace Waker

#endif
