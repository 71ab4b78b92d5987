// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/campaign/input.h>
#include <waker/program/declared_parameters.h>
#include <waker/program/parameter_reader.h>
#include <waker/program/prm_scanner.h>

#include "program_case.h"
#include <gtest/gtest.h>

namespace program_names
{
  // Names that the user gives, and values of the command line: they survive
  // parameters.prm, or are refused.

  using namespace Waker;
  using namespace ProgramCase;

  namespace
  {
    /// The good case with a traction of this name.
    std::string
    with_traction(const std::string &name)
    {
      return good_case + "subsection Tractions\n  set Names = " + name +
             "\n  subsection " + name + "\n    set Value = 1\n  end\nend\n";
    }


    UserError
    complaint(const std::string              &text,
              const std::vector<std::string> &overrides = {})
    {
      try
        {
          read_parameters(write_case(text), overrides);
        }
      catch (const UserError &error)
        {
          return error;
        }
      return {"", "", ""};
    }


    bool
    contains(const std::string &text, const std::string &part)
    {
      return text.find(part) != std::string::npos;
    }
  } // namespace


  TEST(Program, names_survive_the_file_of_values_used)
  {
    for (const std::string name : {"wind & golf",
                                   "v1.5",
                                   "a.b.c",
                                   "D\xC3\xBCne",
                                   "<x> 'y'",
                                   "50%",
                                   "value",
                                   "pattern_description",
                                   "set",
                                   "end",
                                   "a: b",
                                   "a_b",
                                   "(1)"})
      {
        const auto p = read_parameters(write_case(with_traction(name)), {});
        ASSERT_EQ(p->tractions.size(), 1u) << name;
        EXPECT_EQ(p->tractions[0].name, name);
        EXPECT_EQ(p->tractions[0].value, "1") << name;
        const std::string text = p->text;
        const auto        q    = read_parameters(write_case(text), {});
        EXPECT_EQ(q->text, text) << name;
        EXPECT_EQ(q->hash, p->hash) << name;
      }
  }


  TEST(Program, names_that_no_file_could_hold_are_refused_with_the_line)
  {
    const std::string line = write_case("") + ":34";
    for (const std::string name : {"a;b", "a=b", "a\\b", "a\"b", "Names"})
      {
        const UserError error = complaint(with_traction(name));
        // A slash is found where the subsection opens, one line further.
        EXPECT_EQ(error.where, name == "a/b" ? write_case("") + ":35" : line)
          << name << ": " << error.what();
        EXPECT_TRUE(contains(error.problem, in_quotes(name))) << error.what();
      }
    EXPECT_TRUE(contains(complaint(with_traction("a/b")).problem, "\"a/b\""));
    EXPECT_TRUE(contains(complaint(with_traction("D\xFCne")).problem, "D?ne"));
    EXPECT_TRUE(contains(complaint(with_traction("D\xFCne")).allowed, "UTF-8"));
    EXPECT_TRUE(
      contains(complaint(with_traction(std::string(101, 'a'))).problem,
               "101 bytes"));
    EXPECT_TRUE(contains(complaint(good_case,
                                   {"Tractions/Names=a b, a_b",
                                    "Tractions/a b/Value=1",
                                    "Tractions/a_b/Value=1"})
                           .problem,
                         "ParaView"));
    EXPECT_TRUE(contains(complaint(good_case, {"Tractions/Names=a#b"}).where,
                         "--set Tractions/Names"));
    std::string many = "n0";
    for (unsigned int i = 1; i < 1001; ++i)
      many += ", n" + std::to_string(i);
    EXPECT_TRUE(
      contains(complaint(good_case, {"Materials/Names=" + many}).problem,
               "1001 names"));
  }


  TEST(Program, no_entry_of_a_section_is_taken_for_a_name)
  {
    const auto scenarios = read_scenarios(write_case(good_case), {});
    // A name that is an entry of the section would have two meanings.
    EXPECT_TRUE(contains(complaint(good_case,
                                   {"Random fields/Names=Correlations",
                                    "Random fields/Correlations/Mean=1"})
                           .problem,
                         "no name"));
    EXPECT_TRUE(contains(complaint(good_case, {"Outflow/Names=Faces"}).problem,
                         "no name"));
    // The sections with names have no other entries than these.
    for (const NamedSection &named : named_sections)
      {
        std::istringstream stream(scenarios[0]->simulation.text);
        const PrmContents  contents = scan_prm(stream, "text");
        for (const PrmEntry &entry : contents.entries)
          EXPECT_TRUE(entry.section != named.section ||
                      entry.name == named.list ||
                      entry.name == "Correlations" || entry.name == "Faces")
            << entry.path();
      }
  }


  TEST(Program, values_that_no_file_could_hold_are_refused)
  {
    for (const std::string value : {"out#1", "out\\", "D\xFCne", "a\x01z"})
      {
        const UserError error =
          complaint(good_case, {"Output/Directory=" + value});
        EXPECT_EQ(error.where, "--set Output/Directory") << value;
      }
    // A backslash in the middle is a letter like others.
    const auto p =
      read_parameters(write_case(good_case), {"Output/Directory=a\\b & <c>"});
    EXPECT_EQ(p->output.directory, "a\\b & <c>");
    const std::string text = p->text;
    EXPECT_EQ(read_parameters(write_case(text), {})->output.directory,
              "a\\b & <c>");
  }


  TEST(Program, names_left_out_on_the_command_line_take_their_subsections_along)
  {
    const std::string two = with_traction("wind") +
                            "subsection Random fields\n  set Names = strength\n"
                            "  subsection strength\n    set Mean = 10\n  end\n"
                            "end\n";
    EXPECT_TRUE(read_parameters(write_case(two), {"Tractions/Names="})
                  ->tractions.empty());
    EXPECT_TRUE(read_scenarios(write_case(two), {"Random fields/Names="})[0]
                  ->reliability.fields.fields.empty());
    const auto q =
      read_parameters(write_case(two),
                      {"Tractions/Names=golf", "Tractions/golf/Value=2"});
    ASSERT_EQ(q->tractions.size(), 1u);
    EXPECT_EQ(q->tractions[0].value, "2");
    // A subsection that no list has ever named is still a mistake.
    EXPECT_TRUE(contains(complaint(with_traction("wind"),
                                   {"Tractions/Names=golf",
                                    "Tractions/golf/Value=2",
                                    "Tractions/wind/Value=2"})
                           .problem,
                         "unknown section \"wind\""));
  }


  TEST(Program, deep_and_wide_files_are_refused_at_once)
  {
    std::string deep, wide;
    for (unsigned int i = 0; i < 20000; ++i)
      {
        deep += "subsection a\n";
        wide +=
          "set Cell size = 1\nsubsection b" + std::to_string(i) + "\nend\n";
      }
    EXPECT_TRUE(contains(complaint(deep).problem, "deep"));
    EXPECT_TRUE(contains(complaint(wide).problem, "twice"));
    const UserError error =
      complaint(with("Cell size ", std::string(1000000, 'a')));
    EXPECT_TRUE(contains(error.problem, "unknown name")) << error.problem;
    const UserError value =
      complaint(with("-6, 0", std::string(900000, ',') + "1"));
    EXPECT_TRUE(contains(value.allowed, "at most 10000")) << value.allowed;
    EXPECT_TRUE(
      contains(complaint(with("-6, 0", std::string(2000000, '1'))).problem,
               "2000000 characters"));
  }
} // namespace program_names
