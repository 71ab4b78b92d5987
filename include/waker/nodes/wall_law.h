// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_wall_law_h
#define waker_nodes_wall_law_h

#include <deal.II/base/tensor.h>

#include <waker/nodes/wall_parameters.h>

namespace Waker
{
  using namespace dealii;

  /**
   * The traction (kPa) of a wall on the soil that touches it, for the motion w
   * (m) of the soil relative to the wall in a step. n is the unit normal into
   * the soil, k the stiffness, t0 the traction at the start of the step.
   *
   * rough:      t = t0 - k w
   * smooth:     t = t0 - k (w.n) n
   * frictional: the pressure is p = max(0, t0.n - k (w.n + g)), g >= 0 the gap
   *   at the start; no pressure, no traction. The shear traction is the trial
   *   s = (1 - n n) (t0 - k w), cut to the length mu p + a: Coulomb's law by a
   *   radial return (Wriggers 2006, Computational Contact Mechanics, 10.2), not
   *   associated: sliding opens no gap.
   */
  template <int dim>
  struct WallLaw
  {
    WallType type;
    double   stiffness; // k, kPa/m
    double   friction;  // mu
    double   adhesion;  // a, kPa

    /// What a spot knows at the start of a step.
    struct Start
    {
      Tensor<1, dim> normal;
      Tensor<1, dim> traction; // t0, kPa
      double         gap;      // g, m
    };

    Tensor<1, dim>
    traction(const Start &start, const Tensor<1, dim> &w) const;

    /// - dt/dw (kPa/m). At a corner of the law that of soil which sticks.
    Tensor<2, dim>
    derivative(const Start &start, const Tensor<1, dim> &w) const;

    /// Does the soil slide against friction? Then the derivative is not
    /// symmetric.
    bool
    slides(const Start &start, const Tensor<1, dim> &w) const;

    /// What sliding takes from the step, per area (kJ/m^2): the slip times the
    /// shear traction at its end. The rest of the work is in springs.
    double
    dissipation(const Start &start, const Tensor<1, dim> &w) const;

  private:
    struct Trial;

    Trial
    trial(const Start &start, const Tensor<1, dim> &w) const;
  };
} // namespace Waker

#endif
