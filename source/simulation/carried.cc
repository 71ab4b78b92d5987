// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/deformation.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/simulation/carried.h>

namespace Waker
{
  template <int dim>
  Carried<dim>::Carried(const Case<dim> &the_case)
    : the_case(&the_case)
    , rides(scheme_traits(the_case.parameters.time).moves_points)
  {}


  template <int dim>
  std::size_t
  Carried<dim>::move(const BackgroundGrid<dim> &grid,
                     const std::vector<double> &mass,
                     const NodalVector         &increment,
                     MaterialPoints<dim>       &points,
                     State<dim>                &state) const
  {
    if (rides)
      for (std::vector<Point<dim>> &vertices : state.surface_vertices)
        carry_vertices(grid, mass, increment, vertices);
    return move_domains(the_case->parameters.mapping.domains,
                        the_case->grid.cell_size(),
                        points);
  }


  template class Carried<2>;
  template class Carried<3>;
} // namespace Waker
