// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/particles/openings.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  template <int dim>
  Opening<dim>
  place_opening(const BackgroundGrid<dim> &grid,
                const OpeningParameters   &parameters,
                const std::string         &path)
  {
    const double       h         = grid.cell_size();
    const unsigned int face      = parameters.face_number();
    const unsigned int direction = face / 2;
    Opening<dim>       opening{face, grid.lower_corner(), grid.upper_corner()};
    for (unsigned int d = 0; d < dim; ++d)
      if (d != direction)
        for (const bool is_upper : {false, true})
          {
            const auto &limit = is_upper ? parameters.to : parameters.from;
            Point<dim> &x     = is_upper ? opening.upper : opening.lower;
            if (limit.empty())
              continue;
            const double cells =
              (limit[d] - grid.lower_corner()[d]) * grid.inverse_cell_size();
            if (std::abs(cells - std::round(cells)) > 1e-6 ||
                limit[d] < grid.lower_corner()[d] - 1e-6 * h ||
                limit[d] > grid.upper_corner()[d] + 1e-6 * h)
              throw UserError(path + (is_upper ? "/To" : "/From"),
                              "the opening ends at " + in_digits(limit[d]) +
                                " m in direction " + std::string(1, "xyz"[d]),
                              "lines of the grid, " +
                                in_digits(grid.lower_corner()[d]) + " to " +
                                in_digits(grid.upper_corner()[d]) +
                                " m in steps of " + in_digits(h));
            x[d] = grid.lower_corner()[d] + std::round(cells) * h;
          }
    for (unsigned int d = 0; d < dim; ++d)
      if (d != direction && !(opening.lower[d] < opening.upper[d]))
        throw UserError(path + "/To",
                        "the opening is empty in direction " +
                          std::string(1, "xyz"[d]),
                        "larger numbers than in From");
    (face % 2 == 0 ? opening.upper : opening.lower)[direction] =
      (face % 2 == 0 ? opening.lower : opening.upper)[direction];
    return opening;
  }


  template <int dim>
  bool
  Openings<dim>::holds(const Opening<dim> &opening, const Point<dim> &x) const
  {
    const double round_off = 1e-6 * grid->cell_size();
    for (unsigned int d = 0; d < dim; ++d)
      if (d != opening.face / 2 &&
          ((x[d] < opening.lower[d] &&
            opening.lower[d] > grid->lower_corner()[d] + round_off) ||
           (x[d] > opening.upper[d] &&
            opening.upper[d] < grid->upper_corner()[d] - round_off)))
        return false;
    return true;
  }


  template <int dim>
  bool
  Openings<dim>::is_open(const unsigned int face, const Point<dim> &x) const
  {
    for (const Opening<dim> &opening : list)
      if (opening.face == face && holds(opening, x))
        return true;
    return false;
  }


  template <int dim>
  bool
  Openings<dim>::meets(const Opening<dim> &other) const
  {
    for (const Opening<dim> &opening : list)
      {
        bool common = opening.face == other.face;
        for (unsigned int d = 0; d < dim && common; ++d)
          common = d == opening.face / 2 ||
                   std::min(opening.upper[d], other.upper[d]) -
                       std::max(opening.lower[d], other.lower[d]) >
                     1e-6 * grid->cell_size();
        if (common)
          return true;
      }
    return false;
  }


  template <int dim>
  bool
  Openings<dim>::is_passed_by(const Point<dim> &x) const
  {
    for (const Opening<dim> &opening : list)
      {
        const unsigned int d         = opening.face / 2;
        const bool         is_beyond = opening.face % 2 == 0
                                         ? x[d] < grid->lower_corner()[d]
                                         : x[d] > grid->upper_corner()[d];
        if (is_beyond && holds(opening, x))
          return true;
      }
    return false;
  }


  template Opening<2>
  place_opening(const BackgroundGrid<2> &,
                const OpeningParameters &,
                const std::string &);
  template Opening<3>
  place_opening(const BackgroundGrid<3> &,
                const OpeningParameters &,
                const std::string &);
  template class Openings<2>;
  template class Openings<3>;
} // namespace Waker
