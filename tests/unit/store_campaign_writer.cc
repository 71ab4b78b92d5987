// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/host.h>
#include <waker/store/campaign_writer.h>

#include "output_temporary_folder.h"
#include "processes.h"
#include <fcntl.h>
#include <gtest/gtest.h>
#include <memory>
#include <vector>

namespace Waker::store_campaign_writer
{
  namespace
  {
    std::size_t
    n_files(const std::string &folder)
    {
      std::error_code error;
      std::size_t     n = 0;
      for (std::filesystem::directory_iterator entry(folder, error);
           !error && entry != std::filesystem::directory_iterator();
           ++entry)
        ++n;
      return n;
    }
  } // namespace


  TEST(Store, writers_claim_each_realisation_once)
  {
    const TemporaryFolder folder;
    {
      const CampaignWriter first(folder.path), second(folder.path);
      auto                 claim = first.claim(0, 17);
      ASSERT_TRUE(claim.has_value());
      EXPECT_FALSE(second.claim(0, 17).has_value());
      EXPECT_FALSE(first.claim(0, 17).has_value());
      EXPECT_TRUE(second.claim(1, 17).has_value());
      EXPECT_TRUE(second.claim(0, 1).has_value());
      claim.reset();
      EXPECT_TRUE(second.claim(0, 17).has_value());
      EXPECT_EQ(n_files(folder.file("writers")), 2u); // the locks
      EXPECT_THROW(refuse_writers(folder.path), UserError);
    }
    EXPECT_NO_THROW(refuse_writers(folder.path));
    EXPECT_FALSE(std::filesystem::exists(folder.file("writers")));
  }


  TEST(Store, claims_of_a_killed_writer_are_free)
  {
    const TemporaryFolder folder;
    RunningProcess        process([&]() {
      auto writer = std::make_unique<CampaignWriter>(folder.path);
      auto claim  = writer->claim(0, 3);
      return std::make_pair(std::move(writer), std::move(claim));
    });
    const CampaignWriter  writer(folder.path);
    EXPECT_FALSE(writer.claim(0, 3).has_value());
    EXPECT_THROW(refuse_writers(folder.path), UserError);
    EXPECT_TRUE(writer.claim(0, 4).has_value());
    process.kill();
    EXPECT_EQ(n_files(folder.file("writers")), 3u);
    const auto claim = writer.claim(0, 3);
    EXPECT_TRUE(claim.has_value());
    EXPECT_FALSE(writer.claim(0, 3).has_value());

    // What it has left goes; what lives stays.
    remove_dead_writers(folder.path);
    EXPECT_EQ(n_files(folder.file("writers")), 2u);
    EXPECT_FALSE(writer.claim(0, 3).has_value());
  }


  TEST(Store, writer_of_another_host_is_respected_by_overwriting)
  {
    const TemporaryFolder folder;
    const std::string     path = folder.file("writers/elsewhere-7.lock");
    put(path,
        R"({"what":"waker campaign","host":"elsewhere","process":7,)"
        R"("since":"2026-01-31T12:00:00Z"})");
    remove_dead_writers(folder.path);
    try
      {
        refuse_writers(folder.path);
        FAIL();
      }
    catch (const UserError &error)
      {
        EXPECT_NE(error.problem.find("process 7 on elsewhere"),
                  std::string::npos)
          << error.problem;
        EXPECT_NE(error.allowed.find(path), std::string::npos) << error.allowed;
      }
    // It may join, and what the other one is known to have left is not held.
    std::filesystem::create_hard_link(path, folder.file("writers/claim-0-1"));
    const CampaignWriter writer(folder.path);
    EXPECT_TRUE(writer.claim(0, 1).has_value());
  }


  TEST(Store, writers_at_the_same_time_share_the_work)
  {
    const TemporaryFolder folder;
    constexpr unsigned    n_writers = 5, n_tasks = 200;
    std::vector<pid_t>    processes;
    std::filesystem::create_directory(folder.file("done"));
    for (unsigned int w = 0; w < n_writers; ++w)
      processes.push_back(in_another_process([&]() {
        const CampaignWriter writer(folder.path);
        int                  n_done = 0;
        for (unsigned int task = 0; task < n_tasks; ++task)
          {
            const std::string file =
              folder.file("done/" + std::to_string(task));
            const auto claim = writer.claim(0, task);
            if (!claim || std::filesystem::exists(file))
              continue;
            const int descriptor =
              ::open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY, 0666);
            if (descriptor < 0)
              return 98; // two at the same task
            ::close(descriptor);
            ++n_done;
          }
        return n_done > 0 ? 0 : 1; // 1: the others were faster
      }));
    for (const pid_t process : processes)
      {
        const int code = exit_code(process);
        EXPECT_TRUE(code == 0 || code == 1) << code;
      }
    EXPECT_EQ(n_files(folder.file("done")), n_tasks);
    EXPECT_FALSE(std::filesystem::exists(folder.file("writers")));
  }
} // namespace Waker::store_campaign_writer
