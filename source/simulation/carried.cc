// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/deformation.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/simulation/carried.h>

namespace Waker
{
  namespace
  {
    /// Of a node inside the body: nodes that have less move by themselves.
    /// Those of a slide go as far as their surroundings from a share of 1e-5
    /// on, and ten times as far at 1e-6.
    constexpr double carrying_share = 1e-4;
  } // namespace


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
        carry_vertices(grid,
                       mass,
                       carrying_share * the_case->full_node_mass,
                       increment,
                       vertices);
    return move_domains(the_case->parameters.mapping.domains,
                        the_case->grid.cell_size(),
                        points);
  }


  template class Carried<2>;
  template class Carried<3>;
} // namespace Waker
