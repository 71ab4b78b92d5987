// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_nonlocal_softening_h
#define waker_mechanics_nonlocal_softening_h

#include <waker/grid/background_grid.h>
#include <waker/materials/material.h>
#include <waker/mechanics/nonlocal_average.h>
#include <waker/particles/material_points.h>

#include <memory>
#include <vector>

namespace Waker
{
  /**
   * What softens points by more than their own plastic strain: of the materials
   * whose SofteningMeasure is not local. In a step strengths are constant, and
   * so the stress update, its tangent and its dissipation are those of perfect
   * plasticity; at its end they follow the increments that the step has brought
   * in and around each point. Softening lags behind by one step, of which the
   * error is of first order in the time step.
   */
  template <int dim>
  class NonlocalSoftening
  {
  public:
    explicit NonlocalSoftening(
      const std::vector<std::unique_ptr<Material>> &materials);

    bool
    is_used() const
    {
      return !averages.empty();
    }

    /**
     * Take the strengths along.
     *
     * @param increments of the "plastic strain" in the step, of all points
     * @param variable_arrays of each material, in which scalars its variables
     *        are
     * @param grid in a window of it each of several ranks has a part of the
     *        points, and is told of those near its own
     */
    void
    soften(const std::vector<double>           &increments,
           const std::vector<std::vector<int>> &variable_arrays,
           const BackgroundGrid<dim>           &grid,
           MaterialPoints<dim>                 &points);

  private:
    struct MaterialAverage
    {
      unsigned int         number;
      const Material      *material;
      SofteningMeasure     measure;
      NonlocalAverage<dim> average;
    };

    /// The points of one material on this rank and near its own, in the order
    /// of their ids: sums over them are the same on any number of ranks.
    struct Surroundings
    {
      std::vector<Point<dim>>    position;
      std::vector<double>        volume;
      std::vector<double>        increment;
      std::vector<std::uint32_t> place; // in the own points, or not_here
    };
    static constexpr std::uint32_t not_here = -1;

    /// Those of the `members`, and around them.
    /// @param reach how far (m)
    void
    gather(const BackgroundGrid<dim> &grid,
           const double               reach,
           const MaterialPoints<dim> &points,
           const std::vector<double> &increments,
           const unsigned int         material);

    std::vector<MaterialAverage> averages;
    // Work space.
    std::vector<std::uint32_t> members;
    Surroundings               around; // on several ranks
  };
} // namespace Waker

#endif
