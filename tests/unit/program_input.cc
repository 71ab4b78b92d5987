// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/case/parameters.h>
#include <waker/program/parameter_reader.h>

#include "program_case.h"
#include <gtest/gtest.h>

namespace program_input
{
  // Wrong input: where, what, and what is allowed.

  using namespace Waker;
  using namespace ProgramCase;

  namespace
  {
    /// Reading must fail, with these words in the three lines.
    void
    expect_error(const std::string              &text,
                 const std::vector<std::string> &overrides,
                 const std::string              &where,
                 const std::string              &what,
                 const std::string              &allowed)
    {
      const std::string path = write_case(text);
      try
        {
          read_parameters(path, overrides);
          ADD_FAILURE() << "no error; expected: " << what;
        }
      catch (const UserError &error)
        {
          const std::string file =
            where.rfind("--set", 0) == 0 ? where : path + where;
          EXPECT_EQ(error.where, file);
          EXPECT_NE(error.problem.find(what), std::string::npos)
            << error.what();
          EXPECT_NE(error.allowed.find(allowed), std::string::npos)
            << error.what();
        }
    }


    /// The same for the good case with a value given on the command line.
    void
    expect_override_error(const std::string &path,
                          const std::string &value,
                          const std::string &what,
                          const std::string &allowed)
    {
      expect_error(
        good_case, {path + "=" + value}, "--set " + path, what, allowed);
    }
  } // namespace


  TEST(Program, unknown_names_get_the_nearest_known_one)
  {
    expect_error(with("Cell size ", "Cel size "),
                 {},
                 ":5",
                 "\"Cel size\" in \"Grid\"",
                 "did you mean \"Cell size\"?");
    expect_error(with("Cell size ", "cell size "),
                 {},
                 ":5",
                 "\"cell size\"",
                 "did you mean \"Cell size\"?");
    expect_error(with("Cell size ", "Time step "),
                 {},
                 ":5",
                 "\"Time step\"",
                 "did you mean \"Time stepping/Time step\"?");
    expect_error(with("subsection Water", "subsection Watre"),
                 {},
                 ":29",
                 "unknown section \"Watre\" at the top level",
                 "did you mean \"Water\"?");
    expect_error(with("subsection clay", "subsection cley"),
                 {},
                 ":8",
                 "there is no subsection \"clay\"",
                 "a subsection of \"Materials\"");
    expect_error(with("  set Names = base\n", ""),
                 {},
                 ":24",
                 "unknown section \"base\" in \"Boundary conditions\"",
                 "lists: none so far");
    expect_override_error("Grid/Cel size",
                          "1",
                          "\"Cel size\"",
                          "\"Cell size\"");
    expect_override_error("Gird/Cell size", "1", "\"Gird\"", "\"Grid\"");
    expect_override_error("Cell size", "1", "\"Cell size\"", "Grid/Cell size");
  }


  TEST(Program, duplicates_name_both_places)
  {
    expect_error(with("# line 5", "\n  set Cell size = 0.5"),
                 {},
                 ":6",
                 write_case("") + ":5",
                 "once");
    expect_error(with("subsection Water",
                      "subsection Grid\nend\nsubsection Water"),
                 {},
                 ":29",
                 write_case("") + ":2",
                 "once");
    expect_error(with("Names = clay", "Names = clay, clay"),
                 {},
                 ":8",
                 "\"clay\" is listed twice",
                 "once");
    expect_error(good_case,
                 {"Water/Level=1", "Water/Level=2"},
                 "--set Water/Level",
                 "given twice",
                 "once");
  }


  TEST(Program, grammar)
  {
    expect_error(with("# line 5", "\nend"), {}, ":7", "without a subs", "one");
    expect_error(
      good_case + "subsection Newton\n", {}, ":33", "Newton", "\"end\"");
    expect_error(
      with("# line 1", "Grid = 3"), {}, ":1", "Grid = 3", "set NAME");
    expect_error(
      with("# line 1", "set Dimension 3"), {}, ":1", "Dimen", "NAME =");
    expect_error(
      with("# line 1", "include a.prm"), {}, ":1", "a.prm", "complete");
    expect_error(with("# line 1", "\x01\x02\xff"), {}, ":1", "??", "set NAME");
    expect_error(good_case, {"Water"}, "--set Water", "cannot read", "=value");
    // Line ends of Windows, and a byte order mark.
    std::string windows = "\xEF\xBB\xBF" + good_case;
    for (std::size_t i = 0; (i = windows.find('\n', i)) != std::string::npos;
         i += 2)
      windows.insert(i, "\r");
    EXPECT_EQ(read_parameters(write_case(windows), {})->materials.size(), 1u);
  }


  TEST(Program, missing_file_and_folder)
  {
    for (const std::string &path :
         {testing::TempDir(), testing::TempDir() + "not_there.prm"})
      try
        {
          read_parameters(path, {});
          ADD_FAILURE() << path;
        }
      catch (const UserError &error)
        {
          EXPECT_EQ(error.where, path);
          EXPECT_NE(error.allowed.find(".prm file"), std::string::npos);
        }
  }


  TEST(Program, values_of_wrong_type_or_out_of_range)
  {
    expect_error(with("0.25 #", "fine #"), {}, ":5", "\"fine\"", "a number");
    expect_error(with("0.25 #", " #"), {}, ":5", "\"\"", "a number");
    expect_error(
      with("= left", "= up"), {}, ":30", "\"up\"", "one of none, left, right");
    expect_override_error("Grid/Cell size", "-1", "\"-1\"", "at least 0");
    expect_override_error("Grid/Cell size", "1e400", "\"1e400\"", "a number");
    expect_override_error("Grid/Cell size", "nan", "\"nan\"", "a number");
    expect_override_error("Dimension", "4", "\"4\"", "from 2 to 3");
    expect_override_error("Newton/Predictor",
                          "maybe",
                          "maybe",
                          "true or false");
    expect_override_error("Newton/Maximum iterations", "1.5", "1.5", "whole");
    expect_override_error("Grid/Lower corner", "1", "\"1\"", "2 to 3 entries");
    expect_override_error("Time stepping/Courant number", "2", "2", "0 to 1");
    // Lengths of vectors follow the dimension.
    expect_override_error("Grid/Upper corner",
                          "1, 2, 3",
                          "3 numb",
                          "2 numbers");
    expect_error(good_case, {"Dimension=3"}, ":3", "2 numbers", "3 numbers");
  }


  TEST(Program, values_that_make_no_sense)
  {
    const std::string clay = "Materials/clay/";
    expect_override_error(clay + "Initial strength", "-1", "-1 kPa", "above 0");
    expect_override_error(clay + "Initial strength", "0", "0 kPa", "above 0");
    expect_error(
      with("= 3.85", "= 11"), {}, ":11", "11 kPa", "initial strength");
    expect_override_error(clay + "Poisson's ratio", "0.5", "0.5", "below 0.5");
    expect_override_error(clay + "Young's modulus", "0", "0 kPa", "above 0");
    expect_override_error(clay + "Unit weight", "0", "is 0", "above 0");
    expect_override_error(clay + "Softening modulus", "1", "1 kPa", "negative");
    // E = 1000, nu = 0.45: -sqrt(3) G = -597.2 kPa; "half" allows 15 % more.
    expect_override_error(clay + "Softening modulus", "-598", "snap", "-597.2");
    EXPECT_NO_THROW(read_parameters(write_case(good_case),
                                    {clay + "Softening modulus=-597"}));
    EXPECT_NO_THROW(read_parameters(write_case(good_case),
                                    {clay + "Softening modulus=-689",
                                     clay + "Plastic strain invariant=half"}));
    expect_override_error(clay + "Model", "sand", "sand", "linear elastic");

    for (const char *const level : {"5.01", "5"})
      expect_error(
        with("4.75", level), {}, ":31", "crest at 5 m", "less than 5 m");
    EXPECT_NO_THROW(
      read_parameters(write_case(with("4.75", "9")), {"Water/Side=none"}));

    for (const char *path : {"Time stepping/Time step",
                             "Time stepping/Courant number",
                             "Newton/Tolerance",
                             "Newton/Linear tolerance",
                             "Gravity/Tolerance",
                             "Grid/Cell size",
                             "Stop rules/Rest velocity",
                             "Stop rules/Rest duration",
                             "Initial failure/Width change",
                             "Sliding masses/Displacement",
                             "Strength reduction/Tolerance",
                             "Strength reduction/Lower factor"})
      expect_override_error(path, "0", std::string(path) + ": is 0", "above 0");
    expect_override_error("Strength reduction/Upper factor",
                          "0.4",
                          "0.4",
                          "above the lower");
    expect_override_error("Grid/Upper corner", "-7, 6", "no cell", "above");
    expect_override_error("Output/Directory", "", "empty", "folder");
  }


  TEST(Program, profile)
  {
    const std::size_t begin = good_case.find("  set Layers");
    const std::size_t end   = good_case.find("end\nsubsection Boundary");
    expect_error(with(good_case.substr(begin, end - begin), ""),
                 {},
                 " (default of Soil profile/Layers)",
                 "no layer",
                 "names");
    expect_error(
      with("Material = clay", "Material = cl"), {}, ":18", "\"cl\"", "clay");
    expect_error(with("15, 5; 5, 5", "5, 5; 15, 5"),
                 {},
                 ":19",
                 "Soil profile/dyke/Polygon",
                 "");
    expect_override_error("Soil profile/dyke/Extent",
                          "0, 1",
                          "two dimensions",
                          "Dimension = 3");
    expect_override_error("Soil profile/dyke/Velocity",
                          "1; 2; 3",
                          "3 numbers",
                          "2 numbers");
    // One number with a decimal comma, not 0 and 25.
    expect_override_error("Soil profile/dyke/Velocity",
                          "0,25",
                          "1 number or expression",
                          "decimals with a point");
    expect_error(with("  set Names = base\n  subsection base # line 25\n"
                      "    set Region = bottom\n  end\n",
                      ""),
                 {},
                 " (default of Boundary conditions/Names)",
                 "no boundary condition",
                 "at least one");
  }
} // namespace program_input
