// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_mixed_cells_h
#define waker_mechanics_mixed_cells_h

#include <waker/grid/background_grid.h>
#include <waker/mapping/weights.h>
#include <waker/mechanics/stress_update.h>
#include <waker/particles/material_points.h>

#include <cstdint>
#include <vector>

namespace Waker
{
  /// Cells in which points of two stiffnesses lie.
  struct MixedCells
  {
    std::size_t n_cells  = 0;
    std::size_t n_points = 0;
    double      ratio    = 1.; // largest, of G or of K + 4G/3 in one cell
  };

  /**
   * Elastic materials of the points for the in-situ stress: those of the case,
   * and more where stiffnesses mix.
   *
   * A cell has one strain. Where a joint runs through it, points of stiffnesses
   * 1000 and 300 kPa get stresses in that ratio, and only their mean is in
   * balance; the stress across a joint is in truth the same on both sides. For
   * the in-situ stress, of which stiffness is no part, a mixed cell is
   * therefore given one: its points' harmonic means of K and G, by volume, as
   * of layers that are loaded one through the other. A point whose support
   * domain reaches over cells has the mean of their strains, and for the same
   * stress needs the harmonic mean of their moduli, by the shares of its
   * domain.
   */
  struct ElasticMixture
  {
    Materials                  materials;
    std::vector<std::uint32_t> of_point; // number in `materials`
    MixedCells                 cells;
  };

  /// Do they have different stiffnesses?
  bool
  may_mix(const Materials &materials);

  /// @param functions of the points: linear ones have no support domains
  template <int dim>
  ElasticMixture
  elastic_mixture(const Materials           &materials,
                  const BackgroundGrid<dim> &grid,
                  const ShapeFunctions       functions,
                  const MaterialPoints<dim> &points);
} // namespace Waker

#endif
