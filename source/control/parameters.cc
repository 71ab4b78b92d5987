// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/errors.h>
#include <waker/base/expression_pattern.h>
#include <waker/base/last_change.h>
#include <waker/base/text.h>
#include <waker/control/parameters.h>

namespace Waker
{
  void
  InitialFailureParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Width change",
                      limits.width_change,
                      "A dyke has failed initially when its width at the water "
                      "level differs from the first detected one by more than "
                      "this (m), above 0. The reading of the thesis counts a "
                      "loss of width only; all readings are recorded.",
                      Patterns::Double(0.));
    prm.add_parameter("Height loss",
                      limits.height_loss,
                      "Or when its height has dropped by more than this (m), "
                      "above 0.",
                      Patterns::Double(0.));
    prm.add_parameter("Displacement",
                      limits.distance,
                      "Or when a connected body has moved further than the "
                      "rest of the soil by more than this (m), on average and "
                      "since t = 0; above 0.",
                      Patterns::Double(0.));
    prm.add_parameter("Share of the profile",
                      limits.share,
                      "... and the body is larger than this share (-) of the "
                      "whole profile, foundation included; below 1.",
                      Patterns::Double(0., 1.));
  }


  void
  InitialFailureParameters::check() const
  {
    require_positive("Initial failure/Width change", limits.width_change);
    require_positive("Initial failure/Height loss", limits.height_loss);
    require_positive("Initial failure/Displacement", limits.distance);
    if (!(limits.share < 1.))
      throw UserError("Initial failure/Share of the profile",
                      "is " + std::to_string(limits.share),
                      "at least 0 and below 1");
  }


  void
  SlidingMassParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Watch",
                      watch,
                      "Split the soil into stable soil and sliding masses "
                      "while the run goes on, and record them.",
                      Patterns::Bool());
    prm.add_parameter("Displacement",
                      displacement,
                      "A slide has happened when soil that was stable so far "
                      "has moved further than this (m) since t = 0; above 0. "
                      "The stable soil is then split in two by its "
                      "displacements, and the part that has moved further "
                      "stays a sliding mass.",
                      Patterns::Double(0.));
    prm.add_parameter("Crest edge",
                      crest_edge,
                      "x (m) from which the retrogression distance is "
                      "measured. \"detected\": the end of the highest row of "
                      "points at t = 0, in 3D at each z, on the side away from "
                      "the water (without water, of positive x).",
                      NumberOrWordPattern("detected"));
  }


  void
  SlidingMassParameters::check() const
  {
    require_positive("Sliding masses/Displacement", displacement);
    given_edge();
  }


  std::optional<double>
  SlidingMassParameters::given_edge() const
  {
    const std::string text = tidy(crest_edge);
    if (text == "detected")
      return {};
    const std::optional<double> x = plain_number(text);
    if (!x)
      throw UserError("Sliding masses/Crest edge",
                      "is \"" + text + "\"",
                      "a number (m), or detected");
    return x;
  }


  void
  StopParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("On flooding",
                      on_flooding,
                      "Stop when the dyke is lower than the water.",
                      Patterns::Bool());
    prm.add_parameter("At rest",
                      at_rest,
                      "Stop when nothing moves any more, failed or not, as "
                      "the following limits say.",
                      Patterns::Bool());
    prm.add_parameter("Rest plastic strain",
                      rest_plastic_strain,
                      "At rest: mean plastic strain increment of a step (-) "
                      "below this, above 0.",
                      Patterns::Double(0.));
    prm.add_parameter("Rest velocity",
                      rest_velocity,
                      "At rest: root mean square displacement rate (m/s) below "
                      "this, above 0. A body that has slid rings elastically "
                      "with about 0.02 m/s, as nothing damps it.",
                      Patterns::Double(0.));
    prm.add_parameter("Rest duration",
                      rest_duration,
                      "Both must be below their limits for this time (s), "
                      "above 0.",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Loads constant from",
      loads_constant_from,
      "No dyke is at rest while its loads change: the time counts from their "
      "last change. Of a table it is known. Water, tractions, walls and "
      "boundary conditions that are expressions of t may change at any time, "
      "so that such a run goes on to its end time, unless this is the time "
      "(s) from which all of them are constant. It is tried at 1000 moments "
      "up to the end time. \"unknown\": no such time.",
      NumberOrWordPattern("unknown"));
    prm.add_parameter("On initial failure",
                      on_initial_failure,
                      "Stop at initial failure (a strength reduction does).",
                      Patterns::Bool());
  }


  void
  StopParameters::check() const
  {
    require_positive("Stop rules/Rest plastic strain", rest_plastic_strain);
    require_positive("Stop rules/Rest velocity", rest_velocity);
    require_positive("Stop rules/Rest duration", rest_duration);
    declared_last_change();
  }


  double
  StopParameters::declared_last_change() const
  {
    const std::string text = tidy(loads_constant_from);
    if (text == "unknown")
      return LastChange::unknown;
    const double time = plain_number(text).value_or(-1.);
    if (!(time >= 0.))
      throw UserError("Stop rules/Loads constant from",
                      "is \"" + text + "\"",
                      "a time of at least 0 s, or unknown");
    return time;
  }
} // namespace Waker
