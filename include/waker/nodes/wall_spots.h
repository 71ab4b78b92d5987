// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_wall_spots_h
#define waker_nodes_wall_spots_h

#include <deal.II/base/point.h>

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
} // namespace Waker

#endif
