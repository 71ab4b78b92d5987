// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/store/record.h>
#include <waker/store/record_json.h>

#include "store_records.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace Waker::store_record
{
  namespace
  {
    std::string
    problem(const std::string &text)
    {
      try
        {
          record_from_json(text);
        }
      catch (const std::runtime_error &error)
        {
          return error.what();
        }
      return "";
    }
  } // namespace


  TEST(Store, record_returns_with_every_bit)
  {
    std::mt19937_64                        generator(1);
    std::uniform_real_distribution<double> exponent(-300., -37.); // plausible
    for (unsigned int i = 0; i < 200; ++i)
      {
        Record     record = synthetic_record(3, 4001);
        const auto number = [&]() {
          return std::ldexp(static_cast<double>(generator()) - 9e18,
                            static_cast<int>(exponent(generator)));
        };
        record.realisation       = generator() % 1000000000000000;
        record.outcome           = static_cast<Outcome>(i % 4);
        record.mean_strength     = number();
        record.residual_width    = 0.1 + 0.2;
        record.residual_width_z  = 1. / 3.;
        record.load              = 0.7;
        record.residual_height_z = -0.1;
        record.points_beyond_law = i;
        record.wall_time         = std::abs(number());
        record.field_time        = std::abs(number());
        record.outward           = {std::abs(number()), -0., number()};
        record.trace[1].time     = std::abs(number());

        const Record copy = record_from_json(to_json(record));
        EXPECT_EQ(to_json(copy), to_json(record));
        EXPECT_EQ(fingerprint(copy), fingerprint(record));
        EXPECT_EQ(copy.realisation, record.realisation);
        EXPECT_EQ(copy.outcome, record.outcome);
        EXPECT_EQ(copy.stop_reason, record.stop_reason);
        EXPECT_EQ(copy.mean_strength, record.mean_strength);
        EXPECT_EQ(copy.residual_width, record.residual_width);
        EXPECT_EQ(copy.residual_width_z, record.residual_width_z);
        EXPECT_EQ(copy.load, 0.7);
        EXPECT_FALSE(copy.load_stop_time);
        EXPECT_EQ(copy.points_beyond_law, i);
        EXPECT_EQ(copy.residual_height_z, record.residual_height_z);
        EXPECT_EQ(copy.wall_time, record.wall_time);
        EXPECT_EQ(copy.field_time, record.field_time);
        EXPECT_EQ(copy.outward.area, record.outward.area);
        EXPECT_TRUE(std::signbit(copy.outward.dx));
        EXPECT_EQ(copy.trace.at(1).time, record.trace[1].time);
        EXPECT_EQ(copy.trace.size(), record.trace.size());
      }
  }


  TEST(Store, record_keeps_why_an_end_is_not_final)
  {
    Record      record = synthetic_record(0, 2);
    std::size_t last   = fingerprint(record);
    EXPECT_FALSE(record_from_json(to_json(record)).unrest);
    for (const Unrest &unrest : {Unrest{},
                                 Unrest{true, false, false},
                                 Unrest{false, true, false},
                                 Unrest{false, false, true}})
      {
        record.unrest     = unrest;
        record.outcome    = outcome_of({}, unrest);
        const Record copy = record_from_json(to_json(record));
        ASSERT_TRUE(copy.unrest);
        EXPECT_EQ(to_string(*copy.unrest), to_string(unrest));
        EXPECT_EQ(copy.outcome, record.outcome);
        EXPECT_EQ(fingerprint(copy), fingerprint(record));
        EXPECT_NE(fingerprint(record), last);
        last = fingerprint(record);
      }
    for (const char *const wrong : {"[true,false]", "[1,0,0]", "true"})
      {
        std::string       line = to_json(record);
        const std::string key  = "\"unrest\":";
        const std::size_t from = line.find(key) + key.size();
        line.replace(from, line.find(']', from) + 1 - from, wrong);
        EXPECT_EQ(problem(line).find("\"unrest\" "), 0u) << problem(line);
      }
  }


  TEST(Store, record_keeps_the_sliding_masses)
  {
    Record      record = synthetic_record(0, 1);
    std::size_t last   = fingerprint(record);
    // They were not watched: nothing is written of them.
    EXPECT_EQ(to_json(record).find("sliding"), std::string::npos);
    EXPECT_FALSE(record_from_json(to_json(record)).sliding_masses);
    SlidingMasses none;
    none.whole_volume = 24.25;
    for (const SlidingMasses &sliding :
         {none, synthetic_masses(2), synthetic_masses(3)})
      {
        record.sliding_masses = sliding;
        const Record copy     = record_from_json(to_json(record));
        EXPECT_EQ(to_json(copy), to_json(record));
        EXPECT_EQ(fingerprint(copy), fingerprint(record));
        EXPECT_NE(fingerprint(record), last);
        last = fingerprint(record);
        ASSERT_TRUE(copy.sliding_masses);
        EXPECT_EQ(copy.sliding_masses->failed_volume, sliding.failed_volume);
        EXPECT_EQ(copy.sliding_masses->retrogression, sliding.retrogression);
        ASSERT_EQ(copy.sliding_masses->masses.size(), sliding.masses.size());
        for (std::size_t k = 0; k < sliding.masses.size(); ++k)
          {
            const SlidingMass &mass = copy.sliding_masses->masses[k];
            EXPECT_EQ(mass.time, sliding.masses[k].time);
            EXPECT_EQ(mass.upper[0], sliding.masses[k].upper[0]);
            EXPECT_EQ(std::isnan(mass.width),
                      std::isnan(sliding.masses[k].width));
          }
      }
    // Each number counts.
    Record other = record;
    SlidingMasses::for_each_number(
      *other.sliding_masses,
      [&](const char *const name, double &number, SlidingQuantity) {
        const double before = number;
        number              = -0.5;
        EXPECT_NE(fingerprint(other), last) << name;
        number = before;
      });
    SlidingMass::for_each_number(other.sliding_masses->masses[1],
                                 [&](const char *const name,
                                     double           &number,
                                     SlidingQuantity) {
                                   const double before = number;
                                   number              = -0.5;
                                   EXPECT_NE(fingerprint(other), last) << name;
                                   number = before;
                                 });
    EXPECT_EQ(fingerprint(other), last);

    const std::string line = to_json(record);
    const std::string key  = "\"sliding_masses\" ";
    EXPECT_EQ(problem(replaced(line, "\"whole_volume\":24.25,", "")),
              key + "has no \"whole_volume\"");
    EXPECT_EQ(problem(replaced(line, "24.25", "-24.25")),
              key + "is -24.25, outside of 0 to 1e+12");
    EXPECT_EQ(problem(replaced(line, "\"width\":[0.7,0.7]", "\"width\":[0.7]")),
              key + "has lists of different lengths");
    EXPECT_EQ(problem(replaced(line, "\"width\":[0.7,0.7],", "")),
              key + "has no \"width\"");
    EXPECT_EQ(problem(replaced(line, "[1.5,1.6]", "1.5")),
              key + "has masses that are no lists");
    EXPECT_EQ(problem(replaced(line, "\"direction\":1.0", "\"direction\":7")),
              key + "is 7, outside of -1 to 1");
  }


  // Journals of schema version 1 stay readable: change this line never.
  TEST(Store, record_of_schema_1_is_read)
  {
    const Record record = record_from_json(
      R"({"scenario":2,"realisation":17,"outcome":"initial failure",)"
      R"("stop_reason":"at rest","attempts":1,"initial_time":2.5,)"
      R"("initial_time_thesis":-1.0,"flooding_time":-1.0,"end_time":12.25,)"
      R"("initial_width":18.0,"initial_height":5.0,"residual_width":11.5,)"
      R"("residual_height":4.75,"inward":[21.0,2.5,-0.5],)"
      R"("outward":[0.0,0.0,0.0],"first_inward":[20.0,0.75,-0.25],)"
      R"("first_outward":[1.0,-0.75,0.25],"mean_strength":12.5,)"
      R"("least_strength":6.5,"steps":245,"newton_iterations":700,)"
      R"("linear_iterations":7000,"unconverged_steps":1,)"
      R"("trace":[[0.0,18.0,5.0],[12.25,11.5,4.75]],"wall_time":0.5,)"
      R"("field_time":null})");
    EXPECT_EQ(record.scenario, 2u);
    EXPECT_EQ(record.realisation, 17u);
    EXPECT_EQ(record.outcome, Outcome::initial_failure);
    EXPECT_EQ(record.stop_reason, "at rest");
    EXPECT_EQ(record.initial_time, 2.5);
    EXPECT_EQ(record.flooding_time, -1.);
    EXPECT_EQ(record.end_time, 12.25);
    EXPECT_EQ(record.residual_width, 11.5);
    EXPECT_EQ(record.residual_height, 4.75);
    EXPECT_EQ(record.inward.dx, 2.5);
    EXPECT_EQ(record.first_inward.area, 20.);
    EXPECT_EQ(record.first_outward.dy, 0.25);
    EXPECT_EQ(record.least_strength, 6.5);
    EXPECT_FALSE(record.unrest); // came later
    EXPECT_FALSE(record.sliding_masses);
    EXPECT_FALSE(record.points_beyond_law);
    EXPECT_FALSE(record.residual_width_z || record.residual_height_z);
    EXPECT_EQ(record.steps, 245u);
    EXPECT_EQ(record.unconverged_steps, 1u);
    ASSERT_EQ(record.trace.size(), 2u);
    EXPECT_EQ(record.trace[1].width, 11.5);
    EXPECT_EQ(record.wall_time, 0.5);
    EXPECT_TRUE(std::isnan(record.field_time));
  }


  TEST(Store, record_is_one_line_whatever_it_holds)
  {
    Record record         = synthetic_record(0, 1);
    record.stop_reason    = "two\nlines, \"quotes\", no UTF-8: \xff";
    record.mean_strength  = std::numeric_limits<double>::quiet_NaN();
    record.least_strength = std::numeric_limits<double>::infinity();

    const std::string line = to_json(record);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const Record copy = record_from_json(line);
    EXPECT_EQ(copy.stop_reason.substr(0, 19), "two\nlines, \"quotes\"");
    EXPECT_TRUE(std::isnan(copy.mean_strength));
    EXPECT_TRUE(std::isnan(copy.least_strength));
  }


  TEST(Store, fingerprint_sees_results_but_not_the_clock)
  {
    const Record record = synthetic_record(1, 3);
    Record       other  = record;
    other.wall_time     = 7.;
    other.field_time    = 7.;
    EXPECT_EQ(fingerprint(other), fingerprint(record));

    other.trace.back().height = std::nextafter(2.03, 3.);
    EXPECT_NE(fingerprint(other), fingerprint(record));
    other         = record;
    other.outcome = Outcome::initial_failure;
    EXPECT_NE(fingerprint(other), fingerprint(record));
    other            = record;
    other.outward.dy = -1e-300;
    EXPECT_NE(fingerprint(other), fingerprint(record));
    other = record;
    ++other.steps;
    EXPECT_NE(fingerprint(other), fingerprint(record));
  }


  TEST(Store, record_says_what_is_wrong_with_a_line)
  {
    const std::string line = to_json(synthetic_record(0, 1));
    EXPECT_EQ(problem(line), "");
    // Values of later versions are passed over.
    EXPECT_EQ(problem(replaced(line, "{", "{\"new\":[1],")), "");

    EXPECT_EQ(problem(line.substr(0, line.size() / 2)), "not a JSON object");
    EXPECT_EQ(problem(""), "not a JSON object");
    EXPECT_EQ(problem("[1]"), "not a JSON object");
    EXPECT_EQ(problem(replaced(line, "\"steps\":801,", "")),
              "\"steps\" is missing");
    EXPECT_EQ(problem(replaced(line, "\"steps\":801", "\"steps\":-1")),
              "\"steps\" is not a whole number >= 0");
    EXPECT_EQ(problem(
                replaced(line, "\"attempts\":2", "\"attempts\":4294967297")),
              "\"attempts\" is too large");
    EXPECT_EQ(problem(
                replaced(line, "\"end_time\":40.0", "\"end_time\":\"x\"")),
              "\"end_time\" is not a number");
    EXPECT_EQ(problem(replaced(line, "\"flooding\"", "\"wet\"")),
              "\"outcome\" is 'wet', which is no outcome");
    EXPECT_EQ(problem(replaced(line, "[21.0,1.5,-0.75]", "[21.0,1.5]")),
              "\"first_inward\" does not hold three numbers each");

    // What no dyke can be: a line that was damaged.
    EXPECT_EQ(problem(replaced(line, "\"end_time\":40.0", "\"end_time\":1e20")),
              "\"end_time\" is 1e+20, outside of 0 to 1e+12");
    EXPECT_EQ(problem(replaced(line,
                               "\"steps\":801",
                               "\"steps\":1" + std::string(17, '0'))),
              "\"steps\" is 1e+17, outside of 0 to 1e+15");
    EXPECT_EQ(problem(replaced(line, "[21.0,1.5,-0.75]", "[-21.0,1.5,-0.75]")),
              "\"first_inward\" is -21, outside of 0 to 1e+12");
    EXPECT_EQ(problem(replaced(line, "[9.0,0.0,2.01]", "[9.0,0.0,1e20]")),
              "\"trace\" is 1e+20, outside of -1e+08 to 1e+08");
  }


  // A simulation that explodes must not write what is then taken for damage.
  TEST(Store, record_with_impossible_numbers_can_be_read)
  {
    Record record          = synthetic_record(0, 1);
    record.residual_height = 1e30;
    record.residual_width  = -std::numeric_limits<double>::infinity();
    record.inward          = {1e40, -1e40, 2.};
    record.trace[1].height = 1e200;
    const Record copy      = record_from_json(to_json(record));
    EXPECT_TRUE(std::isnan(copy.residual_height));
    EXPECT_TRUE(std::isnan(copy.residual_width));
    EXPECT_TRUE(std::isnan(copy.inward.area));
    EXPECT_TRUE(std::isnan(copy.inward.dx));
    EXPECT_EQ(copy.inward.dy, 2.);
    EXPECT_TRUE(std::isnan(copy.trace[1].height));
  }


  // How members are added: lines of before do not have them.
  TEST(Store, record_member_that_a_line_lacks_is_empty)
  {
    using namespace RecordJson;
    const auto            range = Plausible::length;
    std::optional<double> member;
    Json                  line = Json::object();
    put(line, "new", range, member);
    EXPECT_TRUE(line.empty());
    Hash nothing;
    nothing.add(member);
    EXPECT_EQ(nothing.state, Hash().state);

    member = 0.75;
    put(line, "new", range, member);
    EXPECT_EQ(line.dump(), R"({"new":0.75})");
    Hash something;
    something.add(member);
    EXPECT_NE(something.state, nothing.state);

    std::optional<double> copy;
    take(line, "new", range, copy);
    EXPECT_EQ(copy, member);
    take(Json::object(), "new", range, copy);
    EXPECT_FALSE(copy.has_value());
    const auto problem_of = [&](const Json &wrong) -> std::string {
      try
        {
          take(wrong, "new", range, copy);
        }
      catch (const std::runtime_error &error)
        {
          return error.what();
        }
      return "";
    };
    EXPECT_EQ(problem_of({{"new", "x"}}), "\"new\" is not a number");
    EXPECT_EQ(problem_of({{"new", 1e20}}).find("\"new\" is 1e+20, outside"),
              0u);
    std::optional<MovedSoil> soil;
    take(Json::parse(R"({"soil":[1.5,2,3]})"), "soil", range, soil);
    ASSERT_TRUE(soil.has_value());
    EXPECT_EQ(soil->area, 1.5);
  }
} // namespace Waker::store_record
