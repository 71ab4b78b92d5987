// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mapping_weights_h
#define waker_mapping_weights_h

#include <deal.II/base/tensor.h>

#include <waker/grid/background_grid.h>
#include <waker/mapping/shape_functions.h>
#include <waker/particles/material_points.h>

#include <vector>

namespace Waker
{
  /**
   * The functions S_ip of one point on its stencil of 3^dim nodes, as 1D
   * factors: S_ip and its gradient are products per direction.
   */
  template <int dim>
  struct PointWeights
  {
    unsigned int base; // lower left node of the stencil
    double       value[dim][3];
    double       gradient[dim][3]; // 1/m
  };

  /**
   * The weights of all points for one step: they are computed once, where the
   * points lie at its start, and stay fixed while it is solved.
   */
  template <int dim>
  class Weights
  {
  public:
    Weights(const BackgroundGrid<dim> &grid, const ShapeFunctions functions);

    /// @throws NumericalFailure if a support domain leaves grid and margin
    void
    reinit(const MaterialPoints<dim> &points);

    const PointWeights<dim> &
    operator[](const std::size_t p) const
    {
      return weights[p];
    }

    std::size_t
    size() const
    {
      return weights.size();
    }

    const BackgroundGrid<dim> &
    background_grid() const
    {
      return *grid;
    }

    ShapeFunctions
    functions() const
    {
      return shape_functions;
    }

  private:
    const BackgroundGrid<dim>     *grid;
    ShapeFunctions                 shape_functions;
    std::vector<PointWeights<dim>> weights;
  };
} // namespace Waker

#endif
