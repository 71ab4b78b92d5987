// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_soil_h
#define waker_case_soil_h

#include <waker/case/parameters.h>
#include <waker/grid/background_grid.h>
#include <waker/mechanics/stress_update.h>

#include <vector>

namespace Waker
{
  template <int dim>
  BackgroundGrid<dim>
  make_grid(const GridParameters &parameters, const MPI_Comm communicator);

  /// The points of the soil profile.
  /// @param materials of the parameters, by number
  /// @param layers_of_points out: number of each one's layer; may be null
  /// @throws UserError as make_material_points()
  template <int dim>
  MaterialPoints<dim>
  make_soil(const BackgroundGrid<dim> &grid,
            const Parameters          &parameters,
            const Materials           &materials,
            std::vector<unsigned int> *layers_of_points = nullptr);
} // namespace Waker

#endif
