// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/case/case.h>
#include <waker/case/scene.h>
#include <waker/program/parameter_reader.h>

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace loads_dyke_water
{
  using namespace Waker;


  // The dyke of chapter 5 with its water, moved along the grid by parts of a
  // cell: what reaches the nodes is the pressure on the surface that is seen.
  TEST(Loads, water_on_the_dyke_of_chapter_5_at_sub_cell_offsets)
  {
    const auto parameters =
      read_parameters(WAKER_SOURCE_DIRECTORY "/parameters/chapter5/dyke.prm",
                      {"Gravity/Initial stress=false"});
    const Case<2> dyke(*parameters, MPI_COMM_SELF);
    Scene<2>      scene(dyke);

    const double level   = parameters->water.level;
    const double gamma_w = parameters->water.unit_weight;
    const double thrust  = 0.5 * gamma_w * level * level;
    const double g       = parameters->gravity.acceleration;
    const double h       = parameters->grid.cell_size;
    const double least =
      parameters->water.minimum_support * dyke.full_node_mass;

    std::mt19937                           random(20231);
    std::uniform_real_distribution<double> uniform(0., h);
    MaterialPoints<2>                      points    = dyke.initial_points;
    unsigned int                           n_slivers = 0, n_loaded = 0;
    for (int k = 0; k < 1000; ++k)
      {
        const double shift = uniform(random);
        for (std::size_t p = 0; p < points.n_points(); ++p)
          points.position[p][0] = dyke.initial_points.position[p][0] + shift;
        scene.set(points);

        WaterResultant nodal;
        for (unsigned int i = 0; i < dyke.grid.n_nodes(); ++i)
          {
            const Point<2> x  = dyke.grid.node_position(i);
            const double   m  = scene.nodes.mass[i];
            const double   fx = scene.nodes.external_force.begin()[2 * i];
            const double   fy =
              scene.nodes.external_force.begin()[2 * i + 1] + m * g;
            nodal.force[0] += fx;
            nodal.force[1] += fy;
            nodal.moment += x[0] * fy - x[1] * fx;
            n_loaded += std::abs(fx) > 1e-9;
            if (m > 0. && m < least)
              {
                ++n_slivers;
                ASSERT_EQ(fx, 0.);
                ASSERT_NEAR(fy, 0., 1e-12);
              }
          }
        const WaterResultant &seen = scene.water_resultant;
        ASSERT_NEAR(nodal.force[0], seen.force[0], 1e-9 * thrust) << shift;
        ASSERT_NEAR(nodal.force[1], seen.force[1], 1e-9 * thrust) << shift;
        ASSERT_NEAR(nodal.moment, seen.moment, 1e-9 * thrust * level) << shift;

        // The horizontal thrust does not depend on the shape of the face. The
        // vertical one does: the slope is 1:1, and the toe is rounded off.
        ASSERT_NEAR(seen.force[0], thrust, 1e-9 * thrust) << shift;
        ASSERT_NEAR(seen.force[1], -thrust, gamma_w * level * h) << shift;
      }
    // Otherwise nothing has been shown.
    EXPECT_GT(n_slivers, 1000u);
    EXPECT_GT(n_loaded, 10000u);
  }
} // namespace loads_dyke_water
