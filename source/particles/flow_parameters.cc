// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/errors.h>
#include <waker/base/text.h>
#include <waker/particles/flow_parameters.h>

namespace Waker
{
  using namespace dealii;

  void
  OutflowParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Faces",
                      faces,
                      "Faces of the grid's box through which soil leaves: "
                      "left, right, bottom, top, back, front, separated by "
                      "commas. Points beyond them are removed and counted. "
                      "Empty: none.",
                      Patterns::Anything());
  }


  std::vector<bool>
  OutflowParameters::open_faces(const unsigned int dim) const
  {
    return std::vector<bool>(2 * dim, false);
  }


  void
  InflowParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Face",
                      face,
                      "Face of the grid's box through which soil enters.",
                      Patterns::Selection("left|right|bottom|top|back|front"));
    prm.add_parameter("Material",
                      material,
                      "Material that enters: one of Materials/Names.",
                      Patterns::Anything());
    prm.add_parameter("From",
                      from,
                      "The opening reaches from From to To (m), along the "
                      "face's own directions; what is given in the normal one "
                      "does not count. Empty: the whole face.",
                      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter("To",
                      to,
                      "Upper corner of the opening (m).",
                      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter("Velocity",
                      velocity,
                      "Velocity of the soil into the box (m/s), above 0.",
                      Patterns::Double(0.));
  }


  void
  InflowParameters::check(const unsigned int dim) const
  {
    (void)dim;
  }
} // namespace Waker
