// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/expression_pattern.h>
#include <waker/base/text.h>
#include <waker/boundary/parameters.h>

#include <cmath>

namespace Waker
{
  void
  SurfaceParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Method",
               method,
               "How the surface of the soil is found: the proximity "
               "field of the points, or the contour of their support "
               "domains. Water loads it, and the dyke is measured on "
               "it.");
    prm.add_parameter("Prismatic",
                      prismatic,
                      "In 3D: take the body as prismatic along z, and find its "
                      "surface in the x-y plane, as for a slice in plane "
                      "strain.",
                      Patterns::Bool());
    prm.add_parameter("Kernel radius",
                      kernel_radius,
                      "Radius of the kernel of the proximity field, in cells, "
                      "0.5 to 2. A larger one gives a smoother surface but "
                      "rounds corners and closes gaps narrower than itself; "
                      "below 0.75 the surface follows single points.",
                      Patterns::Double(0.5, 2.));
    prm.add_parameter("Threshold",
                      threshold,
                      "Value of the proximity field at the surface, 0.05 to "
                      "0.95 (the field is about 1 inside the body). With 0.5 "
                      "a flat face has no mean offset; less moves the surface "
                      "outwards.",
                      Patterns::Double(0.05, 0.95));
    prm.add_parameter("Mirror",
                      mirror,
                      "Mirror the kernels at fixed faces of the grid. Without, "
                      "the field is halved there and the surface curls inward.",
                      Patterns::Bool());
    prm.add_parameter("Minimum gap width",
                      minimum_gap_width,
                      "Contour: horizontal gaps between support domains that "
                      "are narrower than this are filled, as a share of the "
                      "smallest domain's width, 0 (none) to below 1.",
                      Patterns::Double(0.));
    prm.add_parameter("Minimum gap height",
                      minimum_gap_height,
                      "Contour: vertical gaps lower than this are filled, as a "
                      "share of the smallest domain's height, 0 to below 1.",
                      Patterns::Double(0.));
    prm.add_parameter("Symmetric filling",
                      symmetric_filling,
                      "Contour: fill gaps alike from both sides. Off: from the "
                      "left, as in the thesis.",
                      Patterns::Bool());
  }



  void
  WaterParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Side",
               side,
               "Side of the dyke on which the water stands: none, left "
               "or right. It loads the surface from the toe on this "
               "side up to the water level.");
    prm.declare_entry("Level",
                      level_text,
                      NumberOrWordPattern("none"),
                      "Water level on the vertical axis, in m, within the "
                      "height of the soil. The width of the dyke is measured "
                      "at this level, also without water. none: no level, and "
                      "so neither water nor width; initial failure is then "
                      "seen by the height only.");
    prm.add_action("Level", [this](const std::string &text) {
      level_text = tidy(text);
      level =
        plain_number(text).value_or(std::numeric_limits<double>::quiet_NaN());
    });
    prm.add_parameter("Rise",
                      rise,
                      "Rise of the water above Level in time (m): a number, an "
                      "expression of t (s), or a table \"t0: y0, t1: y1, "
                      "...\" with straight lines between. The width of the "
                      "dyke is measured at Level all the time; it is flooded "
                      "where it does not rise above Level + Rise.",
                      Patterns::Anything());
    prm.add_parameter("Unit weight",
                      unit_weight,
                      "Unit weight of water, in kN/m^3, not negative.",
                      Patterns::Double(0.));
    prm.add_parameter("Minimum support",
                      minimum_support,
                      "A node carries water load only if its mass is at least "
                      "this share of the mass of a node inside the body, 0 to "
                      "0.5; its load otherwise goes to nodes nearby that do, "
                      "with the same resultant and moment.",
                      Patterns::Double(0., 0.5));
  }



  void
  WaterParameters::check() const
  {
    if (!std::isnan(level))
      return;
    if (level_text != "none")
      throw UserError("Water/Level",
                      "\"" + level_text + "\" is no number",
                      "a level in m, with a decimal point; or none");
    if (stands())
      throw UserError("Water/Level",
                      "is none, but water stands on the " +
                        std::string(name_of(side)),
                      "a level in m, or Water/Side = none");
  }
} // namespace Waker
