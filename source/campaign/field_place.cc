// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/sizes.h>
#include <waker/campaign/field_place.h>
#include <waker/case/soil.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Waker
{
  namespace
  {
    template <int dim>
    FieldLattice
    make_lattice(const MaterialPoints<dim> &points,
                 const Parameters          &parameters,
                 const std::vector<double> &cell_size,
                 const std::string         &path)
    {
      FieldLattice lattice;
      lattice.dim = dim;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double size   = cell_size.empty()
                                  ? parameters.grid.cell_size /
                                    parameters.points.points_per_direction
                                  : cell_size[d];
          const double corner = parameters.grid.lower_corner[d];
          double       first  = std::numeric_limits<double>::max();
          double       last   = -first;
          for (const Point<dim> &x : points.initial_position)
            {
              const double cell = std::floor((x[d] - corner) / size);
              first             = std::min(first, cell);
              last              = std::max(last, cell);
            }
          lattice.cell_size[d] = size;
          lattice.origin[d]    = corner + first * size;
          lattice.n_cells[d]   = static_cast<unsigned int>(
            checked_count(path + "/Cell size",
                          last - first + 1.,
                          std::string("cells of the field along ") + "xyz"[d],
                          largest_lattice,
                          "larger cells"));
        }
      return lattice;
    }
  } // namespace


  template <int dim>
  FieldPlace<dim>::FieldPlace(const Case<dim> &the_case)
    : the_case(&the_case)
  {
    if (const auto &space = the_case.parameters.in_space)
      in_space = make_soil(make_grid<3>(space->grid, MPI_COMM_SELF),
                           *space,
                           the_case.materials);
  }


  template <int dim>
  FieldLattice
  FieldPlace<dim>::lattice(const std::vector<double> &cell_size,
                           const std::string         &path) const
  {
    const Parameters &parameters = the_case->parameters;
    return parameters.in_space
             ? make_lattice(in_space, *parameters.in_space, cell_size, path)
             : make_lattice(the_case->initial_points,
                            parameters,
                            cell_size,
                            path);
  }


  template <int dim>
  std::array<double, 3>
  field_coordinates(const Case<dim> &the_case, const Point<dim> &x)
  {
    std::array<double, 3> place = coordinates(x);
    if (const auto &space = the_case.parameters.in_space)
      {
        // On a line between two layers of cells it is the one above, which
        // round-off in z / h must not change: a millionth of a sub-cell.
        const double layer =
          space->grid.cell_size / space->points.points_per_direction;
        place[2] = the_case.parameters.section_z + 1e-6 * layer;
      }
    return place;
  }


  template std::array<double, 3>
  field_coordinates(const Case<2> &, const Point<2> &);
  template std::array<double, 3>
  field_coordinates(const Case<3> &, const Point<3> &);
  template class FieldPlace<2>;
  template class FieldPlace<3>;
} // namespace Waker
