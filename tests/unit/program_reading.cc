// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/choice.h>
#include <waker/base/expression_pattern.h>
#include <waker/case/parameters.h>
#include <waker/program/command_line.h>
#include <waker/program/declared_parameters.h>
#include <waker/program/parameter_printer.h>
#include <waker/program/parameter_reader.h>
#include <waker/program/suggestions.h>

#include "program_case.h"
#include "user_errors.h"
#include <gtest/gtest.h>
#include <sstream>

namespace program_reading
{
  // What is read, printed and understood; wrong input is in program_input.cc.

  using namespace Waker;
  using namespace ProgramCase;

  namespace
  {
    std::string
    hash_of(const std::string              &text,
            const std::vector<std::string> &overrides = {})
    {
      return read_parameters(write_case(text), overrides)->hash;
    }
  } // namespace


  TEST(Program, good_case_is_read)
  {
    const auto p = read_parameters(write_case(good_case),
                                   {"Materials/clay/Unit weight=16",
                                    " Water / Level = 4.5"});
    EXPECT_EQ(p->dimension, 2u);
    EXPECT_EQ(p->grid.lower_corner, (std::vector<double>{-6., 0.}));
    ASSERT_EQ(p->materials.size(), 1u);
    EXPECT_EQ(p->materials[0].name, "clay");
    EXPECT_EQ(p->materials[0].von_mises.initial_strength, "10");
    EXPECT_EQ(p->materials[0].unit_weight, 16.);
    ASSERT_EQ(p->layers.size(), 1u);
    EXPECT_EQ(p->layers[0].polygon, "0, 0; 30, 0; 15, 5; 5, 5");
    ASSERT_EQ(p->fixities.size(), 1u);
    EXPECT_EQ(p->fixities[0].region, FixityRegion::bottom);
    EXPECT_EQ(p->water.side, WaterSide::left);
    EXPECT_EQ(p->water.level, 4.5);
    EXPECT_EQ(p->time.time_step, 0.01);
  }


  TEST(Program, text_of_values_used_reads_back)
  {
    const auto p =
      read_parameters(write_case(good_case), {"Water/Level=4.123456789012345"});
    const std::string text = p->text;
    const auto        q    = read_parameters(write_case(text), {});
    EXPECT_EQ(q->water.level, 4.123456789012345);
    EXPECT_EQ(q->text, text);
    EXPECT_EQ(q->hash, p->hash);
  }


  TEST(Program, hash_depends_on_values_not_on_writing)
  {
    const std::string hash = hash_of(good_case);
    EXPECT_EQ(hash.size(), 16u);
    EXPECT_EQ(hash, hash_of(with("= 10 ", "= 1.0e1 ")));
    EXPECT_EQ(hash, hash_of(with("-6, 0", "-6.0,0.")));
    EXPECT_EQ(hash, hash_of(good_case, {"Materials/clay/Unit weight=15"}));
    EXPECT_EQ(hash_of(good_case, {"Water/Level=4"}),
              hash_of(good_case, {"Water/Level=+4.00"}));
    EXPECT_NE(hash, hash_of(with("= 10 ", "= 10.0001 ")));
    EXPECT_NE(hash, hash_of(good_case, {"Time stepping/Time step=0.02"}));
    EXPECT_NE(hash, hash_of(with("30, 0", "31, 0")));
    for (const char *free : {"Output/Directory=elsewhere",
                             "Output/Interval=1",
                             "Stop rules/At rest=false",
                             "Strength reduction/Tolerance=0.1",
                             "Time stepping/End time=50"})
      EXPECT_EQ(hash, hash_of(good_case, {free})) << free;
  }


  TEST(Program, later_errors_find_their_line)
  {
    const std::string  path = write_case(good_case);
    ParameterLocations locations;
    read_parameters(path, {"Water/Level=4"}, &locations);
    EXPECT_EQ(locations.where("Soil profile/dyke/Polygon"), path + ":19");
    EXPECT_EQ(locations.where("Soil profile"), path + ":15");
    EXPECT_EQ(locations.where("Water/Level"), "--set Water/Level");
    EXPECT_EQ(locations.where("Output/Directory"),
              path + " (default of Output/Directory)");
    EXPECT_EQ(locations.where("out/summary.json"), "out/summary.json");

    const UserError error =
      locations.located(UserError("Soil profile/dyke/Polygon", "a", "b"));
    EXPECT_EQ(error.where, path + ":19");
    EXPECT_EQ(error.problem, "Soil profile/dyke/Polygon: a");
    EXPECT_EQ(error.allowed, "b");
  }


  TEST(Program, nearest_name)
  {
    EXPECT_EQ(nearest_name("Toleranse", {"Tangent", "Tolerance"}), "Tolerance");
    EXPECT_EQ(nearest_name("xyz", {"Tangent", "Tolerance"}), "");
  }


  TEST(Program, patterns_in_words)
  {
    EXPECT_EQ(pattern_in_words("[Double 0...MAX_DOUBLE (inclusive)]"),
              "a number of at least 0");
    EXPECT_EQ(pattern_in_words("[Double -MAX_DOUBLE...MAX_DOUBLE (inclusive)]"),
              "a number");
    EXPECT_EQ(pattern_in_words("[Double -1...0.5 (inclusive)]"),
              "a number from -1 to 0.5");
    EXPECT_EQ(pattern_in_words("[Integer range 1...2147483647 (inclusive)]"),
              "a whole number of at least 1");
    EXPECT_EQ(pattern_in_words("[Selection left|right|none ]"),
              "one of left, right, none");
    EXPECT_EQ(pattern_in_words("[List of <[Bool]> of length 2...2 (inclusive) "
                               "separated by <;>]"),
              "2 entries separated by \";\", each true or false");
    EXPECT_EQ(pattern_in_words(NumberOrWordPattern("none").description()),
              "a number or none");
  }


  TEST(Program, number_or_word_is_one_of_them)
  {
    const NumberOrWordPattern pattern("none");
    const std::string         description = pattern.description();
    for (const char *const good : {"none", " none ", "4", "-4.5e1", "+.5"})
      {
        EXPECT_TRUE(pattern.match(good)) << good;
        EXPECT_TRUE(matches_pattern(good, description)) << good;
        EXPECT_TRUE(pattern.clone()->match(good)) << good;
      }
    for (const char *const bad :
         {"", "None", "unknown", "0x4", "4,75", "nan", "inf", "1e400", "4 m"})
      {
        EXPECT_FALSE(pattern.match(bad)) << bad;
        EXPECT_FALSE(matches_pattern(bad, description)) << bad;
      }
    EXPECT_EQ(normalised("4.750", description), "4.75");
    EXPECT_EQ(normalised("+4", description), "4");
    EXPECT_EQ(normalised(" none", description), "none");
    EXPECT_NE(allowed_instead("4,75", description).find("not a comma"),
              std::string::npos);
    EXPECT_FALSE(NumberOrWordPattern::word_of("[Anything]").has_value());
  }


  TEST(Program, comma_that_may_be_decimal_is_refused)
  {
    const std::string list =
      "[List of <[Double -MAX_DOUBLE...MAX_DOUBLE (inclusive)]> of length 0...3 "
      "(inclusive)]";
    for (const char *const clear : {"",
                                    "0, 25",
                                    "0 , 25",
                                    "1,2,3",
                                    "0,-25",
                                    "0.5,25",
                                    "0,2.5",
                                    "-6.0,0.",
                                    "1, 2, 3"})
      EXPECT_TRUE(matches_pattern(clear, list)) << clear;
    for (const char *const unclear :
         {"0,25", "-0,25", "1, 0,25", "0,25, 1", " 0,25 ", "1e3,5"})
      EXPECT_FALSE(matches_pattern(unclear, list)) << unclear;
    EXPECT_NE(allowed_instead("0,25", list).find("blanks (0, 25)"),
              std::string::npos);
    // Other lists are not of numbers.
    EXPECT_TRUE(
      matches_pattern("0,1",
                      "[List of <[Anything]> of length 0...3 (inclusive)]"));
  }


  TEST(Program, printed_template_is_a_parameter_file)
  {
    std::ostringstream prm, markdown;
    print_parameters(prm, ParameterFormat::prm);
    print_parameters(markdown, ParameterFormat::markdown);
    EXPECT_NE(markdown.str().find("| Cell size | 0.25 |"), std::string::npos);
    EXPECT_USER_ERROR(choice_named<ParameterFormat>("yaml", "--format"),
                      "--format",
                      "\"yaml\"");
    // All that a user must fill in: the profile, and the places of what is not
    // wanted by every case.
    const auto p =
      read_parameters(write_case(prm.str()),
                      {"Soil profile/<name>/Material=<name>",
                       "Soil profile/<name>/Polygon=0,0; 1,0; 1,1; 0,1",
                       "Point loads/<name>/From=0.5, 0.5",
                       "Point loads/<name>/Force=0, -1",
                       "Load programmes/<name>/From=0.2",
                       "Load programmes/<name>/To=0.5",
                       "Load programmes/<name>/Rate=0.1",
                       "Pore water/Phreatic line=0, 0; 1, 0",
                       "Head lines/<name>/Line=0, 0; 1, 0",
                       "Reference lines/<name>/Line=0, 0; 1, 0",
                       "Walls/<name>/Line=0, 0; 1, 0",
                       "Inflow/<name>/Material=<name>",
                       "Inflow/<name>/Velocity=1"});
    EXPECT_EQ(p->materials[0].name, "<name>");
  }


  TEST(Program, command_line)
  {
    const char *const typed[] = {
      "waker", "run", "--set", "A/B=1", "-", "--set", "C=-2", "--resume"};
    const CommandLine line = parse_command_line(8, typed);
    EXPECT_EQ(line.command, Command::run);
    EXPECT_EQ(line.file, "-");
    EXPECT_EQ(line.overrides, (std::vector<std::string>{"A/B=1", "C=-2"}));
    EXPECT_TRUE(line.resume);
    EXPECT_FALSE(line.overwrite);

    const char *const version[] = {"waker", "--version"};
    EXPECT_EQ(parse_command_line(2, version).text.rfind("waker ", 0), 0u);

    using Words = std::vector<const char *>;
    const std::vector<std::pair<Words, std::string>> mistakes = {
      {{"waker"}, "subcommand"},
      {{"waker", "run"}, "FILE is required"},
      {{"waker", "walk", "a.prm"}, "walk"},
      {{"waker", "run", "a.prm", "b.prm"}, "b.prm"},
      {{"waker", "run", "a.prm", "--fast"}, "--fast"},
      {{"waker", "run", "a.prm", "--resume", "--overwrite"}, "excludes"},
      {{"waker", "parameters", "--format", "yaml"}, "yaml"}};
    for (const auto &mistake : mistakes)
      EXPECT_USER_ERROR(parse_command_line(mistake.first.size(),
                                           mistake.first.data()),
                        "command line",
                        mistake.second);
  }
} // namespace program_reading
