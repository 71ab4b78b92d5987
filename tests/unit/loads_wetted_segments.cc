// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include "named.h"
#include "standing_water.h"
#include <cmath>
#include <gtest/gtest.h>

namespace loads_wetted_segments
{
  using namespace Waker;

  namespace
  {
    // Resultant of nodal forces in 2D.
    WaterResultant
    nodal_resultant(const BackgroundGrid<2> &grid, const NodalVector &force)
    {
      WaterResultant sum;
      for (unsigned int i = 0; i < grid.n_nodes(); ++i)
        {
          const Point<2> x  = grid.node_position(i);
          const double   fx = force.begin()[2 * i];
          const double   fy = force.begin()[2 * i + 1];
          sum.force[0] += fx;
          sum.force[1] += fy;
          sum.moment += x[0] * fy - x[1] * fx;
        }
      return sum;
    }

    WaterParameters
    water(const std::string &side, const double level)
    {
      WaterParameters parameters;
      parameters.side        = Named{side};
      parameters.level       = level;
      parameters.unit_weight = 9.81;
      return parameters;
    }

    Surface
    rectangle(const Point<2> &a, const Point<2> &b, const int base = 2)
    {
      SurfaceChain chain;
      chain.vertices = {a, Point<2>(b[0], a[1]), b, Point<2>(a[0], b[1])};
      chain.on_face  = {base, -1, -1, -1};
      return {{chain}};
    }
  } // namespace



  TEST(Loads, water_on_a_vertical_wall_is_hydrostatic)
  {
    const double            h = 0.5;
    const BackgroundGrid<2> grid(Point<2>(0, 0),
                                 Point<2>(6, 5),
                                 h,
                                 MPI_COMM_SELF);
    StandingWater<2>        load(grid, water("left", 3.));
    load.find(rectangle(Point<2>(2, 0), Point<2>(5, 4)));
    ASSERT_EQ(load.segments().size(), 1u);
    EXPECT_EQ(load.segments()[0].normal[0], -1.);
    EXPECT_EQ(load.segments()[0].vertices[1][1], 3.);

    NodalVector force(grid.n_dofs());
    load.add_nodal_forces(std::vector<double>(grid.n_nodes(), 1.), 1., force);

    const WaterResultant exact = load.resultant();
    const double         total = 9.81 * 9. / 2;
    EXPECT_NEAR(exact.force[0], total, 1e-12);
    EXPECT_NEAR(exact.force[1], 0., 1e-12);
    EXPECT_NEAR(exact.moment, -total * 1., 1e-12);
    const WaterResultant nodal = nodal_resultant(grid, force);
    EXPECT_NEAR(nodal.force[0], total, 1e-12);
    EXPECT_NEAR(nodal.moment, -total * 1., 1e-12);

    // Consistent nodal forces of a linear pressure: h p between the ends.
    for (unsigned int i = 0; i < grid.n_nodes(); ++i)
      {
        const Point<2> x  = grid.node_position(i);
        const double   fx = force.begin()[2 * i];
        if (std::abs(x[0] - 2) > 1e-12 || x[1] < 0 || x[1] > 3)
          {
            EXPECT_NEAR(fx, 0., 1e-12);
          }
        else if (x[1] > 0 && x[1] < 3)
          {
            EXPECT_NEAR(fx, 9.81 * h * (3 - x[1]), 1e-12);
          }
      }

    // On the other side it pushes the other way.
    StandingWater<2> right(grid, water("right", 3.));
    right.find(rectangle(Point<2>(2, 0), Point<2>(5, 4)));
    EXPECT_NEAR(right.resultant().force[0], -total, 1e-12);
    EXPECT_NEAR(right.resultant().moment, total * 1., 1e-12);
  }



  TEST(Loads, water_walks_from_the_toe_to_the_level)
  {
    const BackgroundGrid<2> grid(Point<2>(0, 0),
                                 Point<2>(20, 8),
                                 1.,
                                 MPI_COMM_SELF);

    // An outer berm with a dip behind it: once out of the water, stop.
    SurfaceChain chain;
    chain.vertices        = {Point<2>(1, 0),
                             Point<2>(19, 0),
                             Point<2>(12, 6),
                             Point<2>(9, 6),
                             Point<2>(7, 2),
                             Point<2>(4, 3)};
    chain.on_face         = {2, -1, -1, -1, -1, -1};
    const Surface surface = {{chain}};
    const auto    n_wet   = [&](const std::string &side, const double level) {
      StandingWater<2> load(grid, water(side, level));
      load.find(surface);
      return load.segments().size();
    };
    EXPECT_EQ(n_wet("left", 2.5), 1u);
    EXPECT_EQ(n_wet("left", 3.5), 3u);
    EXPECT_EQ(n_wet("right", 2.5), 1u);
    EXPECT_EQ(make_wet_surface(grid, WaterSide::none, SurfaceParameters()),
              nullptr);
    EXPECT_EQ(n_wet("left", 0.), 0u);
    EXPECT_EQ(n_wet("left", -1.), 0u);
    // A crest at the level keeps the water out, also if round-off lifts it.
    EXPECT_EQ(n_wet("left", 6.), 3u);
    EXPECT_EQ(n_wet("left", 6. + 1e-12), 3u);
    // Under water: to the base on the other side.
    EXPECT_EQ(n_wet("left", 7.), 5u);

    // A submerged body that touches nothing feels its buoyancy only.
    StandingWater<2> load(grid, water("left", 7.));
    load.find(rectangle(Point<2>(3, 1), Point<2>(5, 4), -1));
    EXPECT_EQ(load.segments().size(), 4u);
    EXPECT_NEAR(load.resultant().force[0], 0., 1e-12);
    EXPECT_NEAR(load.resultant().force[1], 9.81 * 6, 1e-12);
    EXPECT_NEAR(load.resultant().moment, 4 * 9.81 * 6, 1e-11);

    // One that sticks out of the water is wet on both sides if it is more than
    // a cell above the base; else it lies on it, and the water on one side.
    StandingWater<2> shallow(grid, water("left", 2.));
    shallow.find(rectangle(Point<2>(3, 1.25), Point<2>(5, 4), -1));
    EXPECT_EQ(shallow.segments().size(), 3u);
    EXPECT_NEAR(shallow.resultant().force[0], 0., 1e-12);
    EXPECT_NEAR(shallow.resultant().force[1], 9.81 * 2 * 0.75, 1e-12);
    shallow.find(rectangle(Point<2>(3, 0.75), Point<2>(5, 4), -1));
    EXPECT_EQ(shallow.segments().size(), 1u);
    EXPECT_NEAR(shallow.resultant().force[0], 9.81 * 1.25 * 1.25 / 2, 1e-12);

    // Ground that reaches the closed wall: loaded from where it leaves it.
    SurfaceChain ground;
    ground.vertices = {Point<2>(0, 0),
                       Point<2>(19, 0),
                       Point<2>(12, 6),
                       Point<2>(9, 6),
                       Point<2>(4, 2),
                       Point<2>(0, 2)};
    ground.on_face  = {2, -1, -1, -1, -1, 0};
    load.find(Surface{{ground}});
    ASSERT_GE(load.segments().size(), 2u);
    EXPECT_EQ(load.segments()[0].vertices[0], Point<2>(0, 2));
    EXPECT_EQ(load.segments()[0].normal[1], 1.);
  }



  TEST(Loads, parameters_of_the_water_are_read)
  {
    WaterParameters  parameters;
    ParameterHandler prm;
    parameters.add_parameters(prm);
    prm.parse_input_from_string("set Side = right\nset Level = -1.5\n"
                                "set Unit weight = 9.81\n"
                                "set Minimum support = 0.02\n");
    EXPECT_EQ(parameters.side, WaterSide::right);
    EXPECT_EQ(parameters.level, -1.5);
    EXPECT_EQ(parameters.unit_weight, 9.81);
    EXPECT_EQ(parameters.minimum_support, 0.02);
    using WrongValue = ParameterHandler::ExcInvalidEntryForPattern;
    EXPECT_THROW(prm.parse_input_from_string("set Side = up\n"), WrongValue);
    EXPECT_THROW(prm.parse_input_from_string("set Unit weight = -1\n"),
                 WrongValue);
    EXPECT_EQ(parameters.side, WaterSide::right);
    EXPECT_EQ(parameters.unit_weight, 9.81);
  }
} // namespace loads_wetted_segments
