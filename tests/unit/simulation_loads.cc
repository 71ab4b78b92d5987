// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/case/scene.h>
#include <waker/simulation/realisation.h>

#include "loaded_bar.h"
#include <cmath>
#include <gtest/gtest.h>

namespace simulation_loads
{
  using namespace Waker;

  namespace
  {
    template <int dim>
    double
    length(const std::vector<Point<dim>> &vertices)
    {
      double lowest = vertices[0][0], highest = vertices[0][0];
      for (const Point<dim> &x : vertices)
        {
          lowest  = std::min(lowest, x[0]);
          highest = std::max(highest, x[0]);
        }
      return highest - lowest;
    }


    void
    advance(const Case<2>     &the_case,
            State<2>          &state,
            const unsigned int n_steps)
    {
      Realisation<2> realisation(the_case, state);
      for (unsigned int step = 0; step < n_steps; ++step)
        {
          ASSERT_EQ(realisation.look(), StopReason::none);
          realisation.advance();
        }
      EXPECT_EQ(state.unconverged_steps, 0u);
    }


    /// A bar of 3 m, free, in balance with 1 kPa on both ends, that is then
    /// pressed by up to 11 kPa.
    void
    press(LoadedBar &bar)
    {
      bar.load("user surface");
      bar.parameters.tractions[0].value = "1 + 20*t";
      bar.parameters.time.scheme        = Scheme::quasi_static;
      bar.parameters.time.time_step     = 0.05;
      bar.parameters.time.end_time      = 1.;
      bar.parameters.stop.at_rest       = false;
      FixityParameters left;
      left.name   = "left";
      left.region = FixityRegion::left;
      left.type   = FixityType::roller;
      bar.parameters.fixities.push_back(left);
    }
  } // namespace


  // The user's surface moves with the material: what it encloses is what the
  // points have, and the load stays in balance with their stress.
  TEST(Simulation, users_surface_is_carried_along)
  {
    LoadedBar bar(0.);
    press(bar);
    const Case<2> the_case(bar.parameters, MPI_COMM_SELF);
    State<2>      state = initial_state(the_case);
    advance(the_case, state, 10);
    ASSERT_NEAR(state.time, 0.5, 1e-12);

    // 10 kPa on 1000 kPa, nu = 0: one per cent shorter, but for the terms of
    // second order.
    EXPECT_NEAR(length<2>(state.surface_vertices[0]), 3. * 0.99, 3. * 2e-4);
    for (std::size_t p = 0; p < state.points.n_points(); ++p)
      EXPECT_NEAR(state.points.stress[p][0][0], -11., 0.15);
  }


  // Half a run, to bytes and back, and the other half: the same as in one go.
  TEST(Simulation, carried_surface_survives_a_checkpoint)
  {
    LoadedBar bar(0.);
    press(bar);
    bar.load("fixed points");
    bar.parameters.tractions[1].facing = {1., 0.};
    const Case<2> the_case(bar.parameters, MPI_COMM_SELF);
    State<2>      whole = initial_state(the_case);
    advance(the_case, whole, 6);

    State<2> half = initial_state(the_case);
    advance(the_case, half, 3);
    State<2> resumed;
    resumed.read(half.write());
    ASSERT_EQ(resumed.surface_vertices.size(), 2u);
    ASSERT_EQ(resumed.surface_vertices[0].size(), 4u);
    ASSERT_GE(resumed.points.find_scalar("load_fixed points_x"), 0);
    advance(the_case, resumed, 3);
    EXPECT_EQ(resumed.surface_vertices, whole.surface_vertices);
    EXPECT_EQ(resumed.points.position, whole.points.position);
    EXPECT_EQ(resumed.points.stress, whole.points.stress);
    EXPECT_LT(length<2>(resumed.surface_vertices[0]), 2.999);
  }


  // Loads are those at the end of a step, on the surface at its start.
  TEST(Simulation, loads_are_taken_at_the_end_of_the_step)
  {
    LoadedBar bar(0.);
    press(bar);
    const Case<2>  the_case(bar.parameters, MPI_COMM_SELF);
    State<2>       state = initial_state(the_case);
    Realisation<2> realisation(the_case, state);
    realisation.look();
    const auto pull = [&]() {
      const NodalVector &f   = realisation.view().scene.nodes.external_force;
      double             sum = 0.;
      // On the right half; the other end's load is against the wall.
      for (unsigned int i = 0; i < the_case.grid.n_nodes(); ++i)
        if (the_case.grid.node_position(i)[0] > 1.5)
          sum += f.local_element(2 * i);
      return sum;
    };
    EXPECT_NEAR(pull(), -1., 1e-12);
    realisation.advance();
    EXPECT_NEAR(pull(), -2., 1e-12);
    realisation.look();
    EXPECT_NEAR(pull(), -2., 1e-12);
  }


  TEST(Simulation, end_time_zero_leaves_the_start)
  {
    LoadedBar bar(1.3);
    bar.load("contour");
    bar.parameters.time.end_time = 0.;
    bar.parameters.time.check();
    const Case<2>  the_case(bar.parameters, MPI_COMM_SELF);
    State<2>       state = initial_state(the_case);
    Realisation<2> realisation(the_case, state);
    EXPECT_EQ(realisation.look(), StopReason::end_time);
    // Internal and external force of the first files: in balance.
    const NodalState &nodes   = realisation.view().scene.nodes;
    double            largest = 0.;
    for (unsigned int i = 0; i < the_case.grid.n_dofs(); i += 2)
      {
        EXPECT_NEAR(nodes.internal_force.local_element(i),
                    nodes.external_force.local_element(i),
                    1e-13);
        largest =
          std::max(largest, std::abs(nodes.internal_force.local_element(i)));
      }
    EXPECT_GT(largest, 0.1);
  }


  // The level may rise: the load with it, but not the level at which the width
  // is measured.
  TEST(Simulation, water_rises)
  {
    LoadedBar bar(1.);
    bar.parameters.fixities.erase(bar.parameters.fixities.begin() + 1); // top
    bar.parameters.water.side            = WaterSide::left;
    bar.parameters.water.level           = 0.25;
    bar.parameters.water.rise            = "0: 0, 10: 0.5";
    bar.parameters.water.minimum_support = 0.;
    bar.parameters.surface.method        = SurfaceMethod::contour;
    const Case<2> the_case(bar.parameters, MPI_COMM_SELF);
    Scene<2>      scene(the_case);
    EXPECT_TRUE(scene.loads_move());
    scene.set(the_case.initial_points);
    EXPECT_NEAR(scene.water_resultant.force[0], 5. * 0.25 * 0.25, 1e-12);
    scene.set(the_case.initial_points, 10., initial_vertices(the_case));
    EXPECT_EQ(scene.water_level(10.), 0.75);
    EXPECT_NEAR(scene.water_resultant.force[0], 5. * 0.75 * 0.75, 1e-12);
  }


  // A detected surface may lie in cells without material: what it puts on their
  // nodes must not stop the solver of the static step.
  TEST(Long, simulation_gravity_step_in_space_under_a_detected_surface)
  {
    Parameters p;
    p.dimension         = 3;
    p.grid.lower_corner = {0., 0., 0.};
    p.grid.upper_corner = {4., 3., 3.};
    p.grid.cell_size    = 0.5;
    p.materials.resize(1);
    p.materials[0].name  = "soil";
    p.materials[0].model = MaterialModel::linear_elastic;
    p.layers.resize(1);
    p.layers[0].name     = "block";
    p.layers[0].material = "soil";
    p.layers[0].polygon  = "0,0; 2.2,0; 2.2,2; 0,2";
    p.layers[0].extent   = {0., 1.7};
    p.fixities.resize(1);
    p.fixities[0].name   = "base";
    p.fixities[0].region = FixityRegion::bottom;
    p.tractions.resize(1);
    p.tractions[0].name   = "load";
    p.tractions[0].method = TractionMethod::proximity_field;
    p.tractions[0].value  = "5";
    const Case<3> the_case(p, MPI_COMM_SELF);
    EXPECT_TRUE(the_case.gravity_report.converged);

    // The case is the one meant: a node without mass has a load.
    Scene<3> scene(the_case);
    scene.set(the_case.initial_points);
    const NodalVector &force  = *scene.tractions.view(0).nodal_force;
    double             beside = 0.;
    for (unsigned int i = 0; i < the_case.grid.n_dofs(); ++i)
      if (scene.nodes.mass[i / 3] == 0.)
        beside = std::max(beside, std::abs(force.local_element(i)));
    EXPECT_GT(beside, 0.);
  }
} // namespace simulation_loads
