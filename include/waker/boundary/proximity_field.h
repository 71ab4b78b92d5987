// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_boundary_proximity_field_h
#define waker_boundary_proximity_field_h

#include <waker/boundary/surface.h>
#include <waker/grid/background_grid.h>
#include <waker/particles/material_points.h>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  /// Section "Surface".
  struct SurfaceParameters
  {
    /// Radius of the kernel in cells (a = b = kernel_radius h), 0.5 to 2.
    double kernel_radius = 1.;
    /// The surface is where the proximity field has this value, 0 to 1.
    double threshold = 0.5;
    /// Mirror the kernels at fixed faces of the grid.
    bool mirror = true;

    void
    add_parameters(ParameterHandler &prm);
  };

  /**
   * The Proximity Field Method: a field PF(x) = sum_p V_p K(x - x_p) on the
   * nodes of the background grid, of which marching squares draw the contour.
   *
   * Kernel: eqs. 3.8-3.11 of Remmerswaal 2023 (3D constant 15 / (8 pi a^3)).
   * Volume-normalised kernels make the natural threshold 1/2: the detected
   * line then has no mean offset from a flat face.
   *
   * Keeps its work arrays from call to call. 2D only for now: in 3D, field()
   * works and detect() is not there (the water load of a 3D case is drawn
   * from its mid-plane; see boundary/water_load.h).
   */
  template <int dim>
  class ProximityField
  {
  public:
    /// @param closed_faces where to mirror (Fixities::closed_faces())
    ProximityField(const BackgroundGrid<dim> &grid,
                   const SurfaceParameters &  parameters,
                   const unsigned int         closed_faces);

    /// PF at every node (no unit; 1 inside a body), for the points as they lie.
    const std::vector<double> &
    field(const MaterialPoints<dim> &points);

    /// The contour of the field at the threshold.
    Surface
    detect(const MaterialPoints<dim> &points);

  private:
    const BackgroundGrid<dim> *grid;
    SurfaceParameters          parameters;
    unsigned int               closed_faces;
    std::vector<double>        nodal_field;
  };
} // namespace Waker

#endif
