// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_mean_dilatation_h
#define waker_tests_mean_dilatation_h

#include <waker/base/errors.h>
#include <waker/mapping/centre_stencil.h>
#include <waker/materials/linear_elastic.h>
#include <waker/mechanics/step_motion.h>
#include <waker/mechanics/stress_update.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>

/// A body whose dilatation is that of the cells' centres.
namespace MeanDilatation
{
  using namespace Waker;

  constexpr double h = 0.25;


  /// Points at any place, in a grid of cells of h.
  template <int dim>
  struct SampleBody
  {
    SampleBody(const ShapeFunctions functions, const double nu)
      : grid(Lattice::grid<dim>(1.5, h))
      , weights(grid, functions)
    {
      materials.push_back(std::make_unique<LinearElastic>(1.5, 1000., nu));
      Lattice::Random random(7);
      points = Lattice::box(Point<dim>(random.vector<dim>(0.2, 0.3)),
                            dim == 2 ? 6 : 4,
                            0.5 * h);
      for (auto &x : points.position)
        x += random.vector<dim>(-0.05, 0.05);
      weights.reinit(points);
    }

    StressUpdate<dim>
    update(const bool objective = false) const
    {
      return {materials,
              std::make_unique<MeanDilatationMotion<dim>>(objective)};
    }

    BackgroundGrid<dim> grid;
    MaterialPoints<dim> points;
    Materials           materials;
    Weights<dim>        weights;
  };


  template <int dim>
  inline NodalVector
  random_field(const BackgroundGrid<dim> &grid, Lattice::Random &random)
  {
    NodalVector u(grid.n_dofs());
    for (double &entry : u)
      entry = random(-0.1, 0.1) * h;
    return u;
  }
} // namespace MeanDilatation

#endif
