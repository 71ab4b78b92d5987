// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/case/case.h>
#include <waker/case/scene.h>
#include <waker/particles/removal.h>

#include "loaded_block.h"
#include <gtest/gtest.h>

namespace loads_lost_load
{
  using namespace Waker;

  // Soil that leaves takes its share of the load with it, and it is noted.
  TEST(Loads, a_riding_load_on_soil_that_leaves)
  {
    LoadedBlock<2> block;
    block.load("contour", "3; -25");
    const Case<2>     the_case(block.parameters, MPI_COMM_SELF);
    MaterialPoints<2> points = the_case.initial_points;
    Scene<2>          scene(the_case);
    scene.set(points);
    std::vector<TractionRecord> records;
    scene.tractions.record(0., records);
    EXPECT_EQ(records[0].left_time, -1.);

    // Those left of x = 2 carry 0.3 m of 1.2 m.
    std::vector<std::size_t> leaving;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      if (points.position[p][0] < 2.)
        leaving.push_back(p);
    remove_points(leaving, points);
    scene.set(points, 1., initial_vertices(the_case));
    auto now = scene.tractions.resultant(0);
    EXPECT_NEAR(now.measure, 0.9, 1e-12);
    EXPECT_NEAR(now.force[1], -25. * 0.9, 1e-11);
    scene.tractions.record(1., records);
    EXPECT_EQ(records[0].left_time, 1.);
    EXPECT_EQ(records[0].empty_time, -1.);

    leaving.clear();
    for (std::size_t p = 0; p < points.n_points(); ++p)
      if (points.position[p][0] < 3.)
        leaving.push_back(p);
    remove_points(leaving, points);
    scene.set(points, 2., initial_vertices(the_case));
    now = scene.tractions.resultant(0);
    EXPECT_EQ(now.measure, 0.);
    EXPECT_EQ(now.force.norm(), 0.);
    scene.tractions.record(2., records);
    EXPECT_EQ(records[0].left_time, 1.);
    EXPECT_EQ(records[0].empty_time, 2.);
  }


  // A load that falls on nodes without soil is lost, and that is noted.
  TEST(Loads, a_load_beside_the_soil_is_noted)
  {
    LoadedBlock<2> block;
    block.load("user surface", "3; -25");
    block.load("user surface", "3; -25").minimum_support = 0.01;
    const Case<2>     the_case(block.parameters, MPI_COMM_SELF);
    MaterialPoints<2> points = the_case.initial_points;
    Scene<2>          scene(the_case);
    scene.set(points);
    std::vector<TractionRecord> records;
    scene.tractions.record(0., records);
    EXPECT_EQ(records[0].lost_time, -1.);
    // The soil sinks, its surface is left behind.
    for (Point<2> &x : points.position)
      x[1] -= 0.25;
    scene.set(points, 0., initial_vertices(the_case));
    scene.tractions.record(5., records);
    EXPECT_EQ(records[0].lost_time, -1.) << "the node above still has mass";
    for (Point<2> &x : points.position)
      x[1] -= 0.35;
    scene.set(points, 0., initial_vertices(the_case));
    scene.tractions.record(6., records);
    EXPECT_EQ(records[0].lost_time, 6.);
    EXPECT_EQ(records[1].lost_time, -1.);
    EXPECT_NEAR(scene.tractions.resultant(1).force[1], -25. * 1.2, 1e-11);
  }
} // namespace loads_lost_load
