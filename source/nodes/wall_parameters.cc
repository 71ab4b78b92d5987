// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/text.h>
#include <waker/nodes/wall_parameters.h>

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
               "along it. Both hold: they pull as well as push.");
    prm.add_parameter("Displacement",
                      displacement,
                      "Displacement of the wall since the start (m): per "
                      "component a number or an expression of t (s), separated "
                      "by semicolons. Empty: at rest.",
                      Patterns::Anything());
    prm.add_parameter("Penalty factor",
                      penalty_factor,
                      "Stiffness between soil and wall, as a multiple of "
                      "(K + 4G/3) / h, above 0.",
                      Patterns::Double(0.));
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
    require_positive(path + "Penalty factor", penalty_factor);
  }
} // namespace Waker
