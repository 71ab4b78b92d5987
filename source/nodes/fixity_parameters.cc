// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <waker/base/checks.h>
#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/nodes/fixities.h>

#include <algorithm>
#include <sstream>

namespace Waker
{
  void
  FixityParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Region",
               region,
               "The nodes to hold: a face of the grid's box, with the "
               "margin beyond it, or \"box\": the nodes in From, To.");
    prm.add_parameter("From",
                      from,
                      "Lower limits of the region (m), one per direction. "
                      "Normal to a face there is no limit. Empty: no limit.",
                      Patterns::List(Patterns::Double()));
    prm.add_parameter("To",
                      to,
                      "Upper limits of the region (m), as From.",
                      Patterns::List(Patterns::Double()));
    add_choice(prm,
               "Type",
               type,
               "What is held: fixed = all components, roller = the one "
               "normal to the face, prescribed = those of Displacement. Where "
               "two conditions hold a node in the same direction, elimination "
               "counts before penalty, and then the later one in Names.");
    prm.add_parameter(
      "Displacement",
      displacement,
      "For Type prescribed: per component the displacement "
      "since t = 0 (m), an expression of x, y, z (m) and t (s), "
      "or free; for example \"0.1*t; free\".",
      Patterns::Anything());
    add_choice(prm,
               "Method",
               method,
               "elimination removes the equations, penalty adds stiff "
               "springs.");
    prm.add_parameter(
      "Penalty factor",
      penalty_factor,
      "Stiffness of a node's spring (no unit), 1e-6 to 1e8, as a "
      "multiple of (K + 4G/3) h^(dim-2).",
      Patterns::Double(0.));
  }


  namespace
  {
    std::string
    text(const double number)
    {
      std::ostringstream s;
      s << number;
      return s.str();
    }
  } // namespace


  std::vector<std::optional<std::string>>
  FixityParameters::expressions() const
  {
    std::vector<std::optional<std::string>> of_component;
    for (std::string &part : Utilities::split_string_list(displacement, ';'))
      if (part == "free")
        of_component.emplace_back();
      else
        of_component.emplace_back(std::move(part));
    return of_component;
  }


  bool
  FixityParameters::holds(const unsigned int component) const
  {
    switch (type)
      {
        case FixityType::fixed:
          return true;
        case FixityType::roller:
          // A face: two of each direction.
          return static_cast<unsigned int>(region) / 2 == component;
        case FixityType::prescribed:
          return expressions().at(component).has_value();
      }
    return false;
  }


  void
  FixityParameters::check(const unsigned int dim) const
  {
    const std::string path   = "Boundary conditions/" + name + "/";
    const bool        is_box = region == FixityRegion::box;
    if (!is_box && static_cast<unsigned int>(region) >= 2 * dim)
      {
        std::string allowed;
        for (unsigned int f = 0; f < 2 * dim; ++f)
          allowed += std::string(name_of(static_cast<BoxFace>(f))) + ", ";
        throw UserError(path + "Region",
                        "is \"" + std::string(name_of(region)) + "\"",
                        allowed + name_of(FixityRegion::box));
      }
    if (is_box && type == FixityType::roller) // a box has no normal
      throw UserError(path + "Type",
                      "is \"" + std::string(name_of(type)) + "\"",
                      std::string(name_of(FixityType::fixed)) + ", " +
                        name_of(FixityType::prescribed));

    const std::string per_direction =
      std::to_string(dim) + " numbers in " + std::to_string(dim) + "D" +
      (is_box ? "" : ", or nothing") + decimals_with_a_point;
    for (const auto *limit : {&from, &to})
      if (limit->size() != dim && !(limit->empty() && !is_box))
        throw UserError(path + (limit == &from ? "From" : "To"),
                        "has " + counted(limit->size(), "number"),
                        per_direction);
    if (!from.empty() && !to.empty())
      for (unsigned int d = 0; d < dim; ++d)
        if (!(from[d] <= to[d]))
          throw UserError(path + "To",
                          "is " + text(to[d]) + " m in direction " +
                            std::to_string(d + 1) + ", below From with " +
                            text(from[d]) + " m",
                          "limits not below those of From");

    require_between(path + "Penalty factor", penalty_factor, 1e-6, 1e8);

    const auto        prescribed = expressions();
    const std::string allowed = std::to_string(dim) + " expressions of x, y, " +
                                (dim == 3 ? "z, " : "") +
                                "t, or \"free\", with \";\" between them";
    if (type != FixityType::prescribed)
      {
        if (!displacement.empty())
          throw UserError(path + "Displacement",
                          "is \"" + displacement + "\", but Type is " +
                            name_of(type),
                          "nothing, or Type prescribed");
        return;
      }
    if (prescribed.size() != dim ||
        std::count(prescribed.begin(), prescribed.end(), "") != 0)
      throw UserError(path + "Displacement",
                      "is \"" + displacement + "\"",
                      allowed);
    if (std::count(prescribed.begin(), prescribed.end(), std::nullopt) ==
        static_cast<int>(dim))
      throw UserError(path + "Displacement",
                      "leaves all components free",
                      "at least one expression");
  }
} // namespace Waker
