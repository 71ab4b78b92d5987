// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_user_surface_h
#define waker_surface_user_surface_h

#include <waker/grid/background_grid.h>
#include <waker/nodes/nodal_vector.h>
#include <waker/surface/shape/facet.h>

#include <array>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * A surface that the user gives: closed chains of segments in 2D, closed
   * triangulations in 3D. How its vertices hang together never changes; where
   * they are is part of the state of a run.
   */
  template <int dim>
  struct UserSurface
  {
    std::vector<Point<dim>>                    vertices; // m, at t = 0
    std::vector<std::array<unsigned int, dim>> elements; // body on the left

    /// The facets, with the vertices where they are now.
    /// @param facets overwritten
    void
    to_facets(const std::vector<Point<dim>> &moved_vertices,
              Facets<dim>                   &facets) const;
  };

  /**
   * Read a surface and check it.
   *
   * 2D: a text file with "x y" or "x, y" (m) of a vertex per line, the body on
   * the left, the last vertex of a chain the same as the first, empty lines
   * between chains, # for comments. 3D: an STL file, text or binary.
   *
   * @param path of the parameter with the file's name, for the error
   * @throws UserError: no such file; not readable; fewer than three vertices; a
   * chain or triangulation that is open; chains that cross (2D); the soil on
   * the wrong side (no positive volume); a vertex outside the grid's box
   */
  template <int dim>
  UserSurface<dim>
  read_user_surface(const std::string         &file,
                    const std::string         &path,
                    const BackgroundGrid<dim> &grid);

  /// The checks of read_user_surface() on a surface of any origin.
  /// @param name of it, for the error
  template <int dim>
  void
  check_user_surface(const UserSurface<dim>    &surface,
                     const std::string         &name,
                     const std::string         &path,
                     const BackgroundGrid<dim> &grid);

  /**
   * Carry vertices with the material: x += sum_i N_i du_i / sum_i N_i over the
   * cell's nodes that have more than the least mass, with linear functions N_i.
   * (A node that a domain reaches by a hair has hardly any stiffness: it goes
   * metres, as it were, and the domain does not notice.) A vertex in a cell
   * without such a node follows the closest one within two cells, and rests if
   * there is none. On several ranks, which all have all vertices, each
   * carries those in its own cells, and tells the others.
   *
   * @param grid or a window that reaches carrying_reach nodes beyond its own
   * @param mass of its nodes (Mg)
   * @param least_mass Mg
   * @param increment of its nodes in the step just done (m)
   */
  template <int dim>
  void
  carry_vertices(const BackgroundGrid<dim> &grid,
                 const std::vector<double> &mass,
                 const double               least_mass,
                 const NodalVector         &increment,
                 std::vector<Point<dim>>   &vertices);

  constexpr int carrying_reach = 3;
} // namespace Waker

#endif
