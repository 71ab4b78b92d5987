// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_nonlocal_softening_h
#define waker_mechanics_nonlocal_softening_h

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
     */
    void
    soften(const std::vector<double>           &increments,
           const std::vector<std::vector<int>> &variable_arrays,
           MaterialPoints<dim>                 &points);

  private:
    struct MaterialAverage
    {
      unsigned int         number;
      const Material      *material;
      SofteningMeasure     measure;
      NonlocalAverage<dim> average;
    };

    std::vector<MaterialAverage> averages;
    std::vector<std::uint32_t>   members; // work space
  };
} // namespace Waker

#endif
