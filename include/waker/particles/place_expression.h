// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_place_expression_h
#define waker_particles_place_expression_h

#include <deal.II/base/point.h>

#include <waker/base/named_expression.h>

#include <string>
#include <vector>

namespace Waker
{
  using namespace dealii;

  /// A place in the ground at t = 0.
  struct InGround
  {
    double depth;                 // m, below the highest soil over the place
    double depth_in_layer;        // m, below the top of its layer
    double vertical_stress;       // kPa, effective, compression positive
    double daily_vertical_stress; // kPa, likewise, with the daily water
  };


  /// A function of the place in the soil at t = 0 that the user writes: of x,
  /// y, in 3D z (m), and of what InGround names. Not for several threads at a
  /// time.
  template <int dim>
  class PlaceExpression
  {
  public:
    /// @param path of the parameter, for the error
    /// @param more names of further variables
    /// @param or_else what else the parameter takes, for the error
    /// @throws UserError if the text is no expression of them
    PlaceExpression(const std::string              &text,
                    const std::string              &path,
                    const std::vector<std::string> &more    = {},
                    const std::string              &or_else = "");

    /// @param more values of the further variables
    double
    value(const Point<dim>          &x,
          const InGround            &ground,
          const std::vector<double> &more = {}) const;

    /// Is a vertical stress among what it asks for?
    bool
    asks_for_stress() const;

    const std::string &
    text() const
    {
      return expression.text();
    }

  private:
    NamedExpression expression;
  };
} // namespace Waker

#endif
