// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/nodes/wall_spots.h>

#include <array>
#include <cmath>

namespace Waker
{
  namespace
  {
    constexpr double tolerance = 1e-6; // of a cell


    template <int dim>
    std::vector<WallSpot<dim>>
    spots_of(const BackgroundGrid<dim> &grid, const WallParameters &wall)
    {
      return make_wall_spots<dim>(wall.line,
                                  size_of_wall_spots(grid),
                                  "Walls/" + wall.name + "/Line");
    }
  } // namespace


  template <int dim>
  WallFaces<dim>
  faces_along_walls(const BackgroundGrid<dim>         &grid,
                    const std::vector<WallParameters> &walls)
  {
    const double                h = grid.cell_size();
    WallFaces<dim>              result;
    std::array<double, 2 * dim> covered{}; // area, m^(dim-1)
    for (const WallParameters &wall : walls)
      {
        if (!wall.displacement.empty())
          continue;
        for (const WallSpot<dim> &spot : spots_of(grid, wall))
          for (unsigned int face = 0; face < 2 * dim; ++face)
            {
              const unsigned int d      = face / 2;
              const bool         upper  = face % 2 == 1;
              const double       inward = upper ? -1. : 1.;
              const double       place =
                (upper ? grid.upper_corner() : grid.lower_corner())[d];
              const double setback = inward * (spot.x[d] - place);
              if (inward * spot.normal[d] < 1. - tolerance ||
                  setback < -tolerance * h || setback > (1. - tolerance) * h)
                continue;
              if (covered[face] == 0.)
                result.setback[face] = setback < tolerance * h ? 0. : setback;
              if (std::abs(setback - result.setback[face]) < tolerance * h)
                covered[face] += spot.area;
            }
      }
    for (unsigned int face = 0; face < 2 * dim; ++face)
      {
        double area = 1.;
        for (unsigned int e = 0; e < dim; ++e)
          if (e != face / 2)
            area *= grid.upper_corner()[e] - grid.lower_corner()[e];
        if (covered[face] > (1. - tolerance) * area)
          result.closed |= 1u << face;
        else
          result.setback[face] = 0.;
      }
    return result;
  }


  template <int dim>
  bool
  is_along_grid_line(const BackgroundGrid<dim> &grid,
                     const WallParameters      &wall)
  {
    for (const WallSpot<dim> &spot : spots_of(grid, wall))
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double cells =
            (spot.x[d] - grid.origin()[d]) * grid.inverse_cell_size();
          if (std::abs(spot.normal[d]) > 1. - tolerance &&
              std::abs(cells - std::round(cells)) < tolerance)
            return true;
        }
    return false;
  }


  template WallFaces<2>
  faces_along_walls(const BackgroundGrid<2> &,
                    const std::vector<WallParameters> &);
  template WallFaces<3>
  faces_along_walls(const BackgroundGrid<3> &,
                    const std::vector<WallParameters> &);
  template bool
  is_along_grid_line(const BackgroundGrid<2> &, const WallParameters &);
  template bool
  is_along_grid_line(const BackgroundGrid<3> &, const WallParameters &);
} // namespace Waker
