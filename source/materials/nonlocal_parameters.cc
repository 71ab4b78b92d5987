// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/materials/factory.h>

namespace Waker
{
  void
  NonlocalParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Averaging length",
      length,
      "Length l (m) of nonlocal softening, at least the distance between "
      "points; 1.5 to 3 of them regularise. Points soften by the plastic strain "
      "e* = (1 - n) e + n <e>, with <e> its average over the points of their "
      "material that are nearer than 2.5 l, with their volumes and the weight. "
      "Slip surfaces are a few l wide whatever the cells. Not used with "
      "Regularisation = softening length.",
      Patterns::Double(0.));
    prm.add_parameter(
      "Over-weight",
      over_weight,
      "n of nonlocal softening, from 1 to 10: the share of the average. 2 is "
      "usual; with 1 bands are still a few points wide.",
      Patterns::Double(1., 10.));
    add_choice(prm,
               "Neighbour weight",
               weight,
               "How much points at a distance r count in the average. "
               "Galavi-Schweiger: r/l exp(-(r/l)^2), most at 0.7 l and a point "
               "itself not at all. Gaussian: exp(-(r/l)^2).");
  }


  void
  NonlocalParameters::check(const std::string &path) const
  {
    if (!(length >= 0. && length <= 1e6))
      throw UserError(path + "Averaging length",
                      "is " + in_digits(length) + " m",
                      "a length (m) above 0 and at most 1e6");
    if (!(over_weight >= 1. && over_weight <= 10.))
      throw UserError(path + "Over-weight",
                      "is " + in_digits(over_weight),
                      "from 1 to 10; 2 is usual");
  }


  void
  NonlocalParameters::check_used(const std::string &path,
                                 const double       spacing,
                                 const double       longest) const
  {
    if (length > longest)
      throw UserError(path + "Averaging length",
                      "is " + in_digits(length) +
                        " m, longer than the grid, so that all soil softens "
                        "as one",
                      "at most the grid's longest side, " + in_digits(longest) +
                        " m; better a few distances between points");
    if (!(length >= (1. - 1e-9) * spacing))
      throw UserError(path + "Averaging length",
                      "is " + in_digits(length) +
                        " m: with Regularisation = nonlocal, points have no "
                        "neighbours within it, and nothing is regularised",
                      "at least the distance between points, " +
                        in_digits(spacing) + " m; better twice that");
  }
} // namespace Waker
