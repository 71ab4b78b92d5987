// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_energy_h
#define waker_mechanics_energy_h

#include <waker/mapping/weights.h>
#include <waker/nodes/nodal_state.h>
#include <waker/particles/material_points.h>

namespace Waker
{
  /// Kinetic energy of the points, sum m v^2 / 2 (kJ).
  template <int dim>
  double
  kinetic_energy(const MaterialPoints<dim> &points);

  /// Kinetic energy of the nodes with the given velocities (kJ).
  template <int dim>
  double
  kinetic_energy(const std::vector<double> &mass, const NodalVector &velocity);

  /// Momentum of the points (Mg m/s = kN s).
  template <int dim>
  Tensor<1, dim>
  momentum(const MaterialPoints<dim> &points);

  template <int dim>
  struct StepReport;

  /**
   * The energy of a run, in kJ (per m in 2D), summed over its steps. Every
   * term is computed on its own, none as the rest of the others, so that
   *   kinetic + (elastic - elastic_start) + dissipation + friction
   *     + ramp_work + mapping_loss = gravity_work + load_work + support_work
   *     + inflow - outflow + remainder
   * leaves a remainder that measures the method: the accuracy of Newton, the
   * trapezoidal rule in yielding points, the strain of mid-step.
   */
  struct EnergyAccount
  {
    double kinetic_start = 0.;
    double elastic_start = 0.;
    double kinetic       = 0.;
    double elastic       = 0.;
    double dissipation   = 0.; // plastic
    double friction      = 0.; // of soil that slides along walls
    double ramp_work     = 0.;
    double mapping_loss  = 0.;
    double gravity_work  = 0.; // potential energy released
    double load_work     = 0.;
    double support_work  = 0.;
    double inflow        = 0.; // kinetic, of material that has entered
    double outflow       = 0.; // kinetic and elastic, of what has left

    double
    remainder() const
    {
      return (kinetic - kinetic_start) + (elastic - elastic_start) +
             dissipation + friction + ramp_work + mapping_loss - gravity_work -
             load_work - support_work - inflow + outflow;
    }

    /// Take in a step.
    template <int dim>
    EnergyAccount &
    operator+=(const StepReport<dim> &step);

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &kinetic_start &elastic_start &kinetic &elastic &dissipation
        &friction &ramp_work &mapping_loss &gravity_work &load_work
          &support_work &inflow &outflow;
    }
  };
} // namespace Waker

#endif
