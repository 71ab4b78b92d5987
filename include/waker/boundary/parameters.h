// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_boundary_parameters_h
#define waker_boundary_parameters_h

#include <limits>
#include <string>

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

    void
    add_parameters(ParameterHandler &prm);
  };


  /// The side of the dyke on which the water stands.
  enum class WaterSide
  {
    none,
    left,
    right
  };

  constexpr const char *
  name_of(const WaterSide choice)
  {
    switch (choice)
      {
        case WaterSide::none:
          return "none";
        case WaterSide::left:
          return "left";
        case WaterSide::right:
          return "right";
      }
    return nullptr;
  }


  /// Section "Water".
  struct WaterParameters
  {
    WaterSide side = WaterSide::none;
    /// Level (m) on the vertical axis at which the dyke's width is measured,
    /// and to which `rise` is added. NaN: none, allowed without water.
    double level = std::numeric_limits<double>::quiet_NaN();
    /// Rise of the level in time (m): see base/time_function.h.
    std::string rise = "0";
    /// Unit weight (kN/m^3).
    double unit_weight = 10.;
    /// A node carries load only if its mass is at least this share of the mass
    /// of a node inside the body.
    double minimum_support = 0.01;

    /// Along x: +1 or -1, away from the water; +1 without water.
    int
    inner_direction() const
    {
      return side == WaterSide::right ? -1 : 1;
    }

    /// Is there any?
    bool
    stands() const
    {
      return side != WaterSide::none;
    }

    /// What the user wrote for `level`: read by the parameter handler, judged
    /// by check().
    std::string level_text = "none";

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError "Water/Level" if it is no number, or missing
    void
    check() const;
  };
} // namespace Waker

#endif
