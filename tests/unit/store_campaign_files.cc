// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/store/campaign_files.h>

#include "output_temporary_folder.h"
#include <gtest/gtest.h>
#include <set>
#include <stdexcept>

namespace Waker::store_campaign_files
{
  namespace fs = std::filesystem;

  namespace
  {
    /// Paths of all that is in a folder, relative to it.
    std::set<std::string>
    contents(const std::string &folder)
    {
      std::set<std::string> paths;
      for (const auto &entry : fs::recursive_directory_iterator(folder))
        paths.insert(fs::relative(entry.path(), folder).string());
      return paths;
    }


    void
    remove_all_of_campaign(const std::string &folder)
    {
      const auto files = files_of_campaign(folder);
      refuse_other_kinds(folder, files);
      remove_files(folder, files);
    }
  } // namespace


  TEST(Store, files_of_a_campaign_go_and_nothing_else)
  {
    const TemporaryFolder folder;
    for (const std::string name :
         {"campaign.json",
          "parameters.prm",
          "results.h5",
          "results.h5.3.tmp",
          "log.txt",
          "log-2-of-10.txt",
          "log-from-500.txt",
          "journal-00000.jsonl",
          "journal-123456.jsonl",
          "report/realisations.csv",
          "report/report.json.tmp",
          "writers/node7-12.lock",
          "writers/claim-0-17",
          "snapshots/0-17/summary.json",
          "snapshots/0-17/walls.pvd",
          "snapshots/0-17/tractions.pvd",
          "snapshots/0-17/solution/walls-00001.vtu",
          "snapshots/0-17/checkpoints/checkpoint-1.bin",
          "snapshots/.1-3.node7.99/statistics",
          "snapshots/.1-3.node7.99/lock",
          // of a run that was there before
          "statistics",
          "walls.pvd",
          "solution/walls-00000.vtu"})
      put(folder.file(name), "x");
    const std::set<std::string> mine = {"logbook.txt",
                                        "log-2-of-ten.txt",
                                        "journal-of-mine.jsonl",
                                        "report",
                                        "report/notes.csv",
                                        "snapshots",
                                        "snapshots/0-18",
                                        "snapshots/0-18/notes.txt",
                                        "snapshots/best",
                                        "snapshots/best/summary.json",
                                        "writers",
                                        "writers/readme"};
    for (const std::string &name : mine)
      if (name.find('.') != std::string::npos || name == "writers/readme")
        put(folder.file(name), "x");
    put(folder.file("snapshots/0-18/walls.pvd"), "x");
    remove_all_of_campaign(folder.path);
    EXPECT_EQ(contents(folder.path), mine);
  }


  TEST(Store, files_of_a_campaign_are_never_reached_by_a_link)
  {
    const TemporaryFolder other;
    for (const std::string name : {"statistics",
                                   "report.json",
                                   "realisations.csv",
                                   "0-17/statistics",
                                   "particles-00001.vtu"})
      put(other.file(name), "mine");
    const std::set<std::string> before = contents(other.path);

    for (const std::string name : {"report",
                                   "snapshots",
                                   "snapshots/0-17",
                                   "snapshots/0-17/solution",
                                   "solution",
                                   "writers",
                                   "journal-00003.jsonl",
                                   "results.h5",
                                   "report/report.json"})
      {
        const TemporaryFolder folder;
        put(folder.file("campaign.json"), "x");
        fs::create_directories(fs::path(folder.file(name)).parent_path());
        fs::create_symlink(other.path, folder.file(name));
        const std::set<std::string> with_link = contents(folder.path);
        EXPECT_THROW(remove_all_of_campaign(folder.path), UserError) << name;
        // Nor would removing do it.
        EXPECT_EQ(contents(folder.path), with_link);
        remove_files(folder.path, files_of_campaign(folder.path));
        EXPECT_TRUE(fs::is_symlink(folder.file(name))) << name;
        EXPECT_EQ(contents(other.path), before) << name;
      }
  }


  TEST(Store, table_that_is_not_in_the_list_cannot_be_written)
  {
    EXPECT_EQ(report_path("a/report", "classes.csv"), "a/report/classes.csv");
    EXPECT_THROW(report_path("a/report", "new.csv"), std::logic_error);
  }
} // namespace Waker::store_campaign_files
