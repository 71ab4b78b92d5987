// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/simulation/run_to_end.h>

#include "loaded_bar.h"
#include <cmath>
#include <gtest/gtest.h>

namespace case_driven_loads
{
  // What a programme drives, against the same load without one.

  using namespace Waker;

  namespace
  {
    LoadProgrammeParameters
    by_time(const LoadTarget   drives,
            const std::string &load,
            const std::string &table)
    {
      LoadProgrammeParameters p;
      p.name   = "programme";
      p.drives = drives;
      p.load   = load;
      p.kind   = LoadProgrammeKind::table_of_time;
      p.table  = table;
      return p;
    }


    State<2>
    run(const Parameters &parameters)
    {
      parameters.check();
      const Case<2>  the_case(parameters, MPI_COMM_SELF);
      State<2>       state = initial_state(the_case);
      Realisation<2> realisation(the_case, state);
      run_to_end(realisation);
      return state;
    }


    double
    largest_difference(const State<2> &a, const State<2> &b)
    {
      double largest = 0.;
      for (std::size_t p = 0; p < a.points.n_points(); ++p)
        largest = std::max(largest,
                           a.points.position[p].distance(b.points.position[p]));
      return largest;
    }


    double
    largest_displacement(const State<2> &state)
    {
      double largest = 0.;
      for (std::size_t p = 0; p < state.points.n_points(); ++p)
        largest = std::max(largest,
                           state.points.position[p].distance(
                             state.points.initial_position[p]));
      return largest;
    }


    /// Nodal forces of a case at t = 0, without weight.
    NodalVector
    external_force(const Parameters &parameters)
    {
      const Case<2> the_case(parameters, MPI_COMM_SELF);
      Scene<2>      scene(the_case);
      scene.set(the_case.initial_points);
      return scene.nodes.external_force;
    }


    /// An elastic block of 3 x 1 m against the right end of its box, with water
    /// of 0.25 m on its left.
    Parameters
    block_in_water(LoadedBar &bar)
    {
      Parameters &p              = bar.parameters;
      p.layers[0].initial_stress = "";
      p.fixities[1].name         = "right";
      p.fixities[1].region       = FixityRegion::right;
      p.surface.method           = SurfaceMethod::contour;
      p.water.side               = WaterSide::left;
      p.water.level              = 0.25;
      p.time.time_step           = 0.02;
      p.time.end_time            = 1.;
      p.time.ramp_duration       = 0.;
      return p;
    }
  } // namespace


  TEST(Case, a_driven_traction_is_one_that_depends_on_time)
  {
    for (const char *const method :
         {"contour", "proximity field", "user surface", "updated points"})
      {
        SCOPED_TRACE(method);
        LoadedBar   bar(1.5);
        Parameters &p        = bar.parameters;
        p.time.time_step     = 0.02;
        p.time.end_time      = 0.4;
        p.time.ramp_duration = 0.;
        bar.load(method);
        p.tractions[0].value      = "t < 0.1 ? 0 : 5*(t - 0.1)";
        const State<2> expression = run(p);
        p.tractions[0].value      = "2.5";
        p.load_programmes         = {
                  by_time(LoadTarget::traction, method, "0: 0, 0.1: 0, 1.1: 2")};
        const State<2> driven = run(p);
        EXPECT_GT(largest_displacement(driven), 2e-4);
        EXPECT_LT(largest_difference(expression, driven), 1e-14);
        EXPECT_NEAR(driven.loads[0].factor, 0.6, 1e-14);
        EXPECT_NEAR(driven.energy.load_work,
                    expression.energy.load_work,
                    1e-13);
      }
  }


  TEST(Case, driven_loads_of_points_are_so_much_of_them)
  {
    LoadedBar bar(1.5);
    bar.load("fixed points");
    Parameters &p     = bar.parameters;
    NodalVector whole = external_force(p);
    p.load_programmes = {
      by_time(LoadTarget::traction, "fixed points", "0: 0.25, 1: 9")};
    NodalVector part = external_force(p);
    EXPECT_GT(whole.l2_norm(), 0.5);
    part *= 4.;
    part -= whole;
    EXPECT_LT(part.linfty_norm(), 1e-14);

    // What the points carry is what they were given, and the factor now.
    const auto sum_of_loads = [&p](const double time) {
      const Case<2> the_case(p, MPI_COMM_SELF);
      Scene<2>      scene(the_case);
      scene.set(the_case.initial_points, time, initial_vertices(the_case));
      double sum = 0.;
      for (const Tensor<1, 2> &f : *scene.tractions.view(0).point_loads)
        sum += f.norm();
      return sum;
    };
    const double later = sum_of_loads(0.5);
    p.load_programmes.clear();
    EXPECT_GT(sum_of_loads(0.), 1.);
    EXPECT_NEAR(later / sum_of_loads(0.), 0.5 * (0.25 + 9.), 1e-12);

    p.tractions.clear();
    PointLoadParameters load;
    load.name         = "tip";
    load.from         = {4., 0.};
    load.to           = {4.5, 1.};
    load.force        = {3., -1.};
    p.point_loads     = {load};
    whole             = external_force(p);
    p.load_programmes = {
      by_time(LoadTarget::point_load, "tip", "0: 0.25, 1: 9")};
    part = external_force(p);
    EXPECT_GT(whole.l2_norm(), 0.5);
    part *= 4.;
    part -= whole;
    EXPECT_LT(part.linfty_norm(), 1e-14);
  }


  TEST(Case, a_driven_rise_is_a_rise)
  {
    LoadedBar  bar(3.);
    Parameters p          = block_in_water(bar);
    p.water.rise          = "0: 0, 0.2: 0, 0.7: 0.5";
    const State<2> rise   = run(p);
    p.load_programmes     = {by_time(LoadTarget::water, "", p.water.rise)};
    p.water.rise          = "0";
    const State<2> driven = run(p);
    EXPECT_GT(largest_displacement(driven), 1e-4);
    EXPECT_EQ(largest_difference(rise, driven), 0.);
    EXPECT_EQ(rise.energy.load_work, driven.energy.load_work);
    EXPECT_EQ(driven.loads[0].factor, 0.5);

    // Both together.
    p.water.rise               = "0: 0, 0.2: 0, 0.7: 0.25";
    p.load_programmes[0].table = p.water.rise;
    EXPECT_LT(largest_difference(rise, run(p)), 1e-14);
  }


  TEST(Case, water_waits_while_the_body_moves)
  {
    LoadedBar  bar(3.);
    Parameters p = block_in_water(bar);
    // The bulge under the pressure rises; what it sinks by afterwards counts.
    LoadProgrammeParameters flood;
    flood.name        = "flood";
    flood.drives      = LoadTarget::water;
    flood.rate        = 4.;
    flood.up_to       = "0.5";
    flood.held_by     = Watched::largest_settlement_rate;
    flood.hold_above  = 1e-3;
    p.load_programmes = {flood};
    p.time.time_step  = 0.01;
    p.time.end_time   = 3.;
    const Case<2>  the_case(p, MPI_COMM_SELF);
    State<2>       state = initial_state(the_case);
    Realisation<2> realisation(the_case, state);
    unsigned int   n_held = 0;
    while (realisation.look() == StopReason::none)
      {
        EXPECT_NEAR(realisation.view().scene.water_level(state.time),
                    0.25 + state.loads[0].factor,
                    1e-14);
        n_held += state.loads[0].held;
        realisation.advance();
      }
    EXPECT_GT(n_held, 0u);
    EXPECT_EQ(state.loads[0].factor, 0.5);
    EXPECT_NEAR(state.loads[0].held_for, 0.01 * n_held, 1e-12);
    // It came as much later as it waited.
    EXPECT_NEAR(state.loads[0].change_time, 0.125 + 0.01 * n_held, 0.0051);
    EXPECT_LT(state.loads[0].change_time, state.time);
  }
} // namespace case_driven_loads
