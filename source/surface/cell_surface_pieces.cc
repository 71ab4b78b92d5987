// SPDX-License-Identifier: LGPL-2.1-or-later
// What cells add to a surface along the grid.
#include <deal.II/base/mpi.h>

#include <waker/base/errors.h>
#include <waker/surface/cell_surface.h>

#include <algorithm>
#include <limits>

namespace Waker
{
  namespace
  {
    /// The two triangles, or the segment, of the face of a box in direction d,
    /// its outside on the lower (0) or upper (1) side.
    void
    add_face(const Point<2>    &lower,
             const Point<2>    &upper,
             const unsigned int d,
             const unsigned int side,
             const int          on_face,
             Facets<2>         &facets)
    {
      std::array<Point<2>, 2> ends = {{lower, upper}};
      for (Point<2> &x : ends)
        x[d] = side == 0 ? lower[d] : upper[d];
      // The body is on the left: up on the right side, back on the top.
      if ((d == 0) != (side == 1))
        std::swap(ends[0], ends[1]);
      facets.push_back(make_facet<2>(ends, on_face));
    }


    void
    add_face(const Point<3>    &lower,
             const Point<3>    &upper,
             const unsigned int d,
             const unsigned int side,
             const int          on_face,
             Facets<3>         &facets)
    {
      // Anticlockwise seen from above direction d.
      const unsigned int      s = (d + 1) % 3, t = (d + 2) % 3;
      std::array<Point<3>, 4> x;
      for (unsigned int k = 0; k < 4; ++k)
        {
          x[k][d] = side == 0 ? lower[d] : upper[d];
          x[k][s] = k == 0 || k == 3 ? lower[s] : upper[s];
          x[k][t] = k < 2 ? lower[t] : upper[t];
        }
      if (side == 0)
        std::swap(x[1], x[3]);
      facets.push_back(make_facet<3>({{x[0], x[1], x[2]}}, on_face));
      facets.push_back(make_facet<3>({{x[0], x[2], x[3]}}, on_face));
    }
  } // namespace


  template <int dim>
  typename CellSurface<dim>::Piece
  CellSurface<dim>::make_piece(const Index &index, const Part &part) const
  {
    Piece piece{grid->node(index), 0, 0, part};
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int side = 0; side < 2; ++side)
        {
          const Neighbour next = neighbour(index, d, side);
          piece.open |= (next == Neighbour::empty ? 1u : 0u) << (2 * d + side);
          piece.walls |= (next == Neighbour::wall ? 1u : 0u) << (2 * d + side);
        }
    return piece;
  }


  template <int dim>
  void
  CellSurface<dim>::add_faces(const Piece &piece, Facets<dim> &facets) const
  {
    const Index index = grid->node_index(piece.cell);
    Point<dim>  lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double h = grid->cell_size();
        lower[d]       = grid->origin()[d] + h * (index[d] + piece.part[d][0]);
        upper[d]       = grid->origin()[d] + h * (index[d] + piece.part[d][1]);
      }
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int side = 0; side < 2; ++side)
        {
          const unsigned int face = 2 * d + side;
          if ((piece.open | piece.walls) >> face & 1u)
            add_face(lower,
                     upper,
                     d,
                     side,
                     piece.walls >> face & 1u ? static_cast<int>(face) : -1,
                     facets);
        }
  }


  template <int dim>
  void
  CellSurface<dim>::add_pieces(
    const Body<dim>                               &body,
    const std::function<Part(const Index &index)> &part,
    Facets<dim>                                   &facets) const
  {
    const BackgroundGrid<dim> *const window = body.window().get();
    const auto                       is_own = [&](Index index) {
      if (window == nullptr)
        return true;
      for (unsigned int d = 0; d < dim; ++d)
        index[d] -= window->offset()[d];
      return window->owns_cell(index);
    };

    std::vector<Piece>       pieces;
    std::vector<std::string> problem;
    double                   first_problem = std::numeric_limits<double>::max();
    for (unsigned int c = 0; c < share.size() && problem.empty(); ++c)
      if (const Index index = grid->node_index(c);
          share[c] > share_tolerance && is_own(index))
        try
          {
            const Piece piece = make_piece(index, part(index));
            if ((piece.open | piece.walls) != 0)
              pieces.push_back(piece);
          }
        catch (const UserError &error)
          {
            if (window == nullptr)
              throw;
            problem       = {error.where, error.problem, error.allowed};
            first_problem = c;
          }
    if (window != nullptr)
      {
        const NodeExchange &ranks  = window->exchange();
        const double        lowest = -ranks.largest(-first_problem);
        if (lowest < std::numeric_limits<double>::max())
          {
            if (lowest != first_problem)
              problem.clear();
            for (const std::vector<std::string> &said :
                 Utilities::MPI::all_gather(ranks.communicator(), problem))
              if (!said.empty())
                throw UserError(said[0], said[1], said[2]);
          }
        pieces = ranks.all_gather(pieces);
        std::sort(pieces.begin(),
                  pieces.end(),
                  [](const Piece &a, const Piece &b) {
                    return a.cell < b.cell;
                  });
      }
    facets.clear();
    for (const Piece &piece : pieces)
      add_faces(piece, facets);
  }


  template typename CellSurface<2>::Piece
  CellSurface<2>::make_piece(const Index &, const Part &) const;
  template typename CellSurface<3>::Piece
  CellSurface<3>::make_piece(const Index &, const Part &) const;
  template void
  CellSurface<2>::add_pieces(const Body<2> &,
                             const std::function<Part(const Index &)> &,
                             Facets<2> &) const;
  template void
  CellSurface<3>::add_pieces(const Body<3> &,
                             const std::function<Part(const Index &)> &,
                             Facets<3> &) const;
} // namespace Waker
