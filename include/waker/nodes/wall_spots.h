// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_wall_spots_h
#define waker_nodes_wall_spots_h

#include <deal.II/base/point.h>

#include <waker/grid/background_grid.h>
#include <waker/nodes/wall_parameters.h>

#include <array>
#include <string>
#include <vector>

namespace Waker
{
  using namespace dealii;

  /// A small piece of a wall.
  template <int dim>
  struct WallSpot
  {
    Point<dim>     x;      // its centroid, m
    Tensor<1, dim> normal; // unit vector into the soil
    double         area;   // m^(dim-1)
  };

  /**
   * Cut a wall into pieces: a line (2D) into equal parts of each segment, a
   * flat polygon (3D) by a lattice in its plane.
   *
   * @param line corners "x1, y1; x2, y2; ..." (m), see WallParameters::line
   * @param size largest length of a piece (m); in 3D of the lattice's squares
   * @param path of the parameter, for the error
   * @throws UserError not numbers, too few corners, no length, not flat, edges
   *         that cross
   */
  template <int dim>
  std::vector<WallSpot<dim>>
  make_wall_spots(const std::string &line,
                  const double       size,
                  const std::string &path);

  /// Largest length of a piece (m), of which a cell has four along its side,
  /// wherever a wall is cut.
  template <int dim>
  double
  size_of_wall_spots(const BackgroundGrid<dim> &grid)
  {
    return 0.25 * grid.cell_size();
  }


  /// Faces of the grid's box that walls close.
  template <int dim>
  struct WallFaces
  {
    /// Bit 2d for the lower, 2d + 1 for the upper face in direction d, as
    /// Fixities::closed_faces().
    unsigned int closed = 0;
    /// How far inside each of them the wall is (m), less than a cell.
    std::array<double, 2 * dim> setback{};
  };


  /**
   * The faces of the grid's box along which, or less than a cell inside which,
   * walls that stand still lie: nothing passes there, and water does not come
   * between.
   */
  template <int dim>
  WallFaces<dim>
  faces_along_walls(const BackgroundGrid<dim>         &grid,
                    const std::vector<WallParameters> &walls);


  /**
   * Does a wall lie along a line of the grid? The nodes beyond that line are
   * next to free of soil, and spots on the line do not hold them: soil that
   * bears on the wall drives them away, and settles.
   */
  template <int dim>
  bool
  is_along_grid_line(const BackgroundGrid<dim> &grid,
                     const WallParameters      &wall);
} // namespace Waker

#endif
