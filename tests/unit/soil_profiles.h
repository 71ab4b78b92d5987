// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_soil_profiles_h
#define waker_tests_soil_profiles_h

#include <deal.II/base/mpi.h>

#include <waker/base/errors.h>
#include <waker/particles/soil_profile.h>

namespace Waker::SoilProfiles
{
  const std::vector<std::string> names     = {"clay", "sand"};
  const std::vector<double>      densities = {15. / 9.81, 2.};
  const std::string              dyke      = "0,0; 30,0; 15,5; 5,5";

  inline LayerParameters
  layer(const std::string &polygon, const std::string &material = "clay")
  {
    LayerParameters l;
    l.name     = "layer";
    l.material = material;
    l.polygon  = polygon;
    return l;
  }

  inline BackgroundGrid<2>
  dyke_grid(const double left = -6., const double right = 42.)
  {
    return BackgroundGrid<2>(Point<2>(left, 0.),
                             Point<2>(right, 6.),
                             0.25,
                             MPI_COMM_SELF);
  }

  template <int dim>
  MaterialPoints<dim>
  make(const BackgroundGrid<dim>          &grid,
       const std::vector<LayerParameters> &layers,
       const double                        minimum_cut = 0.25,
       const unsigned int                  n           = 2)
  {
    MaterialPointParameters parameters;
    parameters.minimum_cut          = minimum_cut;
    parameters.points_per_direction = n;
    return make_material_points(grid, layers, parameters, names, densities);
  }

  /// The path of the error that making the points throws, "" if none.
  template <int dim>
  std::string
  where_it_fails(const BackgroundGrid<dim>          &grid,
                 const std::vector<LayerParameters> &layers)
  {
    try
      {
        make(grid, layers);
      }
    catch (const UserError &e)
      {
        return e.where;
      }
    return "";
  }
} // namespace Waker::SoilProfiles

#endif
