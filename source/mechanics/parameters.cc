// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/mechanics/parameters.h>
#include <waker/mechanics/time_scheme.h>

namespace Waker
{
  void
  TimeParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Scheme",
               scheme,
               "Newmark: implicit, beta = 1/4, gamma = 1/2 (the main "
               "scheme). explicit: an independent check with its own, "
               "stable time step. quasi-static: no inertia; the time is "
               "that of the load. quasi-static at rest: long quasi-static "
               "steps while the dyke rests, Newmark with Time step while it "
               "moves; for water that rises or falls for hours.");
    prm.add_parameter("Time step",
                      time_step,
                      "Time step of the Newmark scheme (s), above 0. The "
                      "accuracy suffers when a wave crosses more than a few "
                      "cells in it; the run prints that number. Quasi-static: "
                      "of the load steps.",
                      Patterns::Double(0.));
    prm.add_parameter(
      "End time",
      end_time,
      "Time at which a run ends at the latest (s). 0: write the "
      "state at the start and stop.",
      Patterns::Double(0.));
    prm.add_parameter("Ramp duration",
                      ramp_duration,
                      "The unbalanced force after the gravity step grows from "
                      "nothing to full over this time (s). 0: at once. Not for "
                      "the quasi-static scheme.",
                      Patterns::Double(0.));
    prm.add_parameter("Maximum halvings",
                      maximum_halvings,
                      "A step that does not converge is halved at most this "
                      "often before the run ends as a numerical failure.",
                      Patterns::Integer(0, 20));
    prm.add_parameter("Courant number",
                      courant_number,
                      "Explicit scheme: time step as a share (-) of the time "
                      "in which a compression wave crosses a cell, above 0.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Load duration",
                      load_duration,
                      "Quasi-static scheme: weight and loads grow from nothing "
                      "to full over this time (s). 0: full from the start, as "
                      "it must be after a gravity step.",
                      Patterns::Double(0.));
    prm.add_parameter("Move points",
                      move_points,
                      "Quasi-static scheme: the points move with the nodes. "
                      "false: only their stresses change.",
                      Patterns::Bool());
    prm.add_parameter("Ghost stiffness",
                      ghost_stiffness,
                      "Quasi-static scheme: a stiffness, as a share (-) of "
                      "K + 4G/3, makes nodes that support domains hardly touch "
                      "follow their neighbours. 0: none; Newton's method may "
                      "then fail in large deformation.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Longest step",
                      longest_step,
                      "Quasi-static at rest: length of a long step (s), from "
                      "Time step to 1e6. One without balance at its end is "
                      "halved, Maximum halvings times; then the dyke moves, in "
                      "steps of Time step, until it has been at rest for "
                      "Stop rules/Rest duration (longer each time that "
                      "long steps fail again).",
                      Patterns::Double(0.));
    prm.add_parameter("Largest rise",
                      largest_rise,
                      "Quasi-static at rest: change of the level of the water "
                      "in a long step (m), up or down, from 1e-6 to 10. The "
                      " corners of a table Water/Rise end a step as well.",
                      Patterns::Double(0.));
    prm.add_parameter("Largest displacement",
                      largest_displacement,
                      "Quasi-static at rest: a step in which more than 0.1 % "
                      "of the soil would move further than this (m) is "
                      "no long one, as without balance; from 1e-6 to 10.",
                      Patterns::Double(0.));
  }


  void
  TimeParameters::check() const
  {
    require_positive("Time stepping/Time step", time_step);
    if (!(end_time >= 0.))
      throw UserError("Time stepping/End time",
                      "is " + in_digits(end_time) + " s",
                      "0 or a positive time");
    if (!(ramp_duration >= 0.))
      throw UserError("Time stepping/Ramp duration",
                      "is " + in_digits(ramp_duration) + " s",
                      "0 (no ramp) or a positive time");
    if (!(load_duration >= 0.))
      throw UserError("Time stepping/Load duration",
                      "is " + in_digits(load_duration) + " s",
                      "0 (full from the start) or a positive time");
    if (!(courant_number > 0. && courant_number <= 1.))
      throw UserError("Time stepping/Courant number",
                      "is " + in_digits(courant_number),
                      "above 0 and at most 1");
    if (!(longest_step > 0. && longest_step <= 1e6))
      throw UserError("Time stepping/Longest step",
                      "is " + in_digits(longest_step) + " s",
                      "above 0 and at most 1e6 s");
    // Less, and no step is long.
    require_between("Time stepping/Largest rise", largest_rise, 1e-6, 10., "m");
    require_between("Time stepping/Largest displacement",
                    largest_displacement,
                    1e-6,
                    10.,
                    "m");
    if (scheme_traits(*this).has_long_steps && !(longest_step >= time_step))
      throw UserError("Time stepping/Longest step",
                      "is " + in_digits(longest_step) +
                        " s, shorter than Time step, " + in_digits(time_step) +
                        " s",
                      "at least Time step, that of a dyke that moves");
  }


  void
  NewtonParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Tangent",
               tangent,
               "consistent: the derivative of the internal force, "
               "quadratic convergence. double mapping: from stiffness "
               "mapped to Gauss points, a smaller matrix.");
    prm.add_parameter("Tolerance",
                      tolerance,
                      "A step has converged when the mass-weighted norm of its "
                      "residual is below this share (-) of that of the "
                      "external, internal and inertial forces together; "
                      "above 0, below 1.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Maximum iterations",
                      maximum_iterations,
                      "A step that needs more iterations is halved.",
                      Patterns::Integer(1, 1000));
    prm.add_parameter("Linear tolerance",
                      linear_tolerance,
                      "Relative accuracy (-) of the linear solves (inexact "
                      "Newton), which stop earlier where Tolerance is "
                      "reached; above 0, below 1.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Maximum linear iterations",
                      maximum_linear_iterations,
                      "Limit of linear iterations in one solve.",
                      Patterns::Integer(1));
    prm.add_parameter("Predictor",
                      predictor,
                      "Start a step from v dt + a dt^2 / 2 instead of from no "
                      "displacement: about half the iterations.",
                      Patterns::Bool());
  }


  void
  NewtonParameters::check() const
  {
    const auto check_tolerance = [](const std::string &path,
                                    const double       value) {
      if (!(value > 0. && value < 1.))
        throw UserError(path, "is " + in_digits(value), "above 0 and below 1");
    };
    check_tolerance("Newton/Tolerance", tolerance);
    check_tolerance("Newton/Linear tolerance", linear_tolerance);
    if (maximum_iterations == 0)
      throw UserError("Newton/Maximum iterations", "is 0", "at least 1");
    if (maximum_linear_iterations == 0)
      throw UserError("Newton/Maximum linear iterations", "is 0", "at least 1");
  }


  void
  GravityParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Acceleration",
                      acceleration,
                      "Acceleration of gravity (m/s^2), downwards (-y). It "
                      "also turns unit weight into density. 0: no weight; "
                      "densities are then unit weight / 9.81.",
                      Patterns::Double(0.));
    prm.add_parameter("Initial stress",
                      initial_stress,
                      "Set up the in-situ stress by an elastic, quasi-static "
                      "step under weight and water, in which points stay in "
                      "place. false: start without stress.",
                      Patterns::Bool());
    prm.add_parameter("Tolerance",
                      tolerance,
                      "Relative residual (-) of that static step; above 0, "
                      "below 1.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Initial share",
                      initial_share,
                      "Share (-) of weight, water and loads that this static "
                      "step applies; above 0, at most 1. The rest acts from "
                      "the start of the run, on points that move and yield: "
                      "with Time stepping/Ramp duration = 0 at once.",
                      Patterns::Double(0., 1.));
  }


  void
  GravityParameters::check() const
  {
    if (!(acceleration >= 0.))
      throw UserError("Gravity/Acceleration",
                      "is " + in_digits(acceleration) + " m/s^2",
                      "0 or a positive number (it points down)");
    if (!(tolerance > 0. && tolerance < 1.))
      throw UserError("Gravity/Tolerance",
                      "is " + in_digits(tolerance),
                      "above 0 and below 1");
    if (!(initial_share > 0. && initial_share <= 1.))
      throw UserError("Gravity/Initial share",
                      "is " + in_digits(initial_share),
                      "above 0 and at most 1 (or Initial stress = false)");
  }


  void
  MappingParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Functions",
               functions,
               "GIMP: points with a support domain (uGIMP), smooth when "
               "they cross cells. linear: standard material point "
               "method.");
    prm.add_parameter("Objective rate",
                      objective_rate,
                      "Strain at mid-step, stress turned with the body (Hughes "
                      "and Winget 1980). false: small strain without rotation, "
                      "as in the thesis.",
                      Patterns::Bool());
    add_choice(prm,
               "Strain",
               strain,
               "step: the strain increment of each step. logarithmic: "
               "Hencky strain of the elastic deformation, with the "
               "internal force in the deformed configuration, for large "
               "elastic strains.");
    add_choice(prm,
               "Volumetric strain",
               volumetric_strain,
               "standard: the dilatation at the point. B-bar: that of "
               "the cells' centres, averaged over the support domain, "
               "in cells that soil fills, so that nearly incompressible "
               "soil does not lock. B-bar in all cells: also where soil "
               "hardly fills them, as the thesis; not for soil under water. "
               "(Neither with Strain = logarithmic.)");
    add_choice(prm,
               "Domains",
               domains,
               "Support domains of GIMP: constant, or stretched with "
               "the deformation of the points (needs Strain = "
               "logarithmic).");
  }


  void
  MappingParameters::check() const
  {
    if (domains == SupportDomains::stretched &&
        functions != ShapeFunctions::gimp)
      throw UserError("Kinematics and mapping/Domains",
                      "is stretched, but linear functions have no support "
                      "domains",
                      "constant, or Functions = GIMP");
    if (domains == SupportDomains::stretched &&
        strain != StrainMeasure::logarithmic)
      throw UserError("Kinematics and mapping/Domains",
                      "is stretched, but the deformation is only followed with "
                      "logarithmic strain",
                      "constant, or Strain = logarithmic");
    if (volumetric_strain != VolumetricStrain::standard &&
        strain == StrainMeasure::logarithmic)
      throw UserError("Kinematics and mapping/Volumetric strain",
                      "is B-bar, which is made for the strain of each step, "
                      "not for logarithmic strain",
                      "standard, or Strain = step");
  }


  void
  check_time_scheme(const TimeParameters    &time,
                    const GravityParameters &gravity,
                    const MappingParameters &mapping)
  {
    if (scheme_traits(time).has_inertia)
      return;
    if (time.load_duration > 0. && gravity.initial_stress)
      throw UserError("Time stepping/Load duration",
                      "is " + in_digits(time.load_duration) +
                        " s, but the gravity step applies the full weight and "
                        "water at once",
                      "0, or Gravity/Initial stress = false");
    if (!time.move_points && mapping.strain == StrainMeasure::logarithmic)
      throw UserError("Time stepping/Move points",
                      "is false, but logarithmic strain is that of a body that "
                      "moves",
                      "true, or Kinematics and mapping/Strain = step");
  }
} // namespace Waker
