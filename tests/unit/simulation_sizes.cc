// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/case/sizes.h>
#include <waker/simulation/plausibility.h>

#include "campaign_random_dyke.h"
#include "warnings.h"
#include <gtest/gtest.h>

namespace simulation_sizes
{
  // Sizes that follow from input: refused with the number before anything of
  // that size is made. Only such are tried that no machine has the memory for.

  using namespace Waker;
  using namespace RandomDyke;

  namespace
  {
    /// The error of reading and setting up the coarse dyke with these settings.
    void
    expect_refusal(const std::vector<std::string> &settings,
                   const std::string              &where,
                   const std::string              &problem)
    {
      try
        {
          const auto    input = read_scenarios(base_case, settings);
          const Case<2> the_case(input[0]->simulation, MPI_COMM_SELF);
          const RandomProperties<2> properties(the_case,
                                               input[0]->reliability.fields);
          ADD_FAILURE() << settings[0] << " is accepted";
        }
      catch (const UserError &error)
        {
          const std::string text = error.what();
          EXPECT_NE(text.find(where), std::string::npos) << text;
          EXPECT_NE(text.find(problem), std::string::npos) << text;
        }
    }
  } // namespace


  TEST(Sizes, of_a_grid_are_refused)
  {
    const std::string where    = "Grid/Cell size",
                      unknowns = " unknowns on the grid";
    expect_refusal({"Grid/Upper corner=1070000000, 6"}, where, unknowns);
    expect_refusal({"Grid/Upper corner=3e9, 6"}, where, unknowns);
    expect_refusal({"Grid/Upper corner=1e300, 6"}, where, unknowns);
    expect_refusal({"Grid/Cell size=1e-4"}, where, "5.76e+10" + unknowns);
    expect_refusal({"Grid/Cell size=1e-300"}, where, unknowns);
    expect_refusal({"Grid/Lower corner=1e12, 0",
                    "Grid/Upper corner=1000000000048, 6"},
                   where,
                   "too far from 0");
  }


  TEST(Sizes, of_fields_are_refused)
  {
    const std::string coarser = "Grid/Cell size=0.5";
    expect_refusal({field + "Cell size=1e-14, 3", coarser},
                   "Random fields/strength/Cell size",
                   "e+15 cells of the field along x");
    expect_refusal({field + "Cell size=1e-6, 1e-6", coarser},
                   "Random fields/strength/Cell size",
                   "cells of the field (");
    expect_refusal({field + "Scales of fluctuation=1e-14, 1", coarser},
                   "Random fields/strength/Scales of fluctuation",
                   "contains 1e-14 m");
    expect_refusal({field + "Scales of fluctuation=24, 1e-14", coarser},
                   "Random fields/strength/Scales of fluctuation",
                   "m long along y");
  }


  TEST(Sizes, of_what_is_counted_and_written_are_refused)
  {
    const std::string coarser = "Grid/Cell size=0.5";
    expect_refusal({"Histograms/Width bin=1e-9", coarser},
                   "Histograms/Width bin",
                   "4.8e+10 bins");
    expect_refusal({"Histograms/Height bin=1e-300", coarser},
                   "Histograms/Height bin",
                   "6e+300 bins");
    expect_refusal({"Histograms/Resistance bin=1e-9", coarser},
                   "Histograms/Resistance bin",
                   "bins");
    expect_refusal({"Campaign/Realisations=2147483647", coarser},
                   "Campaign/Realisations",
                   "2.15e+09 realisations");
    expect_refusal({"Campaign/Realisations=60000000",
                    "Sweep/Parameter=Water/Level",
                    "Sweep/Values=4; 4.5",
                    coarser},
                   "Campaign/Realisations",
                   "1.2e+08 realisations in all scenarios");
    expect_refusal({"Time stepping/Time step=1e-12", coarser},
                   "Time stepping/Time step",
                   "4e+13 steps");
    expect_refusal({"Time stepping/End time=1e14", coarser},
                   "Time stepping/Time step",
                   "1e+16 steps");
    expect_refusal({"Time stepping/Scheme=explicit",
                    "Time stepping/End time=1e12",
                    coarser},
                   "Time stepping/End time",
                   "steps to the end time");
    expect_refusal({"Output/Interval=1e-7",
                    "Time stepping/Time step=1e-5",
                    coarser},
                   "Output/Interval",
                   "4e+06 moments with files");
    expect_refusal({"Strength reduction/Tolerance=1e-300", coarser},
                   "Strength reduction/Tolerance",
                   "steps between the two factors");
    expect_refusal({"Walls/Names=w", "Walls/w/Line=0, 1; 1e12, 1", coarser},
                   "Walls/w/Line",
                   "8e+12 spots on a wall");
    expect_refusal({"Point loads/Names=p",
                    "Point loads/p/From=155000, 5",
                    "Point loads/p/Force=0, -1",
                    coarser},
                   "Point loads/p/From",
                   "m from the nearest material point");
  }


  TEST(Sizes, of_a_run_grow_as_they_should)
  {
    const auto     input = coarse({"Output/Interval=1"});
    const Case<2>  the_case(input->simulation, MPI_COMM_SELF);
    const RunSizes sizes = run_sizes(the_case);
    EXPECT_EQ(sizes.steps, 4000.);
    EXPECT_EQ(sizes.snapshots, 41.);
    EXPECT_GT(sizes.memory, 1e5);
    EXPECT_LT(sizes.memory, 1e8);
    const RunSizes more = run_sizes<2>(input->simulation,
                                       the_case.materials,
                                       10 * the_case.initial_points.n_points(),
                                       10 * the_case.grid.n_nodes());
    EXPECT_NEAR(more.computing, 10. * sizes.computing, 1e-6 * more.computing);
    EXPECT_GE(more.memory, 10. * sizes.memory);

    EXPECT_GT(sizes.all_points, 100. * the_case.initial_points.n_points());
    // What flows in needs a copy of all points on each of several ranks.
    const auto on_ranks = [&](const Parameters &parameters) {
      return run_sizes<3>(parameters, the_case.materials, 1000000, 1000, 4);
    };
    Parameters with_inflow = input->simulation;
    with_inflow.inflows.emplace_back();
    const RunSizes copies = on_ranks(with_inflow);
    EXPECT_GT(copies.memory,
              on_ranks(input->simulation).memory + 0.3 * copies.all_points);
    EXPECT_GT(copies.memory, 1.5 * copies.all_points);

    // In space GMRES keeps 39 vectors of three components at each node.
    const auto in_space = [&](const std::size_t n_nodes) {
      return run_sizes<3>(input->simulation, the_case.materials, 1000, n_nodes)
        .memory;
    };
    const double per_node = (in_space(20000) - in_space(10000)) / 10000.;
    EXPECT_GE(per_node, 8. * 3. * 39.);
    EXPECT_LE(per_node, 3. * 8. * 3. * 39.);
    // A stiffness that need not be symmetric has two factors, that of the
    // gravity step has one.
    EXPECT_TRUE(input->simulation.gravity.initial_stress);
    Parameters load_steps  = input->simulation;
    load_steps.time.scheme = Scheme::quasi_static;
    EXPECT_GT(
      run_sizes<2>(load_steps, the_case.materials, 1000, 1000).memory,
      1.2 *
        run_sizes<2>(input->simulation, the_case.materials, 1000, 1000).memory);
  }


  TEST(Plausibility, the_shipped_dykes_are_not_strange)
  {
    for (const char *const name : {"analysis1", "analysis2", "analysis3"})
      for (const auto &scenario :
           read_scenarios(WAKER_SOURCE_DIRECTORY "/parameters/chapter5/" +
                            std::string(name) + ".prm",
                          {}))
        for (const std::string &warning :
             strange_parameters(scenario->simulation))
          ADD_FAILURE() << name << ": " << warning;
  }


  TEST(Plausibility, units_that_are_not_the_ones_asked_for_are_told)
  {
    const auto warnings = [](const std::string &setting) {
      return strange_parameters(
        read_scenarios(base_case, {setting})[0]->simulation);
    };
    const std::pair<const char *, const char *> cases[] = {
      {"Materials/clay/Unit weight=18000",
       "Materials/clay/Unit weight is 18000 kN/m^3; soils have 5 to 30 kN/m^3"},
      {"Materials/clay/Unit weight=1.8", "Unit weight is 1.8 kN/m^3"},
      {"Materials/clay/Young's modulus=1e9", "Young's modulus is 1e+09 kPa"},
      {"Materials/clay/Poisson's ratio=0.4999", "Poisson's ratio is 0.4999"},
      {"Materials/clay/Initial strength=13000",
       "Initial strength is 13000 kPa"},
      {"Gravity/Acceleration=98.1", "Gravity/Acceleration is 98.1 m/s^2"},
      {"Water/Unit weight=1000", "Water/Unit weight is 1000 kN/m^3"},
      {"Material points/Points per direction=1", "Points per direction is 1"},
      {"Time stepping/Courant number=0.25",
       "Time stepping/Courant number is not used with Scheme = Newmark"}};
    for (const auto &[setting, text] : cases)
      {
        const auto found = warnings(setting);
        ASSERT_FALSE(found.empty()) << setting;
        EXPECT_NE(found[0].find(text), std::string::npos) << found[0];
      }
    EXPECT_TRUE(warnings("Materials/clay/Unit weight=18").empty());
  }


  TEST(Plausibility, load_programmes_that_never_act_or_hold_are_told)
  {
    const auto warnings = [](std::vector<std::string> settings) {
      settings.insert(settings.end(),
                      {"Load programmes/Names=q",
                       "Load programmes/q/Drives=water",
                       "Time stepping/End time=40"});
      return Warnings::joined(
        strange_parameters(read_scenarios(base_case, settings)[0]->simulation));
    };
    const std::string q     = "Load programmes/q/";
    const std::string rate  = q + "Rate=-0.01";
    const std::string table = q + "Kind=table of time";
    EXPECT_EQ(warnings({rate}), "");
    EXPECT_EQ(warnings({rate, q + "Start time=39"}), "");
    EXPECT_EQ(warnings({rate, q + "Start time=40"}),
              q + "Start time is 40 s, not before 40 s, Time stepping/End "
                  "time: it never acts\n");
    EXPECT_EQ(warnings({q + "Rate=-1e-14"}),
              q + "Rate is -1e-14 m/s: it changes by 4e-13 m by 40 s, Time "
                  "stepping/End time\n");

    const std::vector<std::string> limits     = {rate,
                                                 q + "Held by=largest settlement",
                                                 q +
                                                   "Stopped by=largest settlement",
                                                 q + "Stop above=0.1"};
    const auto                     held_above = [&](const std::string &limit) {
      std::vector<std::string> settings = limits;
      settings.push_back(q + "Hold above=" + limit);
      return warnings(settings);
    };
    EXPECT_EQ(held_above("0.09"), "");
    EXPECT_EQ(held_above("0.1"),
              q + "Hold above is 0.1 m, not below Stop above, 0.1 m of the "
                  "same quantity: it stops before it would wait\n");

    EXPECT_EQ(warnings({table, q + "Table=30: 0, 41: -1"}), "");
    EXPECT_EQ(warnings({table, q + "Table=0: -1, 50: -1"}), "");
    EXPECT_EQ(warnings({table, q + "Table=40: 0, 41: -1"}),
              q + "Table is 0 m from the start to 40 s, Time stepping/End "
                  "time: it never acts\n");
  }
} // namespace simulation_sizes
