// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/nodes/wall_spots.h>

#include <array>
#include <cmath>

namespace Waker
{
  template <int dim>
  unsigned int
  faces_along_walls(const BackgroundGrid<dim>         &grid,
                    const std::vector<WallParameters> &walls)
  {
    constexpr double            tolerance = 1e-6;
    const double                h         = grid.cell_size();
    std::array<double, 2 * dim> covered{}; // area, m^(dim-1)
    for (const WallParameters &wall : walls)
      {
        if (!wall.displacement.empty())
          continue;
        for (const WallSpot<dim> &spot :
             make_wall_spots<dim>(wall.line, h, "Walls/" + wall.name + "/Line"))
          for (unsigned int face = 0; face < 2 * dim; ++face)
            {
              const unsigned int d      = face / 2;
              const bool         upper  = face % 2 == 1;
              const double       inward = upper ? -1. : 1.;
              const double       place =
                (upper ? grid.upper_corner() : grid.lower_corner())[d];
              if (inward * spot.normal[d] > 1. - tolerance &&
                  std::abs(spot.x[d] - place) < tolerance * h)
                covered[face] += spot.area;
            }
      }
    unsigned int faces = 0;
    for (unsigned int face = 0; face < 2 * dim; ++face)
      {
        double area = 1.;
        for (unsigned int e = 0; e < dim; ++e)
          if (e != face / 2)
            area *= grid.upper_corner()[e] - grid.lower_corner()[e];
        if (covered[face] > (1. - tolerance) * area)
          faces |= 1u << face;
      }
    return faces;
  }


  template unsigned int
  faces_along_walls(const BackgroundGrid<2> &,
                    const std::vector<WallParameters> &);
  template unsigned int
  faces_along_walls(const BackgroundGrid<3> &,
                    const std::vector<WallParameters> &);
} // namespace Waker
