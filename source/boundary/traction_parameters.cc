// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/errors.h>
#include <waker/boundary/traction_parameters.h>

namespace Waker
{
  void
  TractionParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Method",
      method,
      "Where the traction acts. fixed points, updated points: as equivalent "
      "loads of the points nearest to the surface, chosen at the start or in "
      "every step. surface nodes: between active and inactive cells. proximity "
      "field: on the detected surface. user surface: on a surface of the "
      "user's that moves with the material. volume: at the volume that the "
      "points have in each cell (linear functions, bodies along the grid). "
      "contour: on the outline of the support domains (GIMP).",
      Patterns::Selection("fixed points|updated points|surface nodes|"
                          "proximity field|user surface|volume|contour"));
    prm.add_parameter("Surface file",
                      surface_file,
                      "The user's surface: in 2D a text file with x, y (m) of "
                      "a vertex per line, the soil on the left, an empty line "
                      "between chains; in 3D an STL file. For the points "
                      "methods it may be the surface that the loads stand for; "
                      "empty: the outline of the support domains.",
                      Patterns::Anything());
    prm.add_parameter("Kind",
                      kind,
                      "vector: a constant direction. pressure: against the "
                      "outward normal. hydrostatic: a pressure that grows with "
                      "the depth below a level.",
                      Patterns::Selection("vector|pressure|hydrostatic"));
    prm.add_parameter("Value",
                      value,
                      "Of a vector (kPa): its components, separated by "
                      "semicolons; of a pressure (kPa): one. Numbers or "
                      "expressions of x, y, z (m) and t (s).",
                      Patterns::Anything());
    prm.add_parameter("Level",
                      level,
                      "Hydrostatic: the level (m): a number, an expression of "
                      "t (s), or a table \"t0: y0, t1: y1, ...\" with straight "
                      "lines between.",
                      Patterns::Anything());
    prm.add_parameter("Unit weight",
                      unit_weight,
                      "Hydrostatic: unit weight of the liquid (kN/m^3).",
                      Patterns::Double(0.));
    prm.add_parameter("From",
                      from,
                      "Only the part of the surface in the box From .. To (m) "
                      "is loaded. Empty: all.",
                      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter("To",
                      to,
                      "Upper corner of that box (m).",
                      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter("Facing",
                      facing,
                      "Only the part whose outward normal points in this "
                      "direction, within Opening, is loaded. Empty: all.",
                      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter("Opening",
                      opening,
                      "Largest angle (degrees) between the normal and Facing.",
                      Patterns::Double(0., 180.));
    prm.add_parameter("Minimum support",
                      minimum_support,
                      "A node carries load only if its mass is at least this "
                      "share of a full node's; its load otherwise goes to "
                      "nodes nearby that do, with the same resultant and "
                      "moment. 0: every node.",
                      Patterns::Double(0., 0.5));
  }


  void
  TractionParameters::check(const unsigned int dim,
                            const std::string &functions) const
  {
    (void)dim;
    (void)functions;
  }
} // namespace Waker
