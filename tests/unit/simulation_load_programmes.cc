// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/last_change.h>

#include "loaded_column.h"
#include "user_errors.h"
#include <cmath>
#include <gtest/gtest.h>

namespace simulation_load_programmes
{
  // Load programmes at work: settlement, reaction, energy, rest, resumption.

  using namespace Waker;

  namespace
  {
    constexpr double stiff = 1e5; // kPa: strains of a thousandth


    /// Settlement of the point nearest to a height at the start (m).
    double
    settlement_at(const State<2> &state, const double y)
    {
      const MaterialPoints<2> &points = state.points;
      std::size_t              best   = 0;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        if (std::abs(points.initial_position[p][1] - y) <
            std::abs(points.initial_position[best][1] - y))
          best = p;
      return points.initial_position[best][1] - points.position[best][1];
    }


    /// 0.4 m of soil in load steps: 8 kPa.
    LoadedColumn
    loaded_statically(const LoadedPoints which, const LoadMass mass)
    {
      LoadedColumn column;
      Parameters  &p                        = column.parameters;
      p.materials[0].elastic.youngs_modulus = stiff;
      p.time.scheme                         = Scheme::quasi_static;
      p.time.time_step                      = 0.1;
      p.time.end_time                       = 1.;
      column.load().rate                    = 0.5;
      column.load().up_to                   = "0.4";
      column.load().weight.points           = which;
      column.load().weight.mass             = mass;
      column.run();
      return column;
    }


    /// 2 m of soil in a second.
    LoadedColumn
    loaded_fast(const LoadedPoints which,
                const LoadMass     mass,
                const double       youngs_modulus,
                const double       time_step)
    {
      LoadedColumn column;
      Parameters  &p                        = column.parameters;
      p.materials[0].elastic.youngs_modulus = youngs_modulus;
      p.time.time_step                      = time_step;
      p.time.end_time                       = 1.;
      column.load().rate                    = 2.;
      column.load().weight.mass             = mass;
      column.load().weight.points           = which;
      column.run();
      return column;
    }
  } // namespace


  // One-dimensional and linear: sigma = q below the top row of points, or
  // q (1 - y/H) in the column. Met: 0.08 %, the in-situ stress by Young's
  // modulus (points keep their volume); and 0.8 % of the parabola, by 8 cells.
  TEST(Simulation, a_column_settles_under_a_weight_as_it_should)
  {
    constexpr double q = 0.4 * 20., E = stiff, H = 4.;
    constexpr double weight = 2. * (20. * H + q);
    for (const LoadMass mass : {LoadMass::weight_alone, LoadMass::with_mass})
      {
        SCOPED_TRACE(name_of(mass));
        const LoadedColumn top = loaded_statically(LoadedPoints::top, mass);
        EXPECT_NEAR(top.state.loads[0].factor, 0.4, 1e-14);
        EXPECT_NEAR(top.reaction, weight, 1e-6 * weight);
        for (const double y : {0.875, 1.875, 2.875})
          EXPECT_NEAR(settlement_at(top.state, y) / (q * y / E), 1., 0.003)
            << y;

        const LoadedColumn all = loaded_statically(LoadedPoints::column, mass);
        EXPECT_NEAR(all.reaction, weight, 1e-6 * weight);
        for (const double y : {0.875, 1.875, 2.875})
          EXPECT_NEAR(settlement_at(all.state, y) /
                        (q / (E * H) * (H * y - y * y / 2.)),
                      1.,
                      0.025)
            << y;
      }
  }


  TEST(Simulation, what_is_built_up_becomes_mass_or_not)
  {
    for (const LoadMass mass : {LoadMass::weight_alone, LoadMass::with_mass})
      for (const LoadedPoints which : {LoadedPoints::top, LoadedPoints::column})
        {
          const LoadedColumn column = loaded_statically(which, mass);
          const double       before = 2. * 4. * 20. / 9.81;
          const double       added  = 2. * 0.4 * 20. / 9.81;
          double             sum    = 0.;
          for (const double m : column.state.points.mass)
            sum += m;
          EXPECT_NEAR(sum,
                      before + (mass == LoadMass::with_mass ? added : 0.),
                      1e-11);
        }
  }


  // The factor counts what was built up, also where it has left with its
  // points.
  TEST(Simulation, a_load_knows_how_much_of_it_has_left)
  {
    LoadedColumn column =
      loaded_statically(LoadedPoints::top, LoadMass::weight_alone);
    const LoadProgrammes<2> programmes(column.parameters);
    MaterialPoints<2>      &points = column.state.points;
    EXPECT_NEAR(programmes.shares_lost(points).at(0), 0., 1e-12);
    // The column is 2 m wide; as if its left half had gone.
    double first = points.position[0][0], last = first;
    for (const Point<2> &x : points.position)
      {
        first = std::min(first, x[0]);
        last  = std::max(last, x[0]);
      }
    std::vector<double> &carried =
      points.scalar("programme_" + column.load().name);
    for (std::size_t p = 0; p < points.n_points(); ++p)
      if (points.position[p][0] < 0.5 * (first + last))
        carried[p] = 0.;
    EXPECT_NEAR(programmes.shares_lost(points).at(0), 0.5, 1e-12);
  }


  // The work of a load that grows, and the energy that mass brings along: what
  // is left is the method's, and falls with the step.
  TEST(Simulation, the_energy_account_closes_under_a_growing_weight)
  {
    for (const LoadMass mass : {LoadMass::weight_alone, LoadMass::with_mass})
      for (const LoadedPoints which : {LoadedPoints::top, LoadedPoints::column})
        {
          SCOPED_TRACE(std::string(name_of(mass)) + ", " + name_of(which));
          const LoadedColumn   column = loaded_fast(which, mass, 2e4, 0.01);
          const EnergyAccount &e      = column.state.energy;
          const double         work   = e.load_work + e.gravity_work;
          EXPECT_GT(work, 0.4);
          EXPECT_GT(e.kinetic, 0.);
          // Met: 1.0e-5 to 1.5e-5.
          EXPECT_LT(std::abs(e.remainder()), 5e-5 * work);
          if (mass == LoadMass::with_mass)
            {
              EXPECT_NEAR(column.state.flow.mass_in,
                          2. * 2. * 20. / 9.81,
                          1e-11);
              EXPECT_GT(e.inflow, 0.);
              // Whatever has come weighs: little is the load's own work.
              EXPECT_LT(std::abs(e.load_work), 0.01 * work);
            }
          else
            {
              EXPECT_EQ(e.inflow, 0.);
              EXPECT_GT(e.load_work, 0.15 * work);
            }

          // Soft, with larger strains and momentum that counts.
          const double coarse =
            loaded_fast(which, mass, 1e3, 0.01).state.energy.remainder();
          const double fine =
            loaded_fast(which, mass, 1e3, 0.005).state.energy.remainder();
          EXPECT_NEAR(fine / coarse, 0.5, 0.05);
        }
  }


  TEST(Simulation, half_the_step_gives_the_same_programme)
  {
    for (const double dt : {0.01, 0.005, 0.0025})
      {
        LoadedColumn column;
        column.parameters.time.time_step = dt;
        column.parameters.time.end_time  = 0.7;
        column.load().start_time         = 0.1;
        column.run();
        EXPECT_NEAR(column.state.loads[0].factor, 0.3, 1e-12) << dt;
        EXPECT_NEAR(column.state.loads[0].time, 0.7, 1e-12) << dt;
      }
  }


  // It is set moving by the load itself, and rings.
  TEST(Simulation, a_load_waits_while_the_column_moves)
  {
    LoadedColumn column;
    column.load().rate       = 1.;
    column.load().held_by    = Watched::largest_settlement_rate;
    column.load().hold_above = 0.05;
    column.load().stopped_by = Watched::settlement_of_load;
    column.load().stop_above = 0.05;
    const Case<2>  the_case(column.parameters, MPI_COMM_SELF);
    State<2>       state = initial_state(the_case);
    Realisation<2> realisation(the_case, state);
    unsigned int   n_held = 0, n_grown = 0;
    while (realisation.look() == StopReason::none)
      {
        const LoadRecord before = state.loads[0];
        const bool       fast   = state.settlement_rate > 0.05;
        EXPECT_EQ(before.held, fast && !before.is_stopped()) << state.time;
        realisation.advance();
        const double grown = state.loads[0].factor - before.factor;
        if (before.held || before.is_stopped())
          {
            EXPECT_EQ(grown, 0.) << state.time;
            ++n_held;
          }
        else
          {
            EXPECT_NEAR(grown, state.last_dt, 1e-14) << state.time;
            ++n_grown;
          }
      }
    EXPECT_GT(n_held, 5u);
    EXPECT_GT(n_grown, 5u);
    EXPECT_TRUE(state.loads[0].is_stopped());
    EXPECT_GT(watched_value(Watched::settlement_of_load,
                            Body<2>(state.points),
                            state.failure,
                            0.,
                            carried_load(column.load(), state.points)),
              0.025);
  }


  TEST(Simulation, a_state_goes_on_with_its_programme)
  {
    for (const LoadMass mass : {LoadMass::weight_alone, LoadMass::with_mass})
      {
        LoadedColumn column;
        column.load().rate              = 5.;
        column.load().held_by           = Watched::largest_settlement_rate;
        column.load().hold_above        = 0.02;
        column.load().stopped_by        = Watched::largest_settlement;
        column.load().stop_above        = 0.01;
        column.load().weight.mass       = mass;
        column.parameters.time.end_time = 0.6;
        const Case<2>  the_case(column.parameters, MPI_COMM_SELF);
        State<2>       whole = initial_state(the_case);
        Realisation<2> realisation(the_case, whole);
        std::string    bytes; // of a moment at which it waits
        while (realisation.look() == StopReason::none)
          {
            if (bytes.empty() && whole.step > 10 && whole.loads[0].held)
              bytes = whole.write();
            realisation.advance();
          }
        ASSERT_FALSE(bytes.empty());
        State<2> resumed;
        resumed.read(bytes);
        EXPECT_LT(resumed.time, 0.5);
        Realisation<2> rest(the_case, resumed);
        run_to_end(rest);
        EXPECT_EQ(resumed.write(), whole.write());
        EXPECT_GT(whole.loads[0].held_for, 0.);
      }
  }


  TEST(Simulation, a_programme_that_may_go_on_keeps_the_run_alive)
  {
    // 0.1 m of soil in 0.5 s; then the column has to rest for 0.2 s.
    LoadedColumn column;
    column.load().rate                   = 0.2;
    column.load().up_to                  = "0.1";
    column.parameters.stop.rest_duration = 0.2;
    column.parameters.time.end_time      = 3.;
    EXPECT_EQ(column.run(), StopReason::stable_at_rest);
    EXPECT_NEAR(column.state.time, 0.7, 0.015);
    EXPECT_EQ(outcome_of(column.state.failure, column.unrest), Outcome::stable);

    // It grows to the end, or would.
    column.load().up_to             = "none";
    column.parameters.time.end_time = 1.;
    EXPECT_EQ(column.run(), StopReason::end_time);
    EXPECT_TRUE(column.unrest.loads_change);
    EXPECT_EQ(outcome_of(column.state.failure, column.unrest),
              Outcome::loads_change);
    // Stopped for good is a last change.
    column.load().stopped_by        = Watched::largest_settlement;
    column.load().stop_above        = 1e-4;
    column.parameters.time.end_time = 3.;
    EXPECT_EQ(column.run(), StopReason::stable_at_rest);
    EXPECT_TRUE(column.state.loads[0].is_stopped());
    EXPECT_GT(column.state.time,
              column.state.loads[0].change_time + 0.2 - 0.015);
    EXPECT_LT(column.state.time, 1.);
    EXPECT_EQ(outcome_of(column.state.failure, column.unrest), Outcome::stable);

    // A table of time is known; a word that is not true is refused.
    column.load().stopped_by = Watched::nothing;
    column.load().kind       = LoadProgrammeKind::table_of_time;
    column.load().table      = "0: 0, 0.5: 0.1";
    EXPECT_EQ(column.run(), StopReason::stable_at_rest);
    EXPECT_NEAR(column.state.time, 0.7, 0.015);
    EXPECT_NEAR(column.state.loads[0].factor, 0.1, 1e-15);
    column.parameters.stop.loads_constant_from = "0.4";
    EXPECT_USER_ERROR(column.run(),
                      "Stop rules/Loads constant from",
                      "Load programmes/surcharge/Table changes");
  }


  TEST(Simulation, programmes_that_watch_what_is_not_there_are_refused)
  {
    const std::string path = "Load programmes/surcharge/";
    LoadedColumn      column;
    column.parameters.time.end_time = 0.05;
    column.load().stopped_by        = Watched::plastic_strain;
    column.load().stop_above        = 0.1;
    EXPECT_USER_ERROR(column.run(), path + "Stopped by", "no material has any");
    column.load().stopped_by = Watched::loss_of_width;
    EXPECT_USER_ERROR(column.run(), path + "Stopped by", "no dyke");
    column.parameters.water.level = 2.;
    column.run();
    column.load().stopped_by = Watched::loss_of_height;
    column.run();

    // No soil: nothing settles, and nothing can be loaded.
    LoadedColumn empty;
    empty.load().drives = LoadTarget::traction;
    empty.load().load   = "push";
    EXPECT_USER_ERROR(empty.run(), path + "Load", "none of Tractions/Names");
    empty.load().drives = LoadTarget::point_load;
    EXPECT_USER_ERROR(empty.run(), path + "Load", "none of Point loads/Names");
    empty.load().drives = LoadTarget::water;
    EXPECT_USER_ERROR(empty.run(), path + "Drives", "Water/Side is none");
    empty.load().drives                   = LoadTarget::weight;
    empty.load().weight.mass              = LoadMass::with_mass;
    empty.parameters.gravity.acceleration = 0.;
    EXPECT_USER_ERROR(empty.run(), path + "Mass", "no weight");
  }
} // namespace simulation_load_programmes
