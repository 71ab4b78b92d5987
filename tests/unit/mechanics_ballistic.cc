// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/simulation/realisation.h>

#include "mapping_lattice.h"
#include "named.h"
#include "verification_data.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iomanip>
#include <sstream>

namespace mechanics_ballistic
{
  // A block in free flight, and a block at rest: whole steps of a realisation.

  using namespace Waker;

  namespace
  {
    /// A block of 0.5 m without supports in a grid of 5 m.
    template <int dim>
    Parameters
    flight(const Tensor<1, dim> &velocity)
    {
      Parameters p;
      p.dimension         = dim;
      p.grid.lower_corner = std::vector<double>(dim, 0.);
      p.grid.upper_corner = std::vector<double>(dim, dim == 2 ? 6. : 4.);
      p.grid.cell_size    = 0.25;
      p.materials.resize(1);
      p.materials[0].name  = "rubber";
      p.materials[0].model = MaterialModel::linear_elastic;
      p.layers.resize(1);
      p.layers[0].name     = "block";
      p.layers[0].material = "rubber";
      const double       a = dim == 2 ? 2.75 : 1.75; // in the middle
      std::ostringstream polygon;
      const double       b = a + 0.5;
      polygon << a << ", " << a << "; " << b << ", " << a << "; " << b << ", "
              << b << "; " << a << ", " << b;
      p.layers[0].polygon = polygon.str();
      if (dim == 3)
        p.layers[0].extent = {a, b};
      std::ostringstream speed;
      for (unsigned int d = 0; d < dim; ++d)
        speed << (d == 0 ? "" : "; ") << std::setprecision(17) << velocity[d];
      p.layers[0].velocity     = speed.str();
      p.gravity.initial_stress = false;
      p.time.ramp_duration     = 0.;
      p.time.time_step         = 0.01;
      p.time.end_time          = 0.5;
      p.stop.at_rest           = false;
      return p;
    }


    struct Errors
    {
      double place    = 0.; // m, from the parabola
      double velocity = 0.; // m/s
      double stress   = 0.; // kPa
      double way      = 0.; // m, travelled at the end
      double time     = 0.; // s, at the end
      double dt       = 0.; // s, the last one
    };


    /// Let it fly, and compare all points with the parabola at all times.
    template <int dim>
    Errors
    fly(const Parameters &parameters, const Tensor<1, dim> &velocity)
    {
      const Case<dim>  the_case(parameters, MPI_COMM_SELF);
      State<dim>       state = initial_state(the_case);
      Realisation<dim> realisation(the_case, state);
      Tensor<1, dim>   g;
      g[1] = -parameters.gravity.acceleration;
      Tensor<1, dim> leapfrog; // what the explicit scheme must do
      Errors         e;
      while (realisation.look() == StopReason::none)
        {
          const double before = state.time;
          realisation.advance();
          const double t = state.time;
          e.dt           = t - before;
          e.time         = t;
          leapfrog += e.dt * (velocity + t * g);
          const Tensor<1, dim> way =
            parameters.time.scheme == Scheme::explicit_steps
              ? leapfrog
              : t * velocity + 0.5 * t * t * g;
          for (unsigned int p = 0; p < state.points.n_points(); ++p)
            {
              e.place = std::max(e.place,
                                 (state.points.position[p] -
                                  state.points.initial_position[p] - way)
                                   .norm());
              e.velocity =
                std::max(e.velocity,
                         (state.points.velocity[p] - velocity - t * g).norm());
              e.stress = std::max(e.stress, state.points.stress[p].norm());
            }
          e.way = way.norm();
        }
      EXPECT_EQ(state.unconverged_steps, 0u);
      EXPECT_EQ(state.halvings, 0u);
      return e;
    }


    template <int dim>
    void
    check_flight(const std::string &scheme,
                 const std::string &functions,
                 const double       gravity,
                 const bool         predictor)
    {
      Lattice::Random random(101 + dim);
      Errors          worst;
      for (unsigned int throw_number = 0; throw_number < 6; ++throw_number)
        {
          // Any direction; up enough to stay on the grid.
          Tensor<1, dim> v = random.vector<dim>(-1., 1.);
          v *= (dim == 2 ? 4. : 2.5) / v.norm();
          v[1] += 0.25 * gravity;
          Parameters p = flight(v);
          if (dim == 3)
            p.time.end_time = 0.4;
          p.time.scheme          = Named{scheme};
          p.mapping.functions    = Named{functions};
          p.gravity.acceleration = gravity;
          p.newton.predictor     = predictor;
          if (!predictor)
            {
              p.newton.tolerance        = 1e-13;
              p.newton.linear_tolerance = 1e-13;
            }
          const Errors e = fly<dim>(p, v);
          EXPECT_GT(e.way, 0.8) << v; // across cells
          worst.place    = std::max(worst.place, e.place);
          worst.velocity = std::max(worst.velocity, e.velocity);
          worst.stress   = std::max(worst.stress, e.stress);
        }
      EXPECT_LT(worst.place, 1e-11) << scheme << ' ' << functions << ' ' << dim;
      EXPECT_LT(worst.velocity, 2e-10)
        << scheme << ' ' << functions << ' ' << dim;
      // Round-off of places, over h, times the bulk modulus.
      EXPECT_LT(worst.stress, 4e-8) << scheme << ' ' << functions << ' ' << dim;
      Verification::row("patch_rotation_flight",
                        "scheme,functions,dimension,gravity,predictor,"
                        "largest place error (m),velocity error (m/s),"
                        "stress (kPa)",
                        scheme,
                        functions,
                        dim,
                        gravity,
                        predictor,
                        worst.place,
                        worst.velocity,
                        worst.stress);
    }


    /// A block of 1 m on a fixed base, after the gravity step.
    template <int dim>
    void
    check_rest(const std::string &scheme)
    {
      Parameters p             = flight(Tensor<1, dim>());
      p.grid.upper_corner      = std::vector<double>(dim, 1.5);
      p.layers[0].polygon      = "0.3, 0; 1.3, 0; 1.2, 0.9; 0.3, 1";
      p.layers[0].extent       = {};
      p.gravity.initial_stress = true;
      p.gravity.tolerance      = 1e-11;
      p.fixities.resize(dim == 2 ? 1 : 3);
      p.fixities[0].name = "base";
      if (dim == 3)
        {
          p.fixities[1].name   = "back";
          p.fixities[1].region = FixityRegion::back;
          p.fixities[2].name   = "front";
          p.fixities[2].region = FixityRegion::front;
          p.fixities[1].type = p.fixities[2].type = FixityType::roller;
        }
      p.time.scheme   = Named{scheme};
      p.time.end_time = 0.05;

      const Case<dim>  the_case(p, MPI_COMM_SELF);
      State<dim>       state = initial_state(the_case);
      Realisation<dim> realisation(the_case, state);
      EXPECT_TRUE(the_case.gravity_report.converged);
      double weight = 0.;
      for (const double m : state.points.mass)
        weight += 9.81 * m;
      // 15 kN/m^3 on a trapezium of 0.9 m^2, 1.5 m deep in 3D.
      EXPECT_NEAR(weight, 15. * 0.9 * (dim == 2 ? 1. : 1.5), 1e-13 * weight);

      double worst = 0.;
      while (realisation.look() == StopReason::none)
        {
          realisation.advance();
          Tensor<1, dim> rest = realisation.view().report.reaction;
          rest[1] -= weight;
          worst = std::max(worst, rest.norm() / weight);
        }
      EXPECT_LT(worst, 1e-11) << scheme;
      EXPECT_GE(state.step, 5u);
      EXPECT_EQ(state.unconverged_steps, 0u);
      double moved = 0.;
      for (unsigned int q = 0; q < state.points.n_points(); ++q)
        moved = std::max(
          moved,
          (state.points.position[q] - state.points.initial_position[q]).norm());
      EXPECT_LT(moved, 1e-12) << scheme;
      Verification::row("patch_rotation_rest",
                        "scheme,dimension,steps,weight (kN),"
                        "largest relative error of the reaction,"
                        "largest displacement (m)",
                        scheme,
                        dim,
                        state.step,
                        weight,
                        worst,
                        moved);
    }
  } // namespace


  TEST(Mechanics, a_block_flies_on_the_exact_parabola)
  {
    for (const std::string functions : {"GIMP", "linear"})
      {
        check_flight<2>("Newmark", functions, 9.81, true);
        check_flight<3>("Newmark", functions, 9.81, true);
        check_flight<2>("Newmark", functions, 9.81, false);
      }
  }


  TEST(Mechanics, the_ramp_lets_weight_come_linearly)
  {
    for (const std::string scheme : {"Newmark", "explicit"})
      {
        const bool is_explicit    = scheme == name_of(Scheme::explicit_steps);
        Parameters p              = flight(Tensor<1, 2>());
        p.time.scheme             = Named{scheme};
        p.time.ramp_duration      = 0.2;
        p.newton.tolerance        = 1e-13;
        p.newton.linear_tolerance = 1e-13;
        const Case<2>  the_case(p, MPI_COMM_SELF);
        State<2>       state = initial_state(the_case);
        Realisation<2> fall(the_case, state);
        double         a = 0., v = 0., y = 0., worst = 0.;
        while (fall.look() == StopReason::none)
          {
            const double before = state.time;
            fall.advance();
            const double dt    = state.time - before;
            const double new_a = -9.81 * std::min(1., state.time / 0.2);
            const double new_v =
              v + dt * (is_explicit ? new_a : (a + new_a) / 2);
            y += dt * (is_explicit ? new_v : (v + new_v) / 2);
            a = new_a;
            v = new_v;
            for (unsigned int q = 0; q < state.points.n_points(); ++q)
              worst = std::max({worst,
                                std::abs(state.points.velocity[q][1] - v),
                                std::abs(state.points.position[q][1] - y -
                                         state.points.initial_position[q][1])});
          }
        EXPECT_LT(worst, 1e-11) << scheme;
        EXPECT_LT(v, -3.5); // most of the fall is behind the ramp
      }
  }


  TEST(Mechanics, an_explicit_step_is_a_share_of_a_cell_at_the_speed_of_waves)
  {
    // c = sqrt(E (1 - nu) / ((1 + nu) (1 - 2 nu) rho)); the block moves at 5
    // m/s.
    Parameters p                = flight(Tensor<1, 2>({3., 4.}));
    p.time.scheme               = Scheme::explicit_steps;
    p.time.courant_number       = 0.4;
    const MaterialParameters &m = p.materials[0];
    const double   E = m.elastic.youngs_modulus, nu = m.elastic.poissons_ratio;
    const double   c = std::sqrt(E * (1. - nu) / ((1. + nu) * (1. - 2. * nu)) /
                               (m.unit_weight / 9.81));
    const Case<2>  the_case(p, MPI_COMM_SELF);
    State<2>       state = initial_state(the_case);
    Realisation<2> realisation(the_case, state);
    realisation.look();
    realisation.advance();
    EXPECT_GT(c, 10.);
    EXPECT_NEAR(state.time, 0.4 * 0.25 / (c + 5.), 1e-12);
  }


  TEST(Mechanics, an_explicit_block_flies_on_its_parabola)
  {
    // Symplectic Euler: exact velocities, places half a step's fall behind.
    for (const std::string functions : {"GIMP", "linear"})
      {
        check_flight<2>("explicit", functions, 9.81, true);
        check_flight<3>("explicit", functions, 9.81, true);
      }
  }


  TEST(Mechanics, a_block_without_weight_flies_straight)
  {
    check_flight<2>("Newmark", "GIMP", 0., true);
    check_flight<2>("explicit", "GIMP", 0., true);
  }


  TEST(Mechanics, the_base_of_a_block_at_rest_carries_its_weight)
  {
    for (const std::string scheme : {"Newmark", "explicit"})
      {
        check_rest<2>(scheme);
        check_rest<3>(scheme);
      }
  }
} // namespace mechanics_ballistic
