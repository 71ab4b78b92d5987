// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_parameters_h
#define waker_surface_parameters_h

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  /// How the surface of the soil is found.
  enum class SurfaceMethod
  {
    proximity_field,
    contour // of the support domains
  };

  constexpr const char *
  name_of(const SurfaceMethod choice)
  {
    switch (choice)
      {
        case SurfaceMethod::proximity_field:
          return "proximity field";
        case SurfaceMethod::contour:
          return "contour";
      }
    return nullptr;
  }


  /// Section "Surface".
  struct SurfaceParameters
  {
    SurfaceMethod method = SurfaceMethod::proximity_field;
    /// 3D: take the body as prismatic along z, as a slice in plane strain is.
    bool prismatic = false;
    /// Radius of the kernel in cells (a = b = kernel_radius h), 0.5 to 2.
    double kernel_radius = 1.;
    /// The surface is where the proximity field has this value, 0 to 1.
    double threshold = 0.5;
    /// Mirror the kernels at fixed faces of the grid.
    bool mirror = true;
    /// Gaps of the contour narrower (lower) than this are filled, in points'
    /// domains (W_min, H_min of eqs. 3.12-3.14); 0: none.
    double minimum_gap_width  = 0.5;
    double minimum_gap_height = 0.5;
    /// Fill gaps in both directions alike, instead of from the left only.
    bool symmetric_filling = false;

    /// Is the body's surface that of a section: in 2D, and of a body that is
    /// prismatic?
    bool
    is_of_section(const unsigned int dim) const
    {
      return dim == 2 || prismatic;
    }

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError
    void
    check() const;
  };
} // namespace Waker

#endif
