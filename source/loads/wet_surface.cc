// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/loads/wet_body.h>
#include <waker/loads/wet_section.h>

namespace Waker
{
  template <int dim>
  std::unique_ptr<WetSurface<dim>>
  make_wet_surface(const BackgroundGrid<dim> &grid,
                   const WaterSide            side,
                   const SurfaceParameters   &surface)
  {
    if (side == WaterSide::none)
      return nullptr;
    if constexpr (dim == 3)
      if (!surface.is_of_section(dim))
        return std::make_unique<WetBody>(grid, side);
    return std::make_unique<WetSection<dim>>(grid, side);
  }


  template std::unique_ptr<WetSurface<2>>
  make_wet_surface(const BackgroundGrid<2> &,
                   const WaterSide,
                   const SurfaceParameters &);
  template std::unique_ptr<WetSurface<3>>
  make_wet_surface(const BackgroundGrid<3> &,
                   const WaterSide,
                   const SurfaceParameters &);
} // namespace Waker
