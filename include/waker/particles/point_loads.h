// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_point_loads_h
#define waker_particles_point_loads_h

#include <waker/particles/material_points.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  /// A force that rides on material points: subsection "Point loads/<name>".
  struct PointLoadParameters
  {
    std::string name; // of the subsection
    /// The points initially in this box share the force, by volume (m). With
    /// `to` empty: the point nearest to `from`, the first of several.
    std::vector<double> from;
    std::vector<double> to;
    /// Total force (kN; kN/m in 2D), dim components, constant in direction.
    std::vector<double> force;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError "Point loads/<name>/..."
    void
    check(const unsigned int dim) const;
  };

  /// Share of each point in a load (-), by volume; their sum is 1, or 0 without
  /// points.
  /// @throws UserError "Point loads/<name>/From" if no point is there
  template <int dim>
  std::vector<double>
  shares_of_points(const PointLoadParameters &load,
                   const double               cell_size,
                   const MaterialPoints<dim> &points);

  /// Give the points their share of the loads (MaterialPoints::load).
  /// @throws UserError "Point loads/<name>/From" if no point is there
  template <int dim>
  void
  apply_point_loads(const std::vector<PointLoadParameters> &loads,
                    const double                            cell_size,
                    MaterialPoints<dim>                    &points);
} // namespace Waker

#endif
