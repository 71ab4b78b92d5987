// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_time_scheme_h
#define waker_mechanics_time_scheme_h

#include <waker/mechanics/newton.h>
#include <waker/mechanics/parameters.h>
#include <waker/mechanics/stress_update.h>
#include <waker/nodes/nodal_state.h>

#include <memory>

namespace Waker
{
  /// What happened in a step: plain numbers for observers and energy account.
  template <int dim>
  struct StepReport
  {
    bool                converged         = false;
    unsigned int        newton_iterations = 0;
    unsigned int        linear_iterations = 0;
    std::vector<double> residuals; // Newton's

    double mean_plastic_strain = 0.; // increment, mean over the points
    double displacement_rate   = 0.; // rms over the mass, m/s

    // Work and energy of the step, kJ (per m in 2D). See mechanics/energy.h.
    double gravity_work   = 0.;
    double water_work     = 0.; // of the external force other than weight
    double support_work   = 0.; // of moving supports
    double ramp_work      = 0.; // withheld by the residual ramp
    double mapping_loss   = 0.; // of kinetic energy, points <-> nodes
    double dissipation    = 0.; // plastic
    double kinetic_energy = 0.; // of the points at the end
    double elastic_energy = 0.; // at the end

    Tensor<1, dim> reaction; // of the supports at the end, kN

    /// Stretched support domains that were held at the length of a cell.
    std::size_t held_domains = 0;
  };


  /**
   * One step in time. `solve` finds the motion of the nodes and leaves the
   * points alone, so that a step that fails can be tried again, shorter;
   * `update_points` carries it to the points.
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
          const Weights<dim>        &weights,
          const double               t,
          const double               dt,
          NodalState                &nodes) = 0;

    /// Stresses, positions and velocities of the points; completes the report.
    virtual void
    update_points(const Weights<dim>  &weights,
                  const double         t,
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
    double                     gravity;         // m/s^2
    double                     full_node_mass;  // Mg
    const Walls<dim>          *walls = nullptr; // off the grid, if any
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
   * their displacement, which counts for nothing: there is no inertia.
   *
   * Energy: the works are those of the mean of the forces at the start and the
   * end of a step; `mapping_loss` is that of the imbalance which the points'
   * new places leave at its start, and of the ghost stiffness.
   */
  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_quasi_static(const SchemeInput<dim> &input);

  /// By name: "Newmark", "explicit" or "quasi-static".
  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_time_scheme(const SchemeInput<dim> &input);

  /// Add the force and the work of penalty springs at the end of a step to its
  /// report.
  /// @param targets of the springs' increments (m)
  template <int dim>
  void
  add_spring_reaction(const Springs             &springs,
                      const std::vector<double> &targets,
                      const NodalState          &nodes,
                      StepReport<dim>           &report);

  /// Root mean square rate of displacement of the points (m/s); 0 if none is
  /// left.
  /// @param square sum of mass times squared displacement (Mg m^2)
  double
  displacement_rate(const double square, const double mass, const double dt);

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
