// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/particles/flow_parameters.h>

namespace Waker
{
  namespace
  {
    std::string
    faces_of(const unsigned int dim)
    {
      std::string list;
      for (unsigned int f = 0; f < 2 * dim; ++f)
        list += (f > 0 ? ", " : "") + std::string(name_of(BoxFace(f)));
      return list;
    }
  } // namespace


  void
  OutflowParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Faces",
                      faces,
                      "Faces of the grid's box through which soil leaves: "
                      "left, right, bottom, top, back, front, separated by "
                      "commas. Points beyond them are removed and counted. "
                      "Empty: none (but see Names).",
                      Patterns::Anything());
  }


  std::vector<bool>
  OutflowParameters::open_faces(const unsigned int dim) const
  {
    std::vector<bool> open(2 * dim, false);
    for (const std::string &face : split(faces, ','))
      {
        const auto         known = find_choice<BoxFace>(face);
        const unsigned int f = known ? static_cast<unsigned int>(*known) : 6;
        if (f >= 2 * dim)
          throw UserError("Outflow/Faces",
                          "there is no face \"" + face + "\" in " +
                            std::to_string(dim) + "D",
                          faces_of(dim) + ", separated by commas");
        open[f] = true;
      }
    return open;
  }


  void
  OpeningParameters::add_opening_parameters(ParameterHandler  &prm,
                                            const std::string &purpose)
  {
    add_choice(prm, "Face", face, "Face of the grid's box " + purpose);
    prm.add_parameter("From",
                      from,
                      "The opening reaches from From to To (m), along the "
                      "face's own directions, a whole number of cells; what is "
                      "given in the normal one does not count. Empty: the "
                      "whole face.",
                      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter("To",
                      to,
                      "Upper corner of the opening (m).",
                      Patterns::List(Patterns::Double(), 0, 3));
  }


  void
  OpeningParameters::check_opening(const std::string &section,
                                   const unsigned int dim) const
  {
    const std::string path = section + "/" + name + "/";
    if (face_number() >= 2 * dim)
      throw UserError(path + "Face",
                      "there is no face \"" + std::string(name_of(face)) +
                        "\" in " + std::to_string(dim) + "D",
                      faces_of(dim));
    for (const auto *limit : {&from, &to})
      if (!limit->empty() && limit->size() != dim)
        throw UserError(path + (limit == &from ? "From" : "To"),
                        "has " + counted(limit->size(), "number"),
                        std::to_string(dim) + " numbers, or nothing" +
                          decimals_with_a_point);
    if (!from.empty() && !to.empty())
      for (unsigned int d = 0; d < dim; ++d)
        if (d != face_number() / 2 && !(from[d] < to[d]))
          throw UserError(path + "To",
                          "the opening is empty in direction " +
                            std::string(1, "xyz"[d]),
                          "larger numbers than in From");
  }


  void
  OutletParameters::add_parameters(ParameterHandler &prm)
  {
    add_opening_parameters(prm,
                           "in a part of which soil leaves, as through "
                           "Faces.");
  }


  void
  OutletParameters::check(const unsigned int dim) const
  {
    check_opening("Outflow", dim);
  }


  void
  InflowParameters::add_parameters(ParameterHandler &prm)
  {
    add_opening_parameters(prm,
                           "through which soil enters, pushed by its nodes "
                           "and free of stress.");
    prm.add_parameter("Material",
                      material,
                      "Material that enters: one of Materials/Names.",
                      Patterns::Anything());
    prm.add_parameter("Velocity",
                      velocity,
                      "Velocity of the soil into the box (m/s), above 0.",
                      Patterns::Double(0.));
  }


  void
  InflowParameters::check(const unsigned int dim) const
  {
    check_opening("Inflow", dim);
    require_positive("Inflow/" + name + "/Velocity", velocity, "m/s");
  }
} // namespace Waker
