// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_wall_parameters_h
#define waker_nodes_wall_parameters_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  /// How a wall holds the soil.
  enum class WallType
  {
    rough,     // it sticks
    smooth,    // it may slide along the wall
    frictional // it may slide, against friction, and leave the wall
  };

  constexpr const char *
  name_of(const WallType choice)
  {
    switch (choice)
      {
        case WallType::rough:
          return "rough";
        case WallType::smooth:
          return "smooth";
        case WallType::frictional:
          return "frictional";
      }
    return nullptr;
  }


  /// A wall or rigid footing that is not on the grid: subsection
  /// "Walls/<name>".
  struct WallParameters
  {
    std::string name; // of the subsection
    /// 2D: corners "x1, y1; x2, y2; ..." (m) of a line, the soil on its left;
    /// 3D: corners of a flat polygon, the soil on the side from which they run
    /// anticlockwise.
    std::string line;
    WallType    type = WallType::rough;
    /// Displacement of the wall since t = 0 (m): per component a number or an
    /// expression of t (s), "0.1*t; 0". Empty: at rest.
    std::string displacement;
    /// Stiffness of the penalty, as a multiple of (K + 4G/3) / h.
    double penalty_factor = 100.;
    /// Of a frictional wall, that carries a shear traction of up to
    /// mu p + a under the pressure p: mu, or its angle in degrees, and a (kPa).
    double friction_coefficient = 0.;
    double friction_angle       = 0.;
    double adhesion             = 0.;

    /// mu
    double
    friction() const;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError "Walls/<name>/..."
    void
    check(const unsigned int dim) const;
  };
} // namespace Waker

#endif
