// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/text.h>
#include <waker/output/statistics.h>

#include "output_temporary_folder.h"
#include "user_errors.h"
#include <filesystem>
#include <gtest/gtest.h>
#include <sstream>

namespace Waker::output_statistics
{
  namespace
  {
    /// What the AssertThrow says that `function` must meet.
    template <typename Function>
    std::string
    mistake(const Function &function)
    {
      try
        {
          function();
        }
      catch (const dealii::ExcMessage &exception)
        {
          std::ostringstream text;
          exception.print_info(text);
          return tidy(text.str());
        }
      return "";
    }


    void
    add_rows(Statistics        &statistics,
             const unsigned int from,
             const unsigned int to)
    {
      for (unsigned int step = from; step < to; ++step)
        {
          statistics.begin_row(step);
          statistics.add("Time (s)", 0.1 * step);
          statistics.add("Dyke width (m)", -1. / 3.);
          statistics.end_row();
        }
    }
  } // namespace


  TEST(Output, statistics_describe_themselves)
  {
    const TemporaryFolder folder;
    {
      Statistics statistics(folder.file("statistics"));
      add_rows(statistics, 0, 2);
    }
    EXPECT_EQ(get(folder.file("statistics")),
              "# 1: Step\n# 2: Time (s)\n# 3: Dyke width (m)\n"
              "0 0 -0.3333333333\n1 0.1 -0.3333333333\n");
  }


  TEST(Output, statistics_are_in_the_file_after_flush)
  {
    const TemporaryFolder folder;
    Statistics            statistics(folder.file("statistics"));
    add_rows(statistics, 0, 3);
    statistics.flush();
    EXPECT_NE(get(folder.file("statistics")).find("\n2 0.2 "),
              std::string::npos);
  }


  TEST(Output, statistics_refuse_other_columns)
  {
    Statistics statistics("");
    add_rows(statistics, 0, 1);
    statistics.begin_row(1);
    EXPECT_EQ(mistake([&]() { statistics.add("Dyke width (m)", 1.); }),
              "Column 2 of the statistics is not 'Dyke width (m)' in every "
              "row");
    statistics.begin_row(2);
    statistics.add("Time (s)", 1.);
    EXPECT_EQ(mistake([&]() { statistics.end_row(); }),
              "A row of the statistics has 2 columns, not 3");
  }


  TEST(Output, resumed_statistics_equal_uninterrupted_ones)
  {
    const TemporaryFolder folder;
    {
      Statistics statistics(folder.file("whole"));
      add_rows(statistics, 0, 12);
    }
    {
      Statistics statistics(folder.file("killed"));
      add_rows(statistics, 0, 9);
    }
    // Killed while it wrote row 9, with the last checkpoint before step 5.
    put(folder.file("killed"), get(folder.file("killed")) + "9 0.9 -0.33");
    {
      Statistics statistics(folder.file("killed"), 5);
      EXPECT_EQ(statistics.columns().size(), 3u);
      add_rows(statistics, 5, 12);
    }
    EXPECT_EQ(get(folder.file("killed")), get(folder.file("whole")));

    // Resumed from before the first row, and with half a header.
    {
      Statistics statistics(folder.file("killed"), 0);
      add_rows(statistics, 0, 12);
    }
    EXPECT_EQ(get(folder.file("killed")), get(folder.file("whole")));
    put(folder.file("killed"), "# 1: Step\n# 2: Ti");
    {
      Statistics statistics(folder.file("killed"), 0);
      add_rows(statistics, 0, 12);
    }
    EXPECT_EQ(get(folder.file("killed")), get(folder.file("whole")));
  }


  TEST(Output, resumed_statistics_keep_their_columns)
  {
    const TemporaryFolder folder;
    {
      Statistics statistics(folder.file("statistics"));
      add_rows(statistics, 0, 4);
    }
    Statistics statistics(folder.file("statistics"), 4);
    statistics.begin_row(4);
    EXPECT_USER_ERROR(statistics.add("Energy (kJ)", 1.),
                      "Output/Directory",
                      "does not name its column 2 \"Energy (kJ)\"");
  }


  TEST(Output, resumed_statistics_tell_what_is_missing)
  {
    const TemporaryFolder folder;
    const std::string     path = folder.file("statistics");
    std::string           whole;
    {
      Statistics statistics(path);
      add_rows(statistics, 0, 9);
    }
    whole = get(path);
    // Resumed from a checkpoint after step 4; the file is then...
    const auto damage = [&](const std::string &text) {
      put(path, text);
      Statistics statistics(path, 5);
      add_rows(statistics, 5, 9);
      return statistics.damage();
    };
    const auto without = [&](const std::string &part,
                             const std::string &instead = "") {
      std::string text = whole;
      EXPECT_NE(text.find(part), std::string::npos) << part;
      return text.replace(text.find(part), part.size(), instead);
    };
    const std::string row    = " -0.3333333333\n";
    const std::string header = whole.substr(0, whole.find("\n0 ") + 1);

    EXPECT_EQ(damage(whole), "");
    EXPECT_EQ(get(path), whole);

    const std::string third = "2 0.2" + row;
    EXPECT_NE(damage(without(third))
                .find("1 of 5 rows of before the "
                      "checkpoint are missing or damaged"),
              std::string::npos);
    EXPECT_NE(damage(without(third)).find("that of step 2"), std::string::npos);
    EXPECT_EQ(get(path), without(third));
    for (const std::string &instead : {std::string("2 0.2\n"),
                                       std::string("garbage\n"),
                                       std::string("2 0.2 x\n"),
                                       "1 0.2" + row,
                                       std::string("\n"),
                                       std::string("2\n")})
      {
        EXPECT_NE(damage(without(third, instead)).find("that of step 2"),
                  std::string::npos)
          << instead;
        EXPECT_EQ(get(path), without(third));
      }
    // The end, and all.
    EXPECT_NE(damage(header + "0 0" + row + "1 0.1" + row).find("3 of 5 rows"),
              std::string::npos);
    for (const std::string &text :
         {header, std::string("# 1: St"), std::string()})
      {
        EXPECT_NE(damage(text).find("5 of 5 rows"), std::string::npos);
        EXPECT_EQ(get(path).find(header + "5 0.5"), 0u);
      }
    std::filesystem::remove(path);
    {
      Statistics statistics(path, 5);
      EXPECT_NE(statistics.damage().find("5 of 5 rows"), std::string::npos);
      add_rows(statistics, 5, 9);
    }
    EXPECT_EQ(get(path).find(header + "5 0.5"), 0u);

    // The header; the file stays as it is.
    for (const std::string line : {"# 1: Step\n", "# 3: Dyke width (m)\n"})
      {
        put(path, without(line));
        EXPECT_USER_ERROR(Statistics(path, 5),
                          "Output/Directory",
                          "the header of '" + path + "' is damaged");
        EXPECT_EQ(get(path), without(line));
      }
  }


  TEST(Output, statistics_that_cannot_be_written_are_the_users_matter)
  {
    const TemporaryFolder folder;
    EXPECT_USER_ERROR(Statistics(folder.file("none/statistics")),
                      "Output/Directory",
                      "cannot write '" + folder.file("none/statistics") + "'");
  }
} // namespace Waker::output_statistics
