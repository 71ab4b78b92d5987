// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_proximity_surface_h
#define waker_surface_proximity_surface_h

#include <waker/grid/background_grid.h>
#include <waker/particles/body.h>
#include <waker/surface/marching_cubes.h>

#include <array>
#include <vector>

namespace Waker
{
  struct SurfaceParameters;

  /**
   * The Proximity Field Method in three dimensions: the field PF(x) = sum_p V_p
   * K(x - x_p) on all nodes of the background grid, and its contour surface by
   * marching cubes.
   *
   * On several ranks each has the field on the nodes of its window, and finds
   * the surface in its own cells; the facets go to all.
   *
   * Kernel: K = 15 / (8 pi a^3) (1 - |x - x_p|^2 / a^2) within the radius a,
   * which integrates to one, as that in 2D does (ProximityField). With it the
   * natural threshold is 1/2 again. Mirrors at closed faces as in 2D.
   *
   * Keeps its work arrays from call to call.
   */
  class ProximitySurface
  {
  public:
    /// @param grid all of it, or this rank's window
    /// @param closed_faces where to mirror (Fixities::closed_faces())
    /// @param setback as of ProximityField
    ProximitySurface(const BackgroundGrid<3>     &grid,
                     const SurfaceParameters     &parameters,
                     const unsigned int           closed_faces,
                     const std::array<double, 6> &setback = {});

    /// PF (no unit; about 1 inside a body) at the nodes of the grid, n_nodes
    /// long.
    const std::vector<double> &
    field(const Body<3> &body);

    const std::vector<double> &
    nodal_values() const
    {
      return nodal_field;
    }

    /// The surface of the body, closed, on each rank all of it in the same
    /// order; `facets` is overwritten.
    void
    detect(const Body<3> &body, Facets<3> &facets);

    /// The same as marching cubes left it, with triangles without area.
    const TriangleMesh &
    triangles() const
    {
      return mesh;
    }

  private:
    // What all ranks have found.
    void
    tell_all(Facets<3> &facets);

    // Sum the kernels, each over the `width`^3 nodes that it can reach.
    template <int width>
    void
    add_kernels(const MaterialPoints<3> &points);

    double              radius; // in cells
    double              threshold;
    double              h; // m
    const NodeExchange *ranks;
    double              inverse_h; // 1/m
    double              factor;    // K at its centre (1/m^3)
    Point<3>            origin;    // of the whole lattice, m
    std::array<int, 3>  offset;    // of the grid's node 0 there
    std::array<int, 3>  n_nodes;
    unsigned int        first_traced; // node where the contour's window starts

    // Coordinates of the closed faces in cells from the grid's node 0,
    // [d][lower, upper]; far away where a face is open.
    std::array<std::array<double, 2>, 3> mirrors;

    std::array<int, 3>          begin;    // node of the grid where it is traced
    std::array<unsigned int, 3> n_padded; // of the contour's lattice

    std::vector<unsigned int> cells; // of the facets: work space
    std::vector<double>       nodal_field;
    MarchingCubes             contour;
    TriangleMesh              mesh;
  };
} // namespace Waker

#endif
