// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_traction_h
#define waker_loads_traction_h

#include <waker/base/expression.h>
#include <waker/base/time_function.h>
#include <waker/loads/liquid.h>
#include <waker/loads/traction_parameters.h>
#include <waker/surface/shape/facet.h>

#include <vector>

namespace Waker
{
  /**
   * What acts on a surface, and on which part of it: a vector, a pressure
   * against the normal, or a hydrostatic pressure. Where the surface is, others
   * say.
   */
  template <int dim>
  class Traction
  {
  public:
    /// @param tolerance a surface this close to the box From .. To is in it (m)
    /// @throws UserError "Tractions/<name>/..." if a value cannot be read
    Traction(const TractionParameters &parameters, const double tolerance);

    /// The part of a surface that may be loaded at some time: in the box, with
    /// the right normal, not on a closed face of the grid, and in a hole only
    /// if these are wanted. Cut exactly.
    /// @param part overwritten
    void
    select(const Facets<dim> &surface, Facets<dim> &part);

    /// From now on the values are those at time t (s).
    void
    set_time(const double t);

    /// The part that is under load at the time set: hydrostatic, that below
    /// the level. @param part of select(); cut
    void
    keep_loaded(Facets<dim> &part);

    /// Traction (kPa) on a surface with this outward normal at x.
    Tensor<1, dim>
    value(const Tensor<1, dim> &normal, const Point<dim> &x) const;

    /// Force (kN) on a piece that rides on the soil, if all of it were at X.
    /// @param start_measure of the piece at t = 0 (m^(dim-1)): a vector is the
    ///        load of that
    /// @param area now, times the normal: a pressure is the load of that
    /// @param X place at t = 0
    Tensor<1, dim>
    force(const double          start_measure,
          const Tensor<1, dim> &area,
          const Point<dim>     &X) const;

    /// Is it the same everywhere?
    bool
    is_uniform() const
    {
      return uniform && kind != TractionKind::hydrostatic;
    }

    /// Does it depend on the time?
    bool
    moves() const;

    /// The last time at which its values change (s): see LastChange.
    double
    last_change() const;

    /// Do its values on a surface change between two times?
    bool
    varies(const Facets<dim> &surface,
           const double       from,
           const double       to) const;

    bool
    is_hydrostatic() const
    {
      return kind == TractionKind::hydrostatic;
    }

  private:
    TractionKind                 kind;
    std::vector<Expression<dim>> expressions; // of a vector or a pressure
    TimeFunction                 level;
    Liquid                       liquid;    // if hydrostatic
    double                       tolerance; // m

    bool           holes   = false; // are they loaded?
    bool           has_box = false;
    Point<dim>     lower, upper;  // of the box
    bool           faces = false; // only one way?
    Tensor<1, dim> facing;        // unit vector
    double         least_cosine = -1.;

    double                time = 0.;
    std::array<double, 3> constant{}; // values of uniform expressions
    bool                  uniform = true;
    Facets<dim>           work;
  };
} // namespace Waker

#endif
