// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/case/case.h>

namespace Waker
{
  template <int dim>
  Crest<dim>
  initial_crest(const Case<dim> &the_case)
  {
    const Parameters           &parameters = the_case.parameters;
    const std::optional<double> edge       = parameters.sliding.given_edge();
    const Crest<dim>            crest(the_case.initial_points,
                           parameters.water.inner_direction(),
                           edge);
    // The drawn edge may lie beyond the points that fill the slope.
    const double h = the_case.grid.cell_size();
    if (edge &&
        !(*edge > crest.lowest_x() - h && *edge < crest.highest_x() + h))
      throw UserError("Sliding masses/Crest edge",
                      "is " + in_digits(*edge) + " m, but the crest reaches " +
                        "from x = " + in_digits(crest.lowest_x()) + " to " +
                        in_digits(crest.highest_x()) + " m",
                      "a place on the crest, or less than a cell beyond it; or "
                      "detected");
    return crest;
  }


  template Crest<2>
  initial_crest(const Case<2> &);
  template Crest<3>
  initial_crest(const Case<3> &);
} // namespace Waker
