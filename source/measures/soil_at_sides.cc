// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/grid/background_grid.h>
#include <waker/measures/soil_at_sides.h>
#include <waker/particles/material_points.h>
#include <waker/particles/openings.h>

#include <cmath>

namespace Waker
{
  template <int dim>
  SoilAtSides<dim>
  soil_at_sides(const BackgroundGrid<dim> &grid,
                const MaterialPoints<dim> &points,
                const Openings<dim>       &openings)
  {
    const double     h = grid.cell_size();
    SoilAtSides<dim> result;
    double           volume = 0.;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        volume += points.volume[p];
        for (unsigned int d = 0; d < dim; ++d)
          {
            if (d == 1)
              continue;
            const double x     = points.position[p][d];
            const double x0    = points.initial_position[p][d];
            const double first = grid.lower_corner()[d] + h;
            const double last  = grid.upper_corner()[d] - h;
            int          face  = -1;
            if (x < first && x0 >= first)
              face = 2 * d;
            else if (x > last && x0 <= last)
              face = 2 * d + 1;
            if (face >= 0 && std::abs(x - x0) > 0.5 * h &&
                !openings.is_open(face, points.position[p]))
              {
                ++result.n_points[face];
                result.volume[face] += points.volume[p];
              }
          }
      }
    if (volume > 0.)
      for (unsigned int f = 0; f < 2 * dim; ++f)
        result.share[f] = result.volume[f] / volume;
    return result;
  }


  template <int dim>
  bool
  lies_against_side(const BackgroundGrid<dim> &grid,
                    const SoilAtSides<dim>    &soil)
  {
    // A little less than half a cell: volumes change under pressure.
    const double limit = 0.45 * std::pow(grid.cell_size(), dim);
    return soil.volume[0] > limit || soil.volume[1] > limit;
  }


  template SoilAtSides<2>
  soil_at_sides(const BackgroundGrid<2> &,
                const MaterialPoints<2> &,
                const Openings<2> &);
  template SoilAtSides<3>
  soil_at_sides(const BackgroundGrid<3> &,
                const MaterialPoints<3> &,
                const Openings<3> &);
  template bool
  lies_against_side(const BackgroundGrid<2> &, const SoilAtSides<2> &);
  template bool
  lies_against_side(const BackgroundGrid<3> &, const SoilAtSides<3> &);
} // namespace Waker
