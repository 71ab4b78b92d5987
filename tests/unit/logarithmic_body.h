// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_logarithmic_body_h
#define waker_tests_logarithmic_body_h

#include <waker/materials/von_mises_softening.h>
#include <waker/mechanics/consistent_tangent.h>
#include <waker/mechanics/deformation.h>
#include <waker/mechanics/logarithmic_motion.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>

/// Elastic bodies in large, homogeneous motions.
namespace LogarithmicBody
{
  using namespace Waker;

  constexpr double h = 0.25, density = 1.5, E = 1000., nu = 0.3;
  constexpr double G = E / (2. * (1. + nu)), K = E / (3. * (1. - 2. * nu));


  template <int dim>
  inline Tensor<2, dim>
  identity()
  {
    return unit_symmetric_tensor<dim>();
  }


  /// Points of an elastic material in a homogeneous motion, one step or many.
  template <int dim>
  struct Body
  {
    Body()
      : grid(Lattice::grid<dim>(2., h))
      , weights(grid, ShapeFunctions::gimp)
      , force(grid.n_dofs())
    {
      materials.push_back(std::make_unique<LinearElastic>(density, E, nu));
      Point<dim> lower;
      for (unsigned int d = 0; d < dim; ++d)
        lower[d] = 0.8;
      points = Lattice::box(lower, 2, 0.5 * h, density);
      prepare_domains(SupportDomains::stretched, points);
      weights.reinit(points);
      V0 = points.volume[0];
    }

    /// Deform by dF more; the points stay where they are.
    StressReport
    deform(const Tensor<2, dim> &dF)
    {
      StressUpdate<dim> update(materials,
                               std::make_unique<LogarithmicMotion<dim>>());
      update.begin(points, weights);
      update.evaluate(points,
                      weights,
                      Lattice::linear_field(grid,
                                            dF - identity<dim>(),
                                            Tensor<1, dim>()),
                      force);
      return update.accept(points);
    }

    BackgroundGrid<dim> grid;
    MaterialPoints<dim> points;
    Materials           materials;
    Weights<dim>        weights;
    NodalVector         force;
    double              V0;
  };
} // namespace LogarithmicBody

#endif
