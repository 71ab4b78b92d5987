// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_parameters_h
#define waker_loads_parameters_h

#include <waker/base/numbers.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

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
    double level = nan;
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
