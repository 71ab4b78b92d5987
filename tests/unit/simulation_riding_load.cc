// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/simulation/realisation.h>

#include "named.h"
#include <gtest/gtest.h>

namespace simulation_riding_load
{
  using namespace Waker;

  namespace
  {
    /// A crest of 3 m width and 1 m height, soft, with a footing on 1 m of it
    /// that presses it down by more than the thickness of the footing's box.
    Parameters
    crest(const std::string &kind, const std::string &value)
    {
      Parameters p;
      p.grid.lower_corner = {0., 0.};
      p.grid.upper_corner = {3., 1.5};
      p.grid.cell_size    = 0.25;
      p.materials.resize(1);
      p.materials[0].name                   = "soil";
      p.materials[0].model                  = MaterialModel::linear_elastic;
      p.materials[0].elastic.youngs_modulus = 200.;
      p.materials[0].elastic.poissons_ratio = 0.3;
      p.layers.resize(1);
      p.layers[0].name     = "crest";
      p.layers[0].material = "soil";
      p.layers[0].polygon  = "0, 0; 3, 0; 3, 1; 0, 1";
      for (const char *const region : {"left", "right", "bottom"})
        {
          FixityParameters fixity;
          fixity.name   = region;
          fixity.region = Named{region};
          fixity.type   = std::string(region) == "bottom" ? FixityType::fixed
                                                          : FixityType::roller;
          p.fixities.push_back(fixity);
        }
      p.gravity.acceleration   = 0.;
      p.gravity.initial_stress = false;
      p.tractions.resize(1);
      p.tractions[0].name   = "footing";
      p.tractions[0].method = TractionMethod::contour;
      p.tractions[0].kind   = Named{kind};
      p.tractions[0].value  = value;
      p.tractions[0].from   = {0.93, 0.98};
      p.tractions[0].to     = {2.07, 1.02};
      p.time.scheme         = Scheme::quasi_static;
      p.time.time_step      = 0.1;
      p.time.end_time       = 1.;
      p.stop.at_rest        = false;
      return p;
    }


    /// Force of the footing at each moment, from the first to the last.
    std::vector<Tensor<1, 2>>
    press(const Case<2> &the_case, State<2> &state, const unsigned int n_steps)
    {
      std::vector<Tensor<1, 2>> forces;
      Realisation<2>            realisation(the_case, state);
      for (unsigned int step = 0; step < n_steps; ++step)
        {
          EXPECT_EQ(realisation.look(), StopReason::none);
          const Scene<2> &scene = realisation.view().scene;
          forces.push_back(scene.tractions.resultant(0).force);
          realisation.advance();
        }
      return forces;
    }


    double
    lowest_crest(const State<2> &state)
    {
      double lowest = 10.;
      for (std::size_t p = 0; p < state.points.n_points(); ++p)
        if (state.points.initial_position[p][1] > 0.9)
          lowest = std::min(lowest,
                            state.points.position[p][1] -
                              state.points.initial_position[p][1]);
      return lowest;
    }
  } // namespace


  TEST(Simulation, a_footing_stays_on_a_crest_that_sinks)
  {
    const Case<2> the_case(crest("vector", "2*t; -40*t"), MPI_COMM_SELF);
    State<2>      state  = initial_state(the_case);
    const auto    forces = press(the_case, state, 9);
    EXPECT_LT(lowest_crest(state), -0.05); // out of the box
    for (unsigned int step = 1; step < forces.size(); ++step)
      {
        const double t = 0.1 * step;
        EXPECT_NEAR(forces[step][0], 2. * t * 1.14, 1e-12 * t * 45.);
        EXPECT_NEAR(forces[step][1], -40. * t * 1.14, 1e-12 * t * 45.);
      }
    EXPECT_EQ(state.tractions[0].empty_time, -1.);
  }


  // With the box in space, as it was before loads could ride: most of the load
  // is gone at some time.
  TEST(Simulation, a_footing_in_space_loses_a_crest_that_sinks)
  {
    Parameters p           = crest("vector", "0; -40*t");
    p.tractions[0].follows = TractionFollows::space;
    const Case<2> the_case(p, MPI_COMM_SELF);
    State<2>      state  = initial_state(the_case);
    const auto    forces = press(the_case, state, 9);
    // The contour of points that have sunk unevenly has steps: a little longer.
    EXPECT_NEAR(forces[1][1], -4. * 1.14, 0.02 * 4.56);
    double least = 1.; // of what it should be
    for (unsigned int step = 1; step < forces.size(); ++step)
      least = std::min(least, forces[step][1] / (-4. * step * 1.14));
    EXPECT_LT(least, 0.5);
  }


  // Half a run, to bytes and back, and the other half: the same bit for bit.
  TEST(Simulation, a_riding_pressure_survives_a_checkpoint)
  {
    const Case<2> the_case(crest("pressure", "40*t"), MPI_COMM_SELF);
    State<2>      whole = initial_state(the_case);
    EXPECT_GT(whole.surface_vertices.at(0).size(), 8u);
    const auto forces = press(the_case, whole, 8);

    State<2> half = initial_state(the_case);
    press(the_case, half, 4);
    State<2> resumed;
    resumed.read(half.write());
    const auto more = press(the_case, resumed, 4);
    for (unsigned int step = 0; step < 4; ++step)
      EXPECT_EQ(more[step], forces[4 + step]);
    EXPECT_EQ(resumed.surface_vertices, whole.surface_vertices);
    EXPECT_EQ(resumed.points.position, whole.points.position);
    EXPECT_EQ(resumed.points.stress, whole.points.stress);
    EXPECT_EQ(resumed.write(), whole.write());
    // Its place has moved, and it still presses downwards.
    EXPECT_LT(lowest_crest(whole), -0.03);
    EXPECT_NEAR(forces[7][1], -40. * 0.7 * 1.14, 0.1 * 32.);
  }
} // namespace simulation_riding_load
