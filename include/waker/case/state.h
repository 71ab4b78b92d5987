// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_state_h
#define waker_case_state_h

#include <waker/control/long_steps.h>
#include <waker/control/stop_rules.h>
#include <waker/loads/pore_water.h>
#include <waker/loads/tractions.h>
#include <waker/measures/failure_record.h>
#include <waker/measures/load_record.h>
#include <waker/measures/sliding_masses.h>
#include <waker/mechanics/energy.h>
#include <waker/nodes/wall.h>
#include <waker/particles/flow_account.h>
#include <waker/particles/material_points.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * Everything that a realisation carries from step to step. It is copyable: a
   * checkpoint is a state on disk, a realisation is a copy of the case's first
   * state with strengths of its own.
   */
  template <int dim>
  struct State
  {
    MaterialPoints<dim> points;
    double              time = 0.; // s
    std::uint64_t       step = 0;  // steps done

    /// Of the user's surfaces and of loads that ride: the material carries
    /// them along.
    SurfaceVertices<dim>        surface_vertices;
    std::vector<TractionRecord> tractions; // one each, from the first look on

    typename Walls<dim>::Tractions wall_tractions; // kPa

    std::vector<LoadRecord> loads; // of the load programmes, one each

    PoreWaterRecord pore_water;

    FlowAccount<dim> flow;
    EnergyAccount    energy;
    FailureRecord    failure;
    SlidingMasses    sliding; // if they are watched
    RestRecord       rest;

    // Of the last step, for the stop rules.
    double mean_plastic_strain = 0.;
    double displacement_rate   = 0.; // m/s
    double settlement_rate     = 0.; // largest of a point, m/s
    double last_dt             = 0.; // s

    // The step control: dt = wanted step / 2^halvings.
    unsigned int  halvings           = 0;
    unsigned int  steps_since_change = 0;
    std::uint64_t newton_iterations  = 0;
    std::uint64_t linear_iterations  = 0;
    std::uint64_t unconverged_steps  = 0; // attempts given up
    LongSteps     long_steps;             // if the scheme has them

    /// To and from bytes, for checkpoints: exact, for the same program and
    /// machine. read() throws std::exception if the bytes are not a state.
    std::string
    write() const;

    void
    read(const std::string &bytes);

    /// All but the values of the points' arrays (point_arrays.h), of which each
    /// has so many.
    std::string
    write_record(const std::vector<std::uint64_t> &array_sizes) const;

    /// The arrays get their sizes.
    void
    read_record(const std::string &bytes);
  };


  template <int dim>
  struct Case;

  /// The state at t = 0.
  template <int dim>
  State<dim>
  initial_state(const Case<dim> &the_case);

  /// The same, of points that were taken from the case.
  template <int dim>
  State<dim>
  initial_state(const Case<dim> &the_case, MaterialPoints<dim> points);
} // namespace Waker

#endif
