// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/case/soil.h>

namespace Waker
{
  namespace
  {
    template <int dim>
    Point<dim>
    corner(const std::vector<double> &coordinates)
    {
      Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = coordinates[d];
      return x;
    }
  } // namespace


  template <int dim>
  BackgroundGrid<dim>
  make_grid(const GridParameters &parameters, const MPI_Comm communicator)
  {
    return BackgroundGrid<dim>(corner<dim>(parameters.lower_corner),
                               corner<dim>(parameters.upper_corner),
                               parameters.cell_size,
                               communicator);
  }


  template <int dim>
  MaterialPoints<dim>
  make_soil(const BackgroundGrid<dim> &grid,
            const Parameters          &parameters,
            const Materials           &materials,
            std::vector<unsigned int> *layers_of_points)
  {
    std::vector<std::string> names;
    std::vector<double>      densities;
    for (unsigned int m = 0; m < materials.size(); ++m)
      {
        names.push_back(
          m < parameters.materials.size() ? parameters.materials[m].name : "");
        densities.push_back(materials[m]->density());
      }
    return make_material_points(grid,
                                parameters.layers,
                                parameters.points,
                                names,
                                densities,
                                layers_of_points);
  }


  template BackgroundGrid<2>
  make_grid(const GridParameters &, const MPI_Comm);
  template BackgroundGrid<3>
  make_grid(const GridParameters &, const MPI_Comm);
  template MaterialPoints<2>
  make_soil(const BackgroundGrid<2> &,
            const Parameters &,
            const Materials &,
            std::vector<unsigned int> *);
  template MaterialPoints<3>
  make_soil(const BackgroundGrid<3> &,
            const Parameters &,
            const Materials &,
            std::vector<unsigned int> *);
} // namespace Waker
