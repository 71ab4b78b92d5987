// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_feeder_h
#define waker_particles_feeder_h

#include <waker/grid/background_grid.h>
#include <waker/particles/material_points.h>
#include <waker/particles/openings.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace Waker
{
  /**
   * Material that moves into the grid's box at a constant velocity: a strip of
   * points in the margin in front of an opening, one cell deep. Its points are
   * the sub-cells of the lattice, free of stress, with the initial values of
   * their material. The strip is pushed by the nodes of the opening, which the
   * caller moves (Fixities); whenever it has advanced by a sub-cell, a new row
   * of points fills the gap at its end.
   */
  template <int dim>
  class Feeder
  {
  public:
    /// What a new point starts with: name and value of its material's
    /// variables.
    using Variables = std::vector<std::pair<std::string, double>>;

    /**
     * @param n_points_1d points per cell and direction
     * @param material number, with its density (Mg/m^3)
     * @throws UserError "Inflow/<name>/..." if the opening is not a whole
     *         number of cells on the face
     */
    Feeder(const BackgroundGrid<dim> &grid,
           const InflowParameters    &parameters,
           const unsigned int         n_points_1d,
           const unsigned int         material,
           const double               density,
           const Variables           &variables);

    /// Append the whole strip as it lies at t = 0.
    void
    fill(MaterialPoints<dim> &points, std::uint64_t &next_id) const;

    /**
     * Append the rows that are due at time t (s).
     * @param rows that have entered since t = 0; brought up to date
     * @return number of points appended
     */
    std::size_t
    feed(const double         t,
         std::uint64_t       &rows,
         MaterialPoints<dim> &points,
         std::uint64_t       &next_id) const;

    /// Where the material enters.
    const Opening<dim> &
    mouth() const
    {
      return opening;
    }

    /// Into the box (m/s).
    const Tensor<1, dim> &
    velocity() const
    {
      return inward;
    }

  private:
    /// Append a row whose outer edge lies at `depth` (m) beyond the face.
    void
    append_row(const double         depth,
               MaterialPoints<dim> &points,
               std::uint64_t       &next_id) const;

    double         h;
    unsigned int   n_points_1d;
    unsigned int   direction;
    double         inwards; // 1 at a lower face, -1 at an upper one
    unsigned int   material;
    double         density;
    Variables      variables;
    Opening<dim>   opening;
    Tensor<1, dim> inward;
  };
} // namespace Waker

#endif
