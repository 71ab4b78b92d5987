// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_cell_surface_h
#define waker_surface_cell_surface_h

#include <waker/grid/background_grid.h>
#include <waker/mapping/shape_functions.h>
#include <waker/particles/body.h>
#include <waker/surface/shape/facet.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * Surfaces made of pieces that lie along the grid. A cell beyond a closed
   * face of the box counts as soil; the facets there are marked.
   *
   * On several ranks each finds the pieces of its own cells, from the points in
   * and near them, and tells all what these are.
   *
   * Keeps its work arrays from call to call.
   */
  template <int dim>
  class CellSurface
  {
  public:
    /// @param closed_faces Fixities::closed_faces()
    CellSurface(const BackgroundGrid<dim> &grid,
                const unsigned int         closed_faces);

    /**
     * The faces between active and inactive cells (section 3.3.2 of
     * Remmerswaal 2023). With linear functions a cell is active if it holds a
     * point, with GIMP if a support domain reaches into it.
     * @param facets overwritten
     */
    void
    find_active(const Body<dim>     &body,
                const ShapeFunctions functions,
                Facets<dim>         &facets);

    /**
     * The surface that encloses in each cell the volume of the points which it
     * holds (section 3.3.4 of Remmerswaal 2023): consistent with the internal
     * force of standard MPM where the sides along it lie on lines of the grid
     * (a layer of points in a cell is not where its volume is put). That is
     * determined only for bodies that lie along the grid: blocks, bars, layers,
     * in two cells at least where they end inside one. A cell that is open on
     * one side is filled from the other, in each direction as far as its
     * points' own domains reach together.
     *
     * @param path of the parameter that asked for it, for the error
     * @param facets overwritten
     * @throws UserError if a cell does not say on which side it is open; on
     *         each rank, that of the first such cell
     */
    void
    find_volume(const Body<dim>   &body,
                const std::string &path,
                Facets<dim>       &facets);

  private:
    using Index = typename BackgroundGrid<dim>::Index;
    /// Part of a cell that is filled: from .. to in each direction, 0 to 1.
    using Part = std::array<std::array<double, 2>, dim>;

    enum class Neighbour
    {
      empty,
      soil,
      wall
    };

    /// What lies next to a cell in direction d, on the lower (0) or upper (1)
    /// side.
    Neighbour
    neighbour(const Index       &index,
              const unsigned int d,
              const unsigned int side) const;

    /// What a cell adds to the surface.
    struct Piece
    {
      std::uint64_t cell;
      std::uint32_t open, walls; // bit 2d for the lower, 2d + 1 the upper face
      Part          part;
    };

    /// The pieces of all cells that hold soil, in their order, as facets.
    /// @param part of such a cell
    void
    add_pieces(const Body<dim>                               &body,
               const std::function<Part(const Index &index)> &part,
               Facets<dim>                                   &facets) const;

    Piece
    make_piece(const Index &index, const Part &part) const;

    void
    add_faces(const Piece &piece, Facets<dim> &facets) const;

    Part
    filled_part(const Index &index, const std::string &path) const;

    /// Less than this share of a cell is round-off.
    static constexpr double share_tolerance = 1e-9;

    const BackgroundGrid<dim> *grid;
    unsigned int               closed_faces;
    Index                      lowest; // cells of the body: inside closed faces
    Index                      highest; // exclusive
    /// Share of each cell that is filled, by its lower left node.
    std::vector<double> share;
    /// How far the domains of the points in each cell reach (m).
    std::vector<Point<dim>> lower_end;
    std::vector<Point<dim>> upper_end;
    MaterialPoints<dim>     around; // on several ranks
  };
} // namespace Waker

#endif
