// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <waker/base/errors.h>
#include <waker/particles/near_points.h>
#include <waker/surface/cell_surface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// A block's volume may differ by this share from that of its points, which
    /// a deformation has moved.
    constexpr double share_difference = 0.05;
  } // namespace


  template <int dim>
  CellSurface<dim>::CellSurface(const BackgroundGrid<dim> &grid,
                                const unsigned int         closed_faces)
    : grid(&grid)
    , closed_faces(closed_faces)
    , share(grid.n_nodes())
  {
    const int margin = BackgroundGrid<dim>::margin;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const int n = grid.n_nodes_per_direction()[d];
        lowest[d]   = (closed_faces >> (2 * d)) & 1u ? margin : 0;
        highest[d]  = n - 1 - ((closed_faces >> (2 * d + 1)) & 1u ? margin : 0);
      }
  }


  template <int dim>
  typename CellSurface<dim>::Neighbour
  CellSurface<dim>::neighbour(const Index       &index,
                              const unsigned int d,
                              const unsigned int side) const
  {
    Index next = index;
    next[d] += side == 0 ? -1 : 1;
    if (next[d] < lowest[d] || next[d] >= highest[d])
      return (closed_faces >> (2 * d + side)) & 1u ? Neighbour::wall
                                                   : Neighbour::empty;
    return share[grid->node(next)] > share_tolerance ? Neighbour::soil
                                                     : Neighbour::empty;
  }


  template <int dim>
  void
  CellSurface<dim>::find_active(const Body<dim>     &body,
                                const ShapeFunctions functions,
                                Facets<dim>         &facets)
  {
    // What lies in own cells, and in those next to them.
    const MaterialPoints<dim> &points =
      own_and_near(body,
                   grid->cell_size() + (functions == ShapeFunctions::gimp
                                          ? largest_half_size(body.own())
                                          : 0.),
                   around);
    std::fill(share.begin(), share.end(), 0.);
    const double inverse_h = grid->inverse_cell_size();
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        Index        from, to; // inclusive
        unsigned int n = 1;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double x =
              (points.position[p][d] - grid->origin()[d]) * inverse_h;
            const double l = functions == ShapeFunctions::gimp
                               ? points.half_size[p][d] * inverse_h
                               : 0.;
            from[d]        = std::floor(x - l + touch_tolerance);
            to[d]          = functions == ShapeFunctions::gimp
                               ? static_cast<int>(std::ceil(x + l - touch_tolerance)) - 1
                               : from[d];
            from[d]        = std::max(from[d], lowest[d]);
            to[d]          = std::min(to[d], highest[d] - 1);
            n *= std::max(to[d] - from[d] + 1, 0);
          }
        for (unsigned int k = 0; k < n; ++k)
          {
            Index cell = from;
            int   rest = k;
            for (unsigned int d = 0; d < dim; ++d)
              {
                cell[d] += rest % (to[d] - from[d] + 1);
                rest /= to[d] - from[d] + 1;
              }
            share[grid->node(cell)] = 1.;
          }
      }

    Part whole;
    whole.fill({{0., 1.}});
    add_pieces(
      body, [&](const Index &) { return whole; }, facets);
  }


  template <int dim>
  typename CellSurface<dim>::Part
  CellSurface<dim>::filled_part(const Index       &index,
                                const std::string &path) const
  {
    const auto refuse = [&](const std::string &why) {
      std::ostringstream what;
      what << "the surface cannot be placed by volume in the cell at ("
           << grid->node_position(grid->node(index)) << ") m, " << why;
      throw UserError(path,
                      what.str(),
                      "\"volume\" for bodies that lie along the grid; for "
                      "others GIMP functions with \"contour\"");
    };
    const double filled = share[grid->node(index)];

    // Open directions: soil (or a wall) on one side only. There the cell is
    // filled from that side, as far as the points' own domains reach.
    const unsigned int            c = grid->node(index);
    Part                          part;
    std::array<unsigned int, dim> open_side;
    unsigned int                  n_open  = 0;
    bool                          is_thin = false;
    double                        product = 1.;
    part.fill({{0., 1.}});
    open_side.fill(2);
    for (unsigned int d = 0; d < dim; ++d)
      {
        const Neighbour below = neighbour(index, d, 0);
        const Neighbour above = neighbour(index, d, 1);
        if (below == Neighbour::empty && above == Neighbour::empty)
          is_thin = true;
        else if (below == Neighbour::empty || above == Neighbour::empty)
          {
            open_side[d] = above == Neighbour::empty ? 1 : 0;
            ++n_open;
            product *= (upper_end[c][d] - lower_end[c][d]) / grid->cell_size();
          }
      }
    // Inside the body a cell is taken as full.
    if (n_open == 0)
      {
        if (is_thin && std::abs(filled - 1.) > share_difference)
          refuse("which the body does not fill though it ends on both sides");
        if (filled < 0.5)
          refuse("which is hardly filled but has soil on all sides");
        return part;
      }
    if (std::abs(product - filled) > share_difference * product)
      refuse("whose points do not fill a block");

    // What is missing, or too much, goes to all open directions alike.
    const double factor = std::pow(filled / product, 1. / n_open);
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double along = std::min(
          factor * (upper_end[c][d] - lower_end[c][d]) / grid->cell_size(), 1.);
        if (open_side[d] == 1)
          part[d][1] = along;
        else if (open_side[d] == 0)
          part[d][0] = 1. - along;
      }
    return part;
  }


  template <int dim>
  void
  CellSurface<dim>::find_volume(const Body<dim>   &body,
                                const std::string &path,
                                Facets<dim>       &facets)
  {
    // What lies in own cells, in those next to them, and beyond closed faces
    // there.
    const MaterialPoints<dim> &points =
      own_and_near(body, 2. * grid->cell_size(), around);
    std::fill(share.begin(), share.end(), 0.);
    Point<dim> far;
    for (unsigned int d = 0; d < dim; ++d)
      far[d] = std::numeric_limits<double>::max();
    lower_end.assign(share.size(), far);
    upper_end.assign(share.size(), -far);
    const double whole = std::pow(grid->cell_size(), dim);
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        Index cell = grid->cell_index(points.position[p]);
        for (unsigned int d = 0; d < dim; ++d)
          cell[d] = std::min(std::max(cell[d], lowest[d]), highest[d] - 1);
        const unsigned int c = grid->node(cell);
        share[c] += points.volume[p] / whole;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double x  = points.position[p][d];
            const double l  = points.half_size[p][d];
            lower_end[c][d] = std::min(lower_end[c][d], x - l);
            upper_end[c][d] = std::max(upper_end[c][d], x + l);
          }
      }

    add_pieces(
      body,
      [&](const Index &index) { return filled_part(index, path); },
      facets);
  }


  template class CellSurface<2>;
  template class CellSurface<3>;
} // namespace Waker
