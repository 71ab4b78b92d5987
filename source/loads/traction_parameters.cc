// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/expression.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/base/time_function.h>
#include <waker/loads/quick_loads.h>
#include <waker/loads/traction.h>
#include <waker/loads/traction_parameters.h>

#include <string>

namespace Waker
{
  MethodFacts
  facts_of(const TractionMethod method)
  {
    MethodFacts facts;
    switch (method)
      {
        case TractionMethod::fixed_points:
          facts.on_points = facts.is_fixed = true;
          return facts;
        case TractionMethod::updated_points:
          facts.on_points = true;
          return facts;
        case TractionMethod::surface_nodes:
          return facts;
        case TractionMethod::proximity_field:
        case TractionMethod::contour:
          facts.can_ride = true;
          return facts;
        case TractionMethod::user_surface:
          facts.can_ride = facts.needs_file = true;
          return facts;
        case TractionMethod::volume:
          facts.needs_linear = true;
          return facts;
      }
    AssertThrow(false, ExcInternalError());
    return facts;
  }


  namespace
  {
    /// The methods of which these facts are true.
    template <typename Condition>
    std::string
    methods_that(const Condition &holds)
    {
      std::vector<std::string> names;
      for (const TractionMethod method : all_choices<TractionMethod>())
        if (holds(facts_of(method)))
          names.emplace_back(name_of(method));
      return either(names);
    }


    bool
    may_have_file(const MethodFacts &facts)
    {
      return facts.needs_file || facts.on_points;
    }


    bool
    can_go_with_soil(const MethodFacts &facts)
    {
      return facts.can_ride || facts.is_fixed;
    }
  } // namespace


  bool
  TractionParameters::rides() const
  {
    if (!facts_of(method).can_ride)
      return false; // fixed points do by themselves
    return follows == TractionFollows::soil ||
           (follows == TractionFollows::automatic && !from.empty() &&
            kind != TractionKind::hydrostatic);
  }


  bool
  TractionParameters::goes_with_soil() const
  {
    return rides() || facts_of(method).is_fixed;
  }


  bool
  TractionParameters::has_user_surface() const
  {
    const MethodFacts facts = facts_of(method);
    return facts.needs_file || (may_have_file(facts) && !surface_file.empty());
  }


  void
  TractionParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(
      prm,
      "Method",
      method,
      "Where the traction acts. fixed points, updated points: as equivalent "
      "loads of the points nearest to the surface, chosen at the start or in "
      "every step. surface nodes: between active and inactive cells. proximity "
      "field: on the detected surface. user surface: on a surface of the "
      "user's that moves with the material. volume: at the volume that the "
      "points have in each cell (linear functions, bodies along the grid). "
      "contour: on the outline of the support domains (GIMP).");
    prm.add_parameter("Surface file",
                      surface_file,
                      "The user's surface: in 2D a text file with x, y (m) of "
                      "a vertex per line, the soil on the left, an empty line "
                      "between chains; in 3D an STL file. For the points "
                      "methods it may be the surface that the loads stand for; "
                      "empty: the outline of the support domains.",
                      Patterns::FileName(Patterns::FileName::input));
    add_choice(prm,
               "Kind",
               kind,
               "vector: a constant direction. pressure: against the "
               "outward normal. hydrostatic: a pressure that grows with "
               "the depth below a level.");
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
    add_choice(
      prm,
      "Follows",
      follows,
      "What carries the load once the soil moves. soil: the part that From, To "
      "and Facing select at the start, wherever it goes; a vector keeps its "
      "resultant, a pressure turns and stretches with the soil. space: what "
      "they select now; soil that leaves the box loses its load. automatic: "
      "soil for a vector or pressure in a box, if Method is " +
        methods_that([](const MethodFacts &facts) { return facts.can_ride; }) +
        "; otherwise space. Fixed points carry their loads themselves.");
    prm.add_parameter("Holes",
                      holes,
                      "proximity field and contour: load the holes inside a "
                      "body, too. A liquid that stands outside does not reach "
                      "them.",
                      Patterns::Bool());
    prm.add_parameter("Minimum support",
                      minimum_support,
                      "A node carries load only if its mass is at least this "
                      "share of a full node's; its load otherwise goes to "
                      "nodes nearby that do, with the same resultant and "
                      "moment. 0: none hands on its load; what falls on nodes "
                      "without mass is lost.",
                      Patterns::Double(0., 0.5));
    prm.add_parameter(
      "Consolidation",
      consolidation,
      "For a load that the soil has not consolidated under, such as traffic: "
      "the share (-) of its vertical stress at t = 0 that the grains have "
      "taken over, a number for all layers or \"layer: degree, ...\", 1 in "
      "those that are not named. Below the phreatic line the rest is in the "
      "water (pore pressure of loads), and stays with the soil; it counts in "
      "vertical_stress (Materials/<name>/Strength from). Needs a box, a number "
      "as Value, and a phreatic line. Empty: the load is only a force.",
      Patterns::Anything());
    prm.add_parameter("Spread",
                      spread,
                      "With Consolidation: the angle to the vertical (degrees) "
                      "at which the load spreads in the ground, 0 to 80.",
                      Patterns::Double(0., 80.));
  }


  void
  TractionParameters::check(const unsigned int   dim,
                            const ShapeFunctions functions) const
  {
    const std::string path    = "Tractions/" + name + "/";
    const auto        require = [&](const std::string         &entry,
                             const std::vector<double> &values) {
      if (values.size() != dim)
        throw UserError(path + entry,
                        "has " + counted(values.size(), "number"),
                        std::to_string(dim) +
                          " numbers (Dimension = " + std::to_string(dim) +
                          "), or nothing" + decimals_with_a_point);
    };
    const MethodFacts facts = facts_of(method);
    if (facts.needs_linear && functions != ShapeFunctions::linear)
      throw UserError(path + "Method",
                      "is " + std::string(name_of(method)) +
                        ", which fits the internal force of linear "
                        "functions, but Kinematics and mapping/Functions is " +
                        std::string(name_of(functions)),
                      "contour (which with GIMP is what volume is without), "
                      "or Kinematics and mapping/Functions = linear");
    if (facts.needs_file && surface_file.empty())
      throw UserError(path + "Surface file",
                      "is empty, but Method is " + std::string(name_of(method)),
                      "the file with the surface that is loaded");
    if (!surface_file.empty() && !may_have_file(facts))
      throw UserError(path + "Surface file",
                      "is given, but the method \"" +
                        std::string(name_of(method)) +
                        "\" finds its surface by itself",
                      "nothing, or Method = " + methods_that(may_have_file));
    if (kind == TractionKind::hydrostatic && tidy(level).empty())
      throw UserError(path + "Level",
                      "is empty, but Kind is hydrostatic",
                      "a number, an expression of t (s), or a table \"t0: y0, "
                      "t1: y1, ...\"");

    if (from.empty() != to.empty())
      throw UserError(path + (from.empty() ? "From" : "To"),
                      "is empty",
                      "both corners of the box, or neither");
    if (!from.empty())
      {
        require("From", from);
        require("To", to);
        for (unsigned int d = 0; d < dim; ++d)
          if (!(from[d] <= to[d]))
            throw UserError(path + "To",
                            "lies below From in direction " +
                              std::string(1, "xyz"[d]),
                            "a box from its lower to its upper corner");
      }
    if (!facing.empty())
      {
        require("Facing", facing);
        double square = 0.;
        for (const double component : facing)
          square += component * component;
        if (!(square > 0.))
          throw UserError(path + "Facing",
                          "has no direction",
                          "a vector that is not zero, or nothing");
      }
    if (follows == TractionFollows::soil && kind == TractionKind::hydrostatic)
      throw UserError(path + "Follows",
                      "is soil, but Kind is hydrostatic: a liquid stays where "
                      "it stands",
                      "space or automatic; or Kind = pressure");
    if (follows == TractionFollows::soil && !can_go_with_soil(facts))
      throw UserError(path + "Follows",
                      "is soil, but the method \"" +
                        std::string(name_of(method)) +
                        "\" finds its surface anew in every step",
                      "space or automatic; or Method = " +
                        methods_that(can_go_with_soil));
    if (follows == TractionFollows::space && facts.is_fixed)
      throw UserError(path + "Follows",
                      "is space, but " + std::string(name_of(method)) +
                        " carry their loads with them",
                      "soil or automatic; or Method = " +
                        methods_that([](const MethodFacts &other) {
                          return other.on_points && !other.is_fixed;
                        }));
    if (!tidy(consolidation).empty())
      quick_pressure(*this, dim);
    // Can its values be read, also those of another kind?
    if (!tidy(level).empty())
      TimeFunction(level, path + "Level");
    if (kind == TractionKind::hydrostatic)
      for (const std::string &part : split(value, ';'))
        {
          if (dim == 2)
            Expression<2>(part, path + "Value");
          else
            Expression<3>(part, path + "Value");
        }
    if (dim == 2)
      Traction<2>(*this, 0.);
    else
      Traction<3>(*this, 0.);
  }
} // namespace Waker
