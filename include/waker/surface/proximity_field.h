// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_proximity_field_h
#define waker_surface_proximity_field_h

#include <waker/grid/background_grid.h>
#include <waker/particles/body.h>
#include <waker/surface/marching_squares.h>
#include <waker/surface/parameters.h>
#include <waker/surface/proximity_surface.h>
#include <waker/surface/shape/surface.h>

#include <array>
#include <memory>
#include <optional>

namespace Waker
{
  /**
   * The Proximity Field Method: a field PF(x) = sum_p V_p K(x - x_p) on the
   * nodes of the background grid, of which marching squares draw the contour.
   *
   * Kernel: K = 2 / (pi a^2) (1 - |x - x_p|^2 / a^2) within the radius a, eqs.
   * 3.8-3.11 of Remmerswaal 2023. With the volume V_p as factor the natural
   * threshold is 1/2: the detected line then has no mean offset from a flat
   * face (its scatter for 2 x 2 points per cell is -0.095 to +0.071 h for
   * a = h, +-0.022 h for a = 2 h). Convex corners are rounded and gaps narrower
   * than about a are closed.
   *
   * At a closed face the kernels of the points within a of it are mirrored, so
   * that the field is not halved there, and the body is cut at the face.
   *
   * In 3D there are two surfaces. That of the body itself, with the kernel of
   * three dimensions (ProximitySurface), as facets; it is there unless the
   * parameters call the body prismatic. And the contour in the x-y plane of the
   * body as if it were prismatic: its points are projected on the plane with
   * V_p / L_z, L_z the extent of the grid's box in z. A plane-strain slice so
   * has the contour of the two-dimensional body; of any other body it is a mean
   * over its length (no dyke is measured on it).
   *
   * Keeps its work arrays from call to call.
   */
  template <int dim>
  class ProximityField
  {
  public:
    /// @param closed_faces where to mirror (Fixities::closed_faces())
    /// @param setback how far inside these faces the planes are that close
    ///        them (m), less than a cell: walls
    ProximityField(const BackgroundGrid<dim>        &grid,
                   const SurfaceParameters          &parameters,
                   const unsigned int                closed_faces,
                   const std::array<double, 2 *dim> &setback = {});

    /// PF (no unit; about 1 inside a body) for the points as they lie, at the
    /// nodes of the x-y lattice, x fastest, margin included: n_x n_y entries,
    /// which in 2D are all nodes of the grid. In 3D that of the projection.
    const std::vector<double> &
    field(const Body<dim> &body);

    /// The field as last computed; in 3D, unless prismatic, that of the body
    /// itself, at all nodes. On several ranks, which know it on their windows
    /// only, it is computed for the whole body.
    const std::vector<double> &
    nodal_values(const Body<dim> &body);

    /// The contour of the field at the threshold, in the x-y plane. `surface`
    /// is overwritten, its storage used again.
    void
    detect(const Body<dim> &body, Surface &surface);

    Surface
    detect(const Body<dim> &body);

    /// The surface of the body itself: segments in 2D, triangles in 3D, there
    /// not if the body is called prismatic. `facets` is overwritten.
    void
    detect(const Body<dim> &body, Facets<dim> &facets);

  private:
    // Sum the kernels, each over the `width` x `width` nodes that it can reach.
    template <int width>
    void
    add_kernels(const MaterialPoints<dim> &points);

    double       radius; // in cells
    double       threshold;
    double       inverse_h; // 1/m
    double       factor;    // K at its centre, times 1 / L_z in 3D
    Point<2>     origin;    // of the lattice, m
    int          n_x;
    int          n_y;
    unsigned int first_traced; // lattice node where the contour's window starts

    // Coordinates of the closed faces in cells from the origin, in the order
    // x lower, x upper, y lower, y upper; far away where a face is open.
    std::array<double, 4> mirrors;

    std::vector<double> nodal_field;
    MarchingSquares     contour;
    Surface             chains; // work space

    /// In 3D, unless prismatic: made when it is first needed, on several ranks
    /// for each window anew.
    struct Spatial
    {
      BackgroundGrid<dim> const                 *whole;
      SurfaceParameters                          parameters;
      unsigned int                               closed_faces;
      std::array<double, 2 * dim>                setback;
      std::shared_ptr<const BackgroundGrid<dim>> window; // that it is made for
      std::unique_ptr<ProximitySurface>          surface;
      bool                                       has_field = false;

      ProximitySurface &
      on(const std::shared_ptr<const BackgroundGrid<dim>> &other);
    };
    std::optional<Spatial> spatial;
  };
} // namespace Waker

#endif
