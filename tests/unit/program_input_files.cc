// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/campaign/input.h>
#include <waker/output/files.h>
#include <waker/program/declared_parameters.h>
#include <waker/program/parameter_hash.h>
#include <waker/program/parameter_reader.h>

#include "output_temporary_folder.h"
#include <gtest/gtest.h>
#include <regex>
#include <set>

namespace Waker::program_input_files
{
  namespace
  {
    /// Every parameter that exists, each kind of subsection once.
    std::vector<DeclaredParameter>
    all_parameters()
    {
      ParameterNames names;
      for (auto *list : {&names.materials,
                         &names.layers,
                         &names.conditions,
                         &names.tractions,
                         &names.point_loads,
                         &names.load_programmes,
                         &names.walls,
                         &names.inflows,
                         &names.fields})
        *list = {"name"};
      Input            input;
      ParameterHandler prm;
      declare_parameters(prm, input, names);
      return declared_parameters(prm);
    }


    std::string
    hash_with(std::vector<DeclaredParameter> parameters,
              const std::string             &path,
              const std::string             &value)
    {
      for (DeclaredParameter &parameter : parameters)
        if (parameter.path() == path)
          parameter.value = value;
      return hash_of_steps(parameters);
    }
  } // namespace


  // Whoever adds a parameter that names a file must say so by its pattern: only
  // then are the contents of the file in the hash.
  TEST(Program, parameters_that_name_files_say_so)
  {
    std::set<std::string> found;
    for (const DeclaredParameter &parameter : all_parameters())
      {
        if (parameter.is_input_file())
          found.insert(parameter.path());
        // The words with which our texts speak of input files.
        const std::regex words(
          "(^|[^a-z])(file (of|with)|text file|csv|relative path)",
          std::regex::icase);
        if (std::regex_search(parameter.documentation, words) ||
            std::regex_search(parameter.name,
                              std::regex("\\bfiles?\\b", std::regex::icase)))
          {
            EXPECT_TRUE(parameter.is_input_file()) << parameter.path();
          }
      }
    EXPECT_EQ(found,
              (std::set<std::string>{"Random fields/name/Measurements",
                                     "Risk/Level table",
                                     "Soil profile/name/Bottom",
                                     "Soil profile/name/Top",
                                     "Tractions/name/Surface file"}));
  }


  TEST(Program, contents_of_input_files_are_in_the_hash)
  {
    const TemporaryFolder folder;
    put(folder.file("a"), "0 0\n");
    put(folder.file("b"), "0 0\n");
    const auto all = all_parameters();
    for (const std::string path :
         {"Random fields/name/Measurements", "Tractions/name/Surface file"})
      {
        const auto hash = [&](const std::string &name) {
          return hash_with(all, path, name.empty() ? "" : folder.file(name));
        };
        const std::string before = hash("a");
        EXPECT_EQ(hash("b"), before) << path; // another name, the same contents
        EXPECT_NE(hash(""), before) << path;
        put(folder.file("a"), "0 1\n");
        EXPECT_NE(hash("a"), before) << path;
        put(folder.file("a"), "0 0\n");
        EXPECT_EQ(hash("a"), before) << path;
        try
          {
            hash("none");
            FAIL() << path;
          }
        catch (const UserError &error)
          {
            EXPECT_EQ(error.where, path);
            EXPECT_NE(error.problem.find("none': cannot be read: No such"),
                      std::string::npos)
              << error.problem;
          }
      }
    // This one decides no step, and need not be there for one.
    EXPECT_EQ(hash_with(all, "Risk/Level table", folder.file("none")),
              hash_of_steps(all));
  }


  // The manual says what may change when a run is resumed: all of it, and
  // nothing else.
  TEST(Program, manual_lists_what_resume_may_change)
  {
    const std::string manual =
      get(std::string(WAKER_SOURCE_DIRECTORY) + "/doc/manual.md");
    const std::size_t begin = manual.find("A run may be resumed with other");
    ASSERT_NE(begin, std::string::npos);
    const std::string sentence =
      manual.substr(begin, manual.find(';', begin) - begin);
    std::set<std::string> listed;
    const std::regex      code("`([^`]*)`");
    for (std::sregex_iterator match(sentence.begin(), sentence.end(), code),
         end;
         match != end;
         ++match)
      listed.insert((*match)[1]);

    const auto            all    = all_parameters();
    const std::string     before = hash_of_steps(all);
    std::set<std::string> free, bound;
    for (const DeclaredParameter &parameter : all)
      {
        // Another text: which one does not matter to the hash.
        const bool is_free =
          parameter.is_input_file()
            ? parameter.section == "Risk"
            : hash_with(all, parameter.path(), parameter.value + "1") == before;
        (is_free ? free : bound).insert(parameter.section);
        if (is_free && parameter.section == "Time stepping")
          {
            EXPECT_EQ(parameter.path(), "Time stepping/End time");
          }
      }
    EXPECT_EQ(free.erase("Time stepping"), 1u);
    for (const std::string &section : free)
      EXPECT_EQ(bound.count(section), 0u) << section;
    free.insert("Time stepping/End time");
    EXPECT_EQ(listed, free);
  }


  TEST(Program, copy_of_the_parameters_names_input_files_absolutely)
  {
    const TemporaryFolder folder;
    put(folder.file("levels.csv"), "3,0.1\n4,0.01\n");
    const auto        before   = std::filesystem::current_path();
    const std::string relative = "levels.csv";
    std::filesystem::current_path(folder.path);
    const auto parameters =
      read_parameters(std::string(WAKER_SOURCE_DIRECTORY) +
                        "/parameters/chapter5/analysis1.prm",
                      {"Risk/Level distribution=table",
                       "Risk/Level table=" + relative});
    const std::string absolute =
      (std::filesystem::current_path() / relative).string();
    std::filesystem::current_path(before);
    EXPECT_NE(parameters->text.find("= " + absolute + "\n"), std::string::npos)
      << parameters->text;

    // It is read again, from elsewhere, as the same case.
    put(folder.file("copy.prm"), parameters->text);
    const auto again = read_parameters(folder.file("copy.prm"), {});
    EXPECT_EQ(again->text, parameters->text);
    EXPECT_EQ(again->hash, parameters->hash);
  }
} // namespace Waker::program_input_files
