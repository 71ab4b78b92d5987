// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_strange_water_h
#define waker_source_simulation_strange_water_h

#include <waker/case/case.h>

#include <algorithm>
#include <string>
#include <vector>

namespace Waker
{
  /// Does x (m) lie on the water's side of the highest point at t = 0?
  template <int dim>
  class WaterSideOfCrest
  {
  public:
    /// @param the_case has points
    explicit WaterSideOfCrest(const Case<dim> &the_case)
      : side(the_case.parameters.water.side)
    {
      const std::vector<Point<dim>> &x =
        the_case.initial_points.initial_position;
      crest = (*std::max_element(x.begin(),
                                 x.end(),
                                 [](const Point<dim> &a, const Point<dim> &b) {
                                   return a[1] < b[1];
                                 }))[0];
    }

    bool
    holds(const double x) const
    {
      return side == WaterSide::left ? x <= crest : x >= crest;
    }

  private:
    WaterSide side;
    double    crest;
  };


  /// Water outside that is apt to give a failure that is none: a limit of W
  /// below the steps of a contour; without a phreatic line a minimum support of
  /// nothing.
  void
  warn_of_water(const Parameters &p, std::vector<std::string> &warnings);

  /// With a phreatic line a minimum support of nothing where the water ever
  /// stands on soil with a law of total stress. Soil of effective stress is in
  /// balance with the water on its outermost nodes by that in its pores.
  template <int dim>
  void
  warn_of_unsupported_water(const Case<dim>          &the_case,
                            std::vector<std::string> &warnings);

  /// In the plane: W is measured at the height of ground that is level over
  /// more than the change of W that counts as failure.
  template <int dim>
  void
  warn_of_level_ground(const Case<dim>          &the_case,
                       std::vector<std::string> &warnings);
} // namespace Waker

#endif
