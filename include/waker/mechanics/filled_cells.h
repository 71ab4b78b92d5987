// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_filled_cells_h
#define waker_mechanics_filled_cells_h

#include <waker/mapping/weights.h>
#include <waker/particles/material_points.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Waker
{
  /// Where B-bar acts.
  enum class BBarCells
  {
    filled, // see FilledCells
    all
  };


  /**
   * How far B-bar acts on each point: fully in cells that soil fills at
   * least by half, not at all in those of which it fills three eighths or less.
   *
   * A cell's centre stands for its soil only if the soil is all around it. In
   * a cell with a wedge of soil in a corner, a uniform pressure p in that soil
   * and the same p on its surface are in balance for the standard gradients,
   *   sum_p V_p grad S_ip = the surface's integral of S_i n,
   * but not for those at the centre: what is left over tears at nodes with
   * hardly any mass. Where the cell is not full nothing locks, either.
   *
   * With f the share of a cell that the support domains' volumes fill,
   *   share of the cell   b = 4 f - 1, within 0 and 1,
   *   share of the point    = 2 B - 1, at least 0,
   * with B the mean of b over the support domain: one of which half or more
   * lies in cells without B-bar has none.
   *
   * Into an empty cell beyond the grid's box, behind a face along which soil
   * moves, a domain may reach by a hair e. The values at that cell's centre
   * would push its nodes along the face in proportion to e; their mass, and
   * what the standard gradients do there, is in proportion to e^2. So in each
   * direction the values are those of two cells with their shares, of cells
   * beyond the box times b. (Across the face both are in proportion to e, as a
   * traction on the surface is.) Inside the box, at a free surface, the same
   * would take from nodes of partly filled cells what holds them against the
   * water on them.
   */
  template <int dim>
  class FilledCells
  {
  public:
    explicit FilledCells(const BBarCells cells = BBarCells::filled)
      : which(cells)
    {}

    /// Find the shares for the points as they lie.
    void
    reinit(const MaterialPoints<dim> &points, const Weights<dim> &weights);

    /// Share of B-bar of a cell of which soil fills a share.
    static double
    share_of_cell(const double filled, const BBarCells which)
    {
      return which == BBarCells::all ? 1.
                                     : std::clamp(4. * filled - 1., 0., 1.);
    }

    std::size_t
    size() const
    {
      return shares.size();
    }

    /// The share of its first cell in the mean dilatation of point p, in each
    /// direction, see CentreWeights.
    const std::array<double, dim> &
    first_shares(const std::size_t p) const
    {
      return first[p];
    }

    /// Share of B-bar of point p, 0 to 1.
    double
    operator[](const std::size_t p) const
    {
      return shares[p];
    }

  private:
    BBarCells           which;
    std::vector<double> cells; // by their lowest node: volume (m^dim), then b
    std::vector<double> shares;
    std::vector<std::array<double, dim>> first;
    // Of each node: does its cell lie beyond the box? For the window that
    // begins there.
    std::vector<unsigned char>          beyond;
    typename BackgroundGrid<dim>::Index begin;
    std::array<unsigned int, dim>       extent;
  };
} // namespace Waker

#endif
