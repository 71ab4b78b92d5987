// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_resistance_h
#define waker_nodes_resistance_h

#include <waker/nodes/matrix_entries.h>
#include <waker/nodes/nodal_state.h>
#include <waker/particles/material_points.h>

#include <algorithm>
#include <vector>

namespace Waker
{
  /// Forces on the body times its displacement in a step (kJ).
  struct ResistanceWork
  {
    double start = 0.; // of the forces at its start
    double end   = 0.; // at its end
    double lost  = 0.; // of their mean: by friction, 0 or more

    ResistanceWork &
    operator+=(const ResistanceWork &other)
    {
      start += other.start;
      end += other.end;
      lost += other.lost;
      return *this;
    }

    /// Of a force that changes linearly.
    double
    mean() const
    {
      return 0.5 * (start + end);
    }
  };


  /**
   * What answers to a displacement increment of the nodes with a force: the
   * soil, springs of penalty supports, walls off the grid, ghost stiffness.
   * Newton's method (mechanics/newton.h) sums up a list of them.
   *
   * A step goes: begin(); add_force(), linearise() and products as often as
   * wanted, always from the start of the step; accept(), then work().
   */
  template <int dim>
  class Resistance
  {
  public:
    virtual ~Resistance() = default;

    /// What the force is in the residual
    ///   R = r (s F_ext - F_int) - M (k u - q) - F_sup,  r the residual ramp.
    enum class Role
    {
      body,    // F_int: of the body itself
      load,    // F_int: of what presses on the body; counts like a load in
               // what the residual is compared with
      support, // F_sup: holds like a removed equation, which has no ramp
      remedy   // F_int: numerical; keeps no energy
    };

    virtual Role
    role() const = 0;

    /// A step of the points from t to t + dt (s); dt is 0 in the gravity step.
    /// @param nodes with the mass of the points
    virtual void
    begin(const MaterialPoints<dim> &points,
          const NodalState          &nodes,
          const double               t,
          const double               dt) = 0;

    /// internal += the force at the end of the step (kN), that of the body on
    /// what deforms it, for a displacement increment (m).
    virtual void
    add_force(const NodalVector &increment, NodalVector &internal) = 0;

    /// The same at the start of the step. One that carries no force from step
    /// to step has none.
    virtual void
    add_start_force(NodalVector & /*internal*/)
    {}

    /// Take the derivative where the force was last asked for; nothing to do
    /// where it is always the same.
    virtual void
    linearise()
    {}

    /// dst += K src, K the derivative
    virtual void
    vmult_add(NodalVector &dst, const NodalVector &src) const = 0;

    /// diagonal += diag K
    virtual void
    add_diagonal(NodalVector &diagonal) const = 0;

    /// entries += a matrix near K, symmetric and not negative: what a
    /// preconditioner of a static step in space is made of. The nearer, the
    /// fewer iterations; the solution is the same. By default the diagonal.
    virtual void
    add_entries(MatrixEntries &entries) const
    {
      entries.add_diagonal_of(*this);
    }

    virtual bool
    is_symmetric() const
    {
      return true;
    }

    /// Does its force end where a gap opens, or bend where something begins to
    /// slide? Then Newton's method watches its steps, and the gravity step of
    /// an elastic body is no linear one.
    virtual bool
    has_corners() const
    {
      return false;
    }

    /// Take the step: what is carried to the next one, by itself or by the
    /// points.
    /// @return its force on the body as a support (kN)
    virtual Tensor<1, dim>
    accept(const NodalVector &increment, MaterialPoints<dim> &points) = 0;

    /// Of the step that has been accepted.
    virtual ResistanceWork
    work(const NodalVector &increment) const = 0;
  };


  /// Those of one body. They must outlive the list.
  template <int dim>
  using Resistances = std::vector<Resistance<dim> *>;


  /// Has one of them corners?
  template <int dim>
  bool
  have_corners(const Resistances<dim> &resistances)
  {
    return std::any_of(resistances.begin(),
                       resistances.end(),
                       [](const Resistance<dim> *const resistance) {
                         return resistance->has_corners();
                       });
  }
} // namespace Waker

#endif
