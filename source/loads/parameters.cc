// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/expression_pattern.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/loads/parameters.h>

#include <cmath>

namespace Waker
{
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
      level      = plain_number(text).value_or(nan);
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
