// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_observers_observer_h
#define waker_observers_observer_h

#include <waker/loads/tractions.h>
#include <waker/loads/water_load.h>
#include <waker/mechanics/energy.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/nodes/wall.h>
#include <waker/observers/failure_record.h>
#include <waker/particles/flow_account.h>

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace Waker
{
  /**
   * The state at the time `time`, as observers see it: all of it, and nothing
   * that they could change. The nodes hold the mapped points and the external
   * force at that time; their increment and internal force belong to the step
   * that ended there, as does `report`.
   */
  template <int dim>
  struct StepView
  {
    std::uint64_t                         step; // steps done
    double                                time; // s
    double                                dt;   // of the step done, s
    const BackgroundGrid<dim>            &grid;
    const MaterialPoints<dim>            &points;
    const NodalState                     &nodes;
    const std::vector<double>            &proximity_field;
    const Surface                        &surface;
    const std::vector<LoadedSegment>     &wetted;
    const WaterResultant                 &water;
    const Liquid                         &standing_water;
    const FailureRecord                  &failure; // with the geometry
    const StepReport<dim>                &report;
    const EnergyAccount                  &energy;
    std::uint64_t                         unconverged_steps;
    const FlowAccount<dim>               *flow; // null without flow
    const Tractions<dim>                 &tractions;
    const Walls<dim>                     &walls;
    const typename Walls<dim>::Tractions &wall_tractions; // kPa
    double                                water_level;    // m
    /// The body's own surface in 3D; null in 2D and if it is prismatic.
    const Facets<dim> *facets;
    const Facets<dim> &wetted_facets;
  };

  /// Where an observer puts its numbers: one column each, the same every step.
  class Row
  {
  public:
    virtual ~Row() = default;

    /// @param name with the unit in brackets, "Dyke width (m)"
    virtual void
    add(const std::string_view name, const double value) = 0;
  };

  /// Watches a run: const state in, numbers out.
  template <int dim>
  class Observer
  {
  public:
    virtual ~Observer() = default;

    virtual void
    observe(const StepView<dim> &view, Row &row) = 0;
  };

  /// Those that every run has: Newton, dyke, water, energy, momentum.
  template <int dim>
  std::vector<std::unique_ptr<Observer<dim>>>
  standard_observers();
} // namespace Waker

#endif
