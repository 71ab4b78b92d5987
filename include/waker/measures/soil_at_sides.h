// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_measures_soil_at_sides_h
#define waker_measures_soil_at_sides_h

#include <array>
#include <cstddef>

namespace Waker
{
  template <int dim>
  class BackgroundGrid;
  template <int dim>
  struct MaterialPoints;
  template <int dim>
  class Openings;

  /**
   * Soil that has come to the end of the box: points in its last row of cells
   * (or beyond, in the margin) at a side face that began further inside, and
   * have moved by more than half a cell: a foundation that reaches the side
   * from the beginning is not meant, nor what it strains. From there on the box
   * may hold back what would slide on.
   *
   * Faces are numbered as deal.II does (left, right, then z = lower, upper in
   * 3D as 4 and 5); those of y (2 and 3), base and sky, stay 0.
   */
  template <int dim>
  struct SoilAtSides
  {
    std::array<std::size_t, 2 * dim> n_points{}; // at each face
    std::array<double, 2 * dim>      volume{};   // m^dim
    std::array<double, 2 * dim>      share{};    // of all volume, 0 to 1

    /// The face with the largest share; -1 if nothing has come to any.
    int
    worst_face() const
    {
      int worst = -1;
      for (unsigned int f = 0; f < 2 * dim; ++f)
        if (n_points[f] > 0 && (worst < 0 || share[f] > share[worst]))
          worst = f;
      return worst;
    }
  };

  /// @param openings what is on its way through one of them does not count
  template <int dim>
  SoilAtSides<dim>
  soil_at_sides(const BackgroundGrid<dim> &grid,
                const MaterialPoints<dim> &points,
                const Openings<dim>       &openings);

  /// Has so much soil come to the left or right side that the box holds it?
  /// That is half a cell's volume of it: one row of points of the usual two.
  template <int dim>
  bool
  lies_against_side(const BackgroundGrid<dim> &grid,
                    const SoilAtSides<dim>    &soil);
} // namespace Waker

#endif
