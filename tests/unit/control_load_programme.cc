// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/last_change.h>
#include <waker/control/load_programme.h>

#include "user_errors.h"
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace control_load_programme
{
  // Numbers in, a factor out: sequences by hand.

  using namespace Waker;

  namespace
  {
    /// The foundation load of chapter 6: 0.5 m of soil a second, held above
    /// 0.05 m/s, stopped above 0.1 m.
    LoadProgrammeParameters
    foundation()
    {
      LoadProgrammeParameters p;
      p.name        = "foundation";
      p.weight.from = {1.5};
      p.weight.to   = {2.};
      p.rate        = 0.5;
      p.held_by     = Watched::largest_settlement_rate;
      p.hold_above  = 0.05;
      p.stopped_by  = Watched::largest_settlement;
      p.stop_above  = 0.1;
      return p;
    }


    LoadProgrammeParameters
    table_of(const LoadProgrammeKind kind, const std::string &table)
    {
      LoadProgrammeParameters p = foundation();
      p.kind                    = kind;
      p.rate                    = 0.;
      p.held_by                 = Watched::nothing;
      p.table                   = table;
      p.quantity                = Watched::largest_settlement;
      return p;
    }


    /// A programme on its way.
    struct Load
    {
      explicit Load(const LoadProgrammeParameters &p)
        : programme(p)
        , record(programme.start())
      {}

      /// A step after this has been seen.
      void
      step(const double dt, const double rate, const double settlement)
      {
        programme.watch({rate, settlement, settlement}, record);
        programme.proceed(record.time + dt, record);
      }

      LoadProgramme programme;
      LoadRecord    record;
    };
  } // namespace


  TEST(Control, a_load_grows_waits_grows_and_is_stopped)
  {
    Load load(foundation());
    EXPECT_EQ(load.record.factor, 0.);
    // Nothing has moved before the first step: it grows by 0.005 m.
    load.step(0.01, 0., 0.);
    EXPECT_DOUBLE_EQ(load.record.factor, 0.005);
    load.step(0.01, 0.05, 0.001); // at the limit, not above it
    EXPECT_DOUBLE_EQ(load.record.factor, 0.01);
    load.step(0.01, 0.0501, 0.002);
    EXPECT_TRUE(load.record.held);
    EXPECT_DOUBLE_EQ(load.record.factor, 0.01);
    load.step(0.01, 0.2, 0.004);
    EXPECT_DOUBLE_EQ(load.record.factor, 0.01);
    EXPECT_NEAR(load.record.held_for, 0.02, 1e-15);
    EXPECT_EQ(load.programme.last_change(load.record), LastChange::unknown);
    load.step(0.01, 0.04, 0.005);
    EXPECT_FALSE(load.record.held);
    EXPECT_DOUBLE_EQ(load.record.factor, 0.015);
    load.step(0.01, 0.04, 0.1); // at the limit
    EXPECT_DOUBLE_EQ(load.record.factor, 0.02);
    EXPECT_FALSE(load.record.is_stopped());

    load.step(0.01, 0.04, 0.1001);
    EXPECT_NEAR(load.record.stop_time, 0.06, 1e-15);
    EXPECT_DOUBLE_EQ(load.record.factor, 0.02); // the ultimate load
    EXPECT_TRUE(load.programme.is_over(load.record));
    EXPECT_NEAR(load.programme.last_change(load.record), 0.06, 1e-15);
    // For good, whatever comes, and it no longer waits.
    for (const double rate : {0., 1.})
      load.step(0.01, rate, 0.);
    EXPECT_DOUBLE_EQ(load.record.factor, 0.02);
    EXPECT_NEAR(load.record.stop_time, 0.06, 1e-15);
    EXPECT_FALSE(load.record.held);
    EXPECT_NEAR(load.record.held_for, 0.02, 1e-15);
  }


  TEST(Control, what_was_only_tried_leaves_no_trace)
  {
    Load load(foundation());
    load.step(0.01, 0., 0.);
    for (const double rate : {0.04, 0.06, 0.04})
      load.programme.watch({rate, 0., 0.}, load.record);
    EXPECT_DOUBLE_EQ(load.programme.factor(load.record, 0.02), 0.01);
    EXPECT_DOUBLE_EQ(load.programme.factor(load.record, 0.0125), 0.00625);
    EXPECT_DOUBLE_EQ(load.record.factor, 0.005);
    load.programme.proceed(0.0125, load.record);
    EXPECT_DOUBLE_EQ(load.record.factor, 0.00625);
  }


  TEST(Control, a_load_is_a_rate_whatever_the_steps)
  {
    // While the body moves from 1 to 2 s it waits: 0.5 m/s for 2 of 3 s.
    const auto run = [](const std::function<double(int)> &dt) {
      Load load(foundation());
      for (int n = 0; load.record.time < 3. - 1e-9; ++n)
        {
          const double t = load.record.time + 1e-9;
          load.step(dt(n), t >= 1. && t < 2. ? 0.06 : 0.01, 0.01);
        }
      return load.record;
    };
    for (const LoadRecord &record :
         {run([](int) { return 0.01; }),
          run([](int) { return 0.005; }),
          run([](const int n) { return n % 3 == 0 ? 0.01 : 0.005; })})
      {
        EXPECT_NEAR(record.factor, 1., 1e-12);
        EXPECT_NEAR(record.held_for, 1., 1e-12);
        EXPECT_NEAR(record.time, 3., 1e-12);
      }
  }


  TEST(Control, growth_begins_and_ends_where_it_should)
  {
    LoadProgrammeParameters p = foundation();
    p.start_time              = 1.;
    p.up_to                   = "0.25";
    Load load(p);
    for (int n = 0; n < 9; ++n)
      load.step(0.1, 1., 0.); // it would wait, but there is nothing to wait for
    EXPECT_EQ(load.record.factor, 0.);
    EXPECT_EQ(load.record.held_for, 0.);
    load.step(0.2, 0., 0.); // from 0.9 to 1.1 s
    EXPECT_NEAR(load.record.factor, 0.05, 1e-14);
    EXPECT_FALSE(load.programme.is_over(load.record));
    load.step(1., 0., 0.);
    EXPECT_EQ(load.record.factor, 0.25);
    EXPECT_TRUE(load.programme.is_over(load.record));
    EXPECT_FALSE(load.record.is_stopped());
    EXPECT_NEAR(load.programme.last_change(load.record), 2.1, 1e-14);

    // Water that falls.
    p.drives = LoadTarget::water;
    p.rate   = -0.5;
    p.up_to  = "-0.25";
    Load fall(p);
    fall.step(1.25, 0., 0.);
    EXPECT_DOUBLE_EQ(fall.record.factor, -0.125);
    fall.step(1.25, 0., 0.);
    EXPECT_EQ(fall.record.factor, -0.25);
    EXPECT_TRUE(fall.programme.is_over(fall.record));
  }


  TEST(Control, a_table_does_not_wait)
  {
    LoadProgrammeParameters p =
      table_of(LoadProgrammeKind::table_of_time, "0: 0, 1: 2");
    p.held_by    = Watched::largest_settlement_rate;
    p.hold_above = 0.05;
    Load load(p);
    load.step(0.5, 1., 0.);
    EXPECT_FALSE(load.record.held);
    EXPECT_EQ(load.record.held_for, 0.);
    EXPECT_DOUBLE_EQ(load.record.factor, 1.);
  }


  TEST(Control, tables_of_time_and_of_a_quantity)
  {
    Load by_time(table_of(LoadProgrammeKind::table_of_time,
                          "0: 0.5, 1: 0.5, 2: 1.5, 3: 1.5"));
    EXPECT_EQ(by_time.record.factor, 0.5);
    by_time.step(1.5, 9., 0.05);
    EXPECT_DOUBLE_EQ(by_time.record.factor, 1.);
    EXPECT_EQ(by_time.programme.last_change(by_time.record), 2.);
    by_time.step(0.25, 9., 0.2); // stopped at 1.5 s
    EXPECT_DOUBLE_EQ(by_time.record.factor, 1.);
    EXPECT_EQ(by_time.record.stop_time, 1.5);
    EXPECT_EQ(by_time.programme.last_change(by_time.record), 1.5);

    // By settlement: it is that of the end of the step before.
    Load by_settlement(
      table_of(LoadProgrammeKind::table_of_quantity, "0: 1, 0.05: 1, 0.1: 0"));
    EXPECT_EQ(by_settlement.record.factor, 1.);
    by_settlement.step(0.01, 0., 0.);
    EXPECT_EQ(by_settlement.record.factor, 1.);
    by_settlement.step(0.01, 0., 0.06);
    EXPECT_NEAR(by_settlement.record.factor, 0.8, 1e-14);
    by_settlement.step(0.005, 0., 0.05); // it may come back
    EXPECT_EQ(by_settlement.record.factor, 1.);
    EXPECT_EQ(by_settlement.programme.last_change(by_settlement.record),
              LastChange::never);
    EXPECT_FALSE(by_settlement.programme.is_over(by_settlement.record));
  }


  // What figure 6.2 of Remmerswaal (2023) shows, of bodies that are told here
  // when they move: below their capacity they stand; some loads set them moving
  // for a while; at the capacity they accelerate for good.
  TEST(Control, four_slopes_as_in_figure_6_2)
  {
    struct Slope
    {
      double              capacity; // m of soil
      std::vector<double> stumbles; // loads at which it begins to move
    };
    const auto run = [](const Slope &slope) {
      Load             load(foundation());
      constexpr double dt         = 0.01;
      double           settlement = 0., rate = 0.;
      std::size_t      next = 0;
      for (int n = 0; n < 1500; ++n)
        {
          load.step(dt, rate, settlement);
          const double f = load.record.factor + 1e-12;
          if (f >= slope.capacity && settlement < 0.5)
            rate = std::max(rate, 0.06) * 1.05; // it accelerates
          else if (f >= slope.capacity)
            rate *= 0.9; // and comes to rest
          else if (next < slope.stumbles.size() && f >= slope.stumbles[next])
            {
              rate = 0.16; // it moves, and slows down: 0.5 a tenth of a second
              ++next;
            }
          else
            rate *= std::pow(0.5, dt / 0.1);
          settlement += rate * dt;
        }
      return load.record;
    };

    // 1: unstable under its own weight; the step that begins at rest has loaded
    // it with 0.005 m.
    const LoadRecord inherent = run({0., {}});
    EXPECT_DOUBLE_EQ(inherent.factor, 0.005);
    EXPECT_GT(inherent.held_for, 0.);
    EXPECT_TRUE(inherent.is_stopped());
    // 2: from A to B without a pause.
    const LoadRecord straight = run({0.3, {}});
    EXPECT_NEAR(straight.factor, 0.3, 1e-12);
    EXPECT_NEAR(straight.change_time, 0.6, 1e-12);
    EXPECT_TRUE(straight.is_stopped());
    // 3: it stumbles at C, and gets up again: 0.16 m/s falls below the limit of
    // 0.05 in log2(3.2) = 1.68 tenths of a second, 16 steps above it and 1
    // more.
    const LoadRecord once = run({0.4, {0.2}});
    EXPECT_NEAR(once.factor, 0.4, 1e-12);
    EXPECT_NEAR(once.change_time, 0.8 + 0.17, 1e-12);
    // 4: again and again from E on, by one increment each.
    const LoadRecord often = run({0.42, {0.4, 0.405, 0.41, 0.415}});
    EXPECT_NEAR(often.factor, 0.42, 1e-12);
    EXPECT_NEAR(often.change_time, 0.84 + 4 * 0.17, 1e-12);
    EXPECT_TRUE(often.is_stopped());
    EXPECT_GT(often.stop_time, often.change_time);
  }


  TEST(Control, load_programmes_that_make_no_sense_are_refused)
  {
    const std::string path = "Load programmes/foundation/";
    const auto        with = [](const auto &change) {
      LoadProgrammeParameters p = foundation();
      change(p);
      p.check(2, true);
    };
    using P = LoadProgrammeParameters;
    with([](P &) {});
    EXPECT_USER_ERROR(with([](P &p) { p.rate = 0.; }), path + "Rate", "is 0");
    EXPECT_USER_ERROR(with([](P &p) { p.rate = -1.; }), path + "Rate", "is -1");
    with([](P &p) {
      p.rate   = -1.;
      p.drives = LoadTarget::water;
    });
    for (const char *const text : {"-1", "0", "all"})
      EXPECT_USER_ERROR(with([&](P &p) { p.up_to = text; }),
                        path + "Up to",
                        text);
    EXPECT_USER_ERROR(with([](P &p) { p.hold_above = 0.; }),
                      path + "Hold above",
                      "largest settlement rate");
    with([](P &p) {
      p.hold_above = 0.;
      p.held_by    = Watched::nothing;
    });
    EXPECT_USER_ERROR(with([](P &p) { p.stop_above = 0.; }),
                      path + "Stop above",
                      "0 m");
    with([](P &p) { p.stopped_by = Watched::settlement_of_load; });
    EXPECT_USER_ERROR(with([](P &p) {
                        p.stopped_by = Watched::settlement_of_load;
                        p.drives     = LoadTarget::traction;
                      }),
                      path + "Stopped by",
                      "no points carry the load");
    EXPECT_USER_ERROR(foundation().check(2, false),
                      path + "Held by",
                      "stay in place");
    P still          = foundation();
    still.held_by    = Watched::nothing;
    still.stopped_by = Watched::plastic_strain;
    still.check(2, false);

    const auto table = [](const LoadProgrammeKind kind,
                          const std::string      &text) {
      table_of(kind, text).check(2, true);
    };
    using Kind = LoadProgrammeKind;
    table(Kind::table_of_time, "0: 0, 1: 2");
    EXPECT_USER_ERROR(table(Kind::table_of_time, " "),
                      path + "Table",
                      "is empty");
    for (const char *const text : {"3", "t", "0: 1", "0: 1, 0: 2", "a: 1"})
      EXPECT_USER_ERROR(table(Kind::table_of_quantity, text),
                        path + "Table",
                        text);
    EXPECT_USER_ERROR(table(Kind::table_of_time, "0: 0, 1: -0.5, 2: 0"),
                      path + "Table",
                      "-0.5 m");
    P of_nothing        = table_of(Kind::table_of_quantity, "0: 0, 1: 2");
    of_nothing.quantity = Watched::nothing;
    EXPECT_USER_ERROR(of_nothing.check(2, true), path + "Quantity", "nothing");

    EXPECT_USER_ERROR(with([](P &p) { p.weight.to = {1.5}; }),
                      path + "To",
                      "1.5");
    EXPECT_USER_ERROR(with([](P &p) {
                        p.weight.to = {2., 3.};
                      }),
                      path + "To",
                      "2 numbers");
    EXPECT_USER_ERROR(with([](P &p) { p.weight.unit_weight = 0.; }),
                      path + "Unit weight",
                      "0");
  }
} // namespace control_load_programme
