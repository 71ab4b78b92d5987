// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_layer_h
#define waker_particles_layer_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <waker/base/expression.h>
#include <waker/grid/background_grid.h>
#include <waker/particles/layer_body.h>
#include <waker/particles/soil_profile.h>

#include <string>
#include <vector>

namespace Waker
{
  /// A layer of the soil profile that has passed its checks.
  template <int dim>
  struct Layer : LayerBody // m, inside the grid's box
  {
    std::string  path;         // "Soil profile/<name>"
    unsigned int material = 0; // number
    /// Initial velocity (m/s), one per component; none: at rest.
    std::vector<Expression<dim>> velocity;
    /// Initial stress (kPa): xx, yy, zz, xy[, xz, yz]; none: zero.
    std::vector<Expression<dim>> stress;

    /// Initial velocity at x (m/s).
    /// @throws UserError ".../Velocity" if it is not a finite number there
    Tensor<1, dim>
    velocity_at(const Point<dim> &x) const;

    /// Initial stress at x (kPa, tension positive).
    /// @throws UserError ".../Initial stress" if it is not a finite number
    /// there
    SymmetricTensor<2, 3>
    stress_at(const Point<dim> &x) const;
  };

  /// The body of a layer; its material, velocity and stress are left open.
  /// @throws UserError "Soil profile/<name>/Polygon", ".../Extent", ".../Top"
  /// or
  /// ".../Bottom": no simple polygon, outside the grid's box, not two ascending
  /// numbers, no height map; extent or map in 2D; maps that leave nothing
  template <int dim>
  Layer<dim>
  place_layer(const BackgroundGrid<dim> &grid,
              const LayerParameters     &parameters);

  /// Heights (m) between which a layer lies: those of its polygon, or of its
  /// maps where they bound it.
  /// @param z_begin, z_end of the grid (m), where it has no extent of its own
  /// @throws UserError as place_layer()
  std::array<double, 2>
  level_range(const LayerParameters &parameters,
              const double           z_begin,
              const double           z_end);

  /// The height (m) of the crest of all layers as they are drawn: in space of
  /// the lowest section across them, of those half a cell apart.
  /// @param z_begin, z_end of the grid (m)
  /// @throws UserError as place_layer()
  double
  drawn_crest(const std::vector<LayerParameters> &layers,
              const unsigned int                  dim,
              const double                        z_begin,
              const double                        z_end,
              const double                        cell_size);

  /// Set the layer's material, velocity and stress.
  /// @throws UserError ".../Material": unknown; ".../Velocity", ".../Initial
  /// stress": wrong length, no expression of place
  template <int dim>
  void
  fill_layer(const LayerParameters          &parameters,
             const std::vector<std::string> &material_names,
             Layer<dim>                     &layer);

  /// @throws UserError ".../Polygon" (".../Top", "...Bottom") if two layers
  /// have more than 1e-9 of the smaller one in common
  template <int dim>
  void
  check_overlap(const std::vector<Layer<dim>> &layers);
} // namespace Waker

#endif
