// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/grid/partition.h>
#include <waker/materials/factory.h>
#include <waker/mechanics/nonlocal_softening.h>
#include <waker/mechanics/stress_update.h>
#include <waker/particles/point_exchange.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>

// Of one rank and, by tests/cases/ranks.py, of several.

namespace mechanics_nonlocal_of_ranks
{
  using namespace Waker;

  /// Clay with elastic points among it, a part of which has strained. Points of
  /// each rank soften as those of the whole do, to the bit, though the reach is
  /// that of several parts.
  template <int dim>
  void
  check(const double length, const double moved)
  {
    const double        h    = 0.25;
    BackgroundGrid<dim> grid = Lattice::grid<dim>(3., h);
    MaterialParameters  clay;
    clay.name            = "clay";
    clay.regularisation  = Regularisation::nonlocal;
    clay.nonlocal.length = length;
    Materials materials;
    materials.push_back(make_material(clay, 9.81, h));
    materials.push_back(std::make_unique<LinearElastic>(1.5, 400., 0.2));
    Point<dim> lower;
    for (unsigned int d = 0; d < dim; ++d)
      lower[d] = 0.1;
    MaterialPoints<dim> whole =
      Lattice::box(lower, dim == 2 ? 20 : 10, 0.5 * h);
    Lattice::Random     random(7);
    std::vector<double> increments;
    for (unsigned int p = 0; p < whole.n_points(); ++p)
      {
        whole.volume[p] *= random(0.5, 1.5);
        if (p % 9 == 0)
          whole.material[p] = 1;
        increments.push_back(
          p % 5 < 2 && whole.position[p][1] < 0.9 ? random(0., 0.1) : 0.);
      }
    declare_material_variables(materials, whole);
    whole.scalar("increment") = increments;
    std::vector<std::vector<int>> arrays(2);
    for (const MaterialVariable &variable : materials[0]->variables())
      arrays[0].push_back(whole.find_scalar(variable.name));

    Partition<dim>     partition(grid, MPI_COMM_WORLD);
    PointExchange<dim> exchange(partition, MPI_COMM_WORLD, whole);
    partition.balance(exchange.own().position);
    exchange.send_home(partition);
    MaterialPoints<dim> &own = exchange.own();
    // Points may have moved since they went home.
    for (MaterialPoints<dim> *const points : {&whole, &own})
      for (unsigned int p = 0; p < points->n_points(); ++p)
        for (unsigned int d = 0; d < dim; ++d)
          points->position[p][d] += moved * ((points->id[p] * (d + 3)) % 11);

    const auto             window = partition.make_window();
    NonlocalSoftening<dim> one(materials), many(materials);
    one.soften(increments, arrays, grid, whole);
    many.soften(own.scalar("increment"), arrays, *window, own);
    unsigned int n_soft = 0;
    const auto  &softer = whole.scalar("undrained shear strength");
    for (unsigned int p = 0; p < own.n_points(); ++p)
      for (const int a : arrays[0])
        EXPECT_EQ(own.scalars[a].values[p], whole.scalars[a].values[own.id[p]]);
    for (unsigned int p = 0; p < whole.n_points(); ++p)
      n_soft += softer[p] < 13.;
    EXPECT_GT(n_soft, whole.n_points() / 9);
    EXPECT_LT(n_soft, whole.n_points());
  }


  TEST(Ranks, SofteningBySurroundingsIsThatOfTheWhole)
  {
    for (const double length : {0.07, 0.4})
      for (const double moved : {0., 0.013})
        {
          check<2>(length, moved);
          check<3>(length, moved);
        }
  }
} // namespace mechanics_nonlocal_of_ranks
