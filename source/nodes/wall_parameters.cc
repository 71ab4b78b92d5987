// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/nodes/wall_parameters.h>

#include <cmath>

namespace Waker
{
  void
  WallParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Line",
                      line,
                      "2D: corners \"x1, y1; x2, y2; ...\" (m) of a line, the "
                      "soil on its left. 3D: corners of a flat convex polygon, "
                      "anticlockwise seen from the soil.",
                      Patterns::Anything());
    add_choice(prm,
               "Type",
               type,
               "rough: the soil sticks to the wall. smooth: it slides "
               "along it. Both hold: they pull as well as push. frictional: "
               "it pushes only. The soil may leave it and touch it again, and "
               "slides where the shear traction reaches friction and "
               "adhesion. It should not lie along a line of the grid: shift "
               "Grid/Lower corner and Upper corner by half a cell.");
    prm.add_parameter("Displacement",
                      displacement,
                      "Displacement of the wall since the start (m): per "
                      "component a number or an expression of t (s), separated "
                      "by semicolons. Empty: at rest.",
                      Patterns::Anything());
    prm.add_parameter("Penalty factor",
                      penalty_factor,
                      "Stiffness between soil and wall, as a multiple of "
                      "(K + 4G/3) / h, from 1e-6 to 1e8.",
                      Patterns::Double(0.));
    prm.add_parameter("Friction coefficient",
                      friction_coefficient,
                      "Frictional walls: shear traction over pressure where "
                      "the soil slides, 0 to 100.",
                      Patterns::Double(0.));
    prm.add_parameter("Friction angle",
                      friction_angle,
                      "The same as an angle (degrees), 0 to 89. Not both.",
                      Patterns::Double(0.));
    prm.add_parameter("Adhesion",
                      adhesion,
                      "Frictional walls: shear traction (kPa), beside that of "
                      "friction, that soil which touches the wall must reach "
                      "to slide; for clay without drainage. It does not pull.",
                      Patterns::Double(0.));
  }


  double
  WallParameters::friction() const
  {
    return friction_angle > 0. ? std::tan(friction_angle * numbers::PI / 180.)
                               : friction_coefficient;
  }


  void
  WallParameters::check(const unsigned int dim) const
  {
    const std::string path = "Walls/" + name + "/";
    const std::size_t n    = split(displacement, ';').size();
    if (n != 0 && n != dim)
      throw UserError(path + "Displacement",
                      "has " + std::to_string(n) + " parts",
                      std::to_string(dim) +
                        ", separated by semicolons, or nothing");
    require_between(path + "Penalty factor", penalty_factor, 1e-6, 1e8);
    require_between(path + "Friction coefficient",
                    friction_coefficient,
                    0.,
                    100.);
    require_between(
      path + "Friction angle", friction_angle, 0., 89., "degrees");
    require_between(path + "Adhesion", adhesion, 0., 1e6, "kPa");
    if (friction_coefficient > 0. && friction_angle > 0.)
      throw UserError(path + "Friction angle",
                      "is " + in_digits(friction_angle) +
                        " degrees, but Friction coefficient is " +
                        in_digits(friction_coefficient),
                      "one of them, the other 0");
  }
} // namespace Waker
