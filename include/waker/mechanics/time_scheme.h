// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_time_scheme_h
#define waker_mechanics_time_scheme_h

#include <waker/mapping/weights.h>
#include <waker/mechanics/parameters.h>
#include <waker/mechanics/stress_update.h>
#include <waker/nodes/fixities.h>
#include <waker/nodes/nodal_state.h>
#include <waker/nodes/resistance.h>

#include <memory>
#include <optional>
#include <string>

namespace Waker
{
  /// What happened in a step: plain numbers for observers and energy account.
  template <int dim>
  struct StepReport
  {
    bool                converged         = false;
    unsigned int        newton_iterations = 0;
    unsigned int        linear_iterations = 0;
    unsigned int        strong_iterations = 0; // see NewtonReport
    unsigned int        strong_failures   = 0;
    std::vector<double> residuals; // Newton's

    double mean_plastic_strain = 0.; // increment, mean over the points
    double displacement_rate   = 0.; // rms over the mass, m/s

    // Work and energy of the step, kJ (per m in 2D). See mechanics/energy.h.
    double gravity_work   = 0.;
    double load_work      = 0.; // of the external force other than weight
    double support_work   = 0.; // of supports that move or give way
    double ramp_work      = 0.; // withheld by the residual ramp
    double mapping_loss   = 0.; // of kinetic energy, points <-> nodes
    double dissipation    = 0.; // plastic
    double friction       = 0.; // lost by sliding along walls
    double kinetic_energy = 0.; // of the points at the end
    double elastic_energy = 0.; // at the end

    Tensor<1, dim> reaction; // of the supports at the end, kN

    /// Stretched support domains that were held at the length of a cell.
    std::size_t held_domains = 0;

    /// What each rank has found of its points and nodes becomes that of all of
    /// them; the displacement rate is already.
    /// @param n_points of this rank
    void
    sum(const NodeExchange &ranks, const std::size_t n_points);

    /// @param time the end of the step (s)
    /// @throws NumericalFailure with the name of what is no number: a
    ///         comparison with it is false, and would pass for rest
    void
    check_finite(const double time) const;
  };


  /// What the rest of the house may ask about a time scheme.
  struct SchemeTraits
  {
    /// Is it a motion, which can come to rest? Else each step is in balance.
    bool has_inertia = true;
    /// Does it solve for the end of a step as long as the user wants? Else it
    /// takes stable steps of its own, in which the forces are those at the
    /// start.
    bool is_implicit = true;
    /// Does the material move, or do only its stresses change?
    bool moves_points = true;
    /// Is it left to long quasi-static steps (make_scheme_at_rest()) while the
    /// body rests?
    bool has_long_steps = false;
    /// Share of the force at the start of a step in its impulse; the rest is
    /// that of the force which the step ends with.
    double start_of_impulse = 0.5;
  };

  /// Of the scheme that the parameters choose.
  SchemeTraits
  scheme_traits(const TimeParameters &time);

  /// @param what needs a scheme that solves for the end of a step: "there are
  ///        walls off the grid"
  /// @throws UserError "Time stepping/Scheme" if the one chosen does not
  void
  require_implicit(const TimeParameters &time, const std::string &what);

  /// The step that the scheme takes at first (s), with soil at rest.
  double
  first_time_step(const TimeParameters &time,
                  const Materials      &materials,
                  const double          cell_size);

  /// The cells that a compression wave crosses in a step; none if the user does
  /// not choose how many, or nothing waves.
  std::optional<double>
  chosen_courant_number(const TimeParameters &time,
                        const Materials      &materials,
                        const double          cell_size);

  /// The time from which all of the weight and the loads acts (s):
  /// LastChange::never if from the start.
  double
  full_loads_from(const TimeParameters &time);


  /**
   * One step in time. `solve` finds the motion of the nodes and leaves the
   * points alone, so that a step that fails can be tried again, shorter;
   * `to_points` carries it to the points.
   */
  template <int dim>
  class TimeScheme
  {
  public:
    virtual ~TimeScheme() = default;

    /// The step the scheme wants to take (s).
    virtual double
    time_step(const MaterialPoints<dim> &points) const = 0;

    /**
     * Solve from t to t + dt.
     * @param nodes in: mass, velocity, acceleration, external_force; out: the
     *        rest
     */
    virtual StepReport<dim>
    solve(const MaterialPoints<dim> &points,
          const double               t,
          const double               dt,
          NodalState                &nodes) = 0;

    /// Stresses, positions and velocities of the points, and what else the
    /// resistances carry; completes the report.
    virtual void
    to_points(const double         t,
              const double         dt,
              NodalState          &nodes,
              MaterialPoints<dim> &points,
              StepReport<dim>     &report) = 0;
  };


  /// What every scheme needs; all must outlive it.
  template <int dim>
  struct SchemeInput
  {
    const BackgroundGrid<dim> &grid;
    const Weights<dim>        &weights;
    const Materials           &materials;
    const Fixities<dim>       &fixities;
    const TimeParameters      &time;
    const NewtonParameters    &newton;
    const MappingParameters   &mapping;
    double                     gravity;        // m/s^2
    double                     full_node_mass; // Mg
    /// Beside soil and penalty supports: walls off the grid.
    Resistances<dim> resistances = {};
    /// Are the materials linear, and strains to be small? One matrix will do
    /// for a static step.
    bool is_elastic = false;

    /**
     * How far removed equations move in a step (m, in the order of
     * Fixities::removed_list()).
     * @throws NumericalFailure, on all ranks, if one of them, or of the penalty
     *         supports, is no finite number
     */
    void
    find_motion(const double         t,
                const double         dt,
                std::vector<double> &removed_increments) const;
  };

  /**
   * Implicit: Newmark with beta = 1/4, gamma = 1/2 (constant average
   * acceleration), Newton, lumped mass (eqs. 2.16-2.25, 2.38-2.40 of
   * Remmerswaal 2023).
   */
  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_newmark(const SchemeInput<dim> &input);

  /**
   * Explicit: symplectic Euler; the points' new velocities go to the nodes once
   * more before the stress is updated (MUSL; eqs. 2.34-2.37 of Remmerswaal
   * 2023). The time step follows the wave speed: an independent check.
   */
  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_explicit(const SchemeInput<dim> &input);

  /**
   * Quasi-static load steps, F_ext - F_int(u) = 0 at the end of each. The time
   * is that of the load: weight and loads are multiplied with
   * min(1, t / TimeParameters::load_duration). The points get the velocity of
   * their displacement, which counts for nothing: there is no inertia. A step
   * may take no time: loads act, and what is prescribed does not move.
   *
   * Energy: the works are those of the mean of the forces at the start and the
   * end of a step; `mapping_loss` is that of the imbalance which the points'
   * new places leave at its start, and of the ghost stiffness.
   */
  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_quasi_static(const SchemeInput<dim> &input);

  /// The one that `input.time` asks for; of one with long steps that of a body
  /// that moves.
  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_time_scheme(const SchemeInput<dim> &input);

  /**
   * The long steps of a scheme that has them (SchemeTraits), else nothing:
   * quasi-static, of a body that comes from motion and may go on to it. A step
   * that takes soil further than TimeParameters::largest_displacement has not
   * converged: where the next balance is far, there is none on the way. After
   * a step the points have neither velocity nor acceleration; the kinetic
   * energy that they had before counts as mapping loss.
   */
  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_scheme_at_rest(const SchemeInput<dim> &input);

  /// The residual ramp r(t): from 0 at t = 0 to 1 at `duration`; 1 without.
  double
  residual_ramp(const double t, const double duration);

  /// Largest dilatational wave speed of the materials, sqrt((K + 4G/3) / rho)
  /// (m/s).
  double
  wave_speed(const Materials &materials);

  /// Largest K + 4G/3 of the materials (kPa).
  double
  stiffest_modulus(const Materials &materials);
} // namespace Waker

#endif
