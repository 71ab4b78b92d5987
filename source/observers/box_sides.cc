// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/observers/box_sides.h>

#include <cmath>

namespace Waker
{
  template <int dim>
  std::array<double, 2>
  soil_come_to_sides(const BackgroundGrid<dim> &grid,
                     const MaterialPoints<dim> &points)
  {
    const double          h     = grid.cell_size();
    const double          lower = grid.lower_corner()[0] + h;
    const double          upper = grid.upper_corner()[0] - h;
    std::array<double, 2> volume{{0., 0.}};
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const double now   = points.position[p][0];
        const double start = points.initial_position[p][0];
        if (!(std::abs(now - start) > 0.5 * h))
          continue;
        if (now < lower && start >= lower)
          volume[0] += points.volume[p];
        if (now > upper && start <= upper)
          volume[1] += points.volume[p];
      }
    return volume;
  }


  template <int dim>
  bool
  soil_lies_against_side(const BackgroundGrid<dim> &grid,
                         const MaterialPoints<dim> &points,
                         const std::vector<bool>   &open_faces)
  {
    AssertDimension(open_faces.size(), 2 * dim);
    // A little less than half a cell: volumes change under pressure.
    const double                limit  = 0.45 * std::pow(grid.cell_size(), dim);
    const std::array<double, 2> volume = soil_come_to_sides(grid, points);
    return (!open_faces[0] && volume[0] > limit) ||
           (!open_faces[1] && volume[1] > limit);
  }


  template std::array<double, 2>
  soil_come_to_sides(const BackgroundGrid<2> &, const MaterialPoints<2> &);
  template std::array<double, 2>
  soil_come_to_sides(const BackgroundGrid<3> &, const MaterialPoints<3> &);
  template bool
  soil_lies_against_side(const BackgroundGrid<2> &,
                         const MaterialPoints<2> &,
                         const std::vector<bool> &);
  template bool
  soil_lies_against_side(const BackgroundGrid<3> &,
                         const MaterialPoints<3> &,
                         const std::vector<bool> &);
} // namespace Waker
