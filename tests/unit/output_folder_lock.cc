// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/host.h>
#include <waker/output/folder_lock.h>
#include <waker/output/output_files.h>
#include <waker/output/output_folder.h>

#include "output_temporary_folder.h"
#include "processes.h"
#include "user_errors.h"
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace Waker::output_folder_lock
{
  namespace
  {
    using State = FolderLock::State;


    UserError
    refusal(const std::string &folder)
    {
      try
        {
          lock_folder(folder, "a test");
        }
      catch (const UserError &error)
        {
          EXPECT_EQ(error.where, "Output/Directory");
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


  TEST(Output, lock_is_held_by_one_and_says_by_whom)
  {
    const TemporaryFolder folder;
    const std::string     path = folder.file("new/lock");
    {
      const FolderLock lock = lock_folder(folder.file("new"), "waker run");
      EXPECT_EQ(lock.state(), State::ours);
      EXPECT_EQ(lock.path(), path);
      const std::string text = get(path);

      LockHolder holder;
      EXPECT_EQ(FolderLock::look(path, holder), State::held);
      EXPECT_EQ(holder.what, "waker run");
      EXPECT_EQ(holder.host, host_name());
      EXPECT_EQ(holder.process, ::getpid());
      EXPECT_EQ(holder.since.size(), 20u);

      const UserError error = refusal(folder.file("new"));
      EXPECT_TRUE(contains(error.problem,
                           "is in use by waker run, process " +
                             std::to_string(::getpid()) + " on " + host_name()))
        << error.problem;
      EXPECT_THROW(refuse_locked_folder(folder.file("new")), UserError);
      EXPECT_FALSE(FolderLock::remove_dead(path));
      EXPECT_EQ(get(path), text);

      // It may move.
      FolderLock       other(folder.file("other"), "a test");
      const FolderLock moved(std::move(other));
      EXPECT_EQ(FolderLock::look(folder.file("other"), holder), State::held);
    }
    EXPECT_FALSE(std::filesystem::exists(path));
    EXPECT_FALSE(std::filesystem::exists(folder.file("other")));
    EXPECT_EQ(refusal(folder.file("new")).problem, "");
    EXPECT_NO_THROW(refuse_locked_folder(folder.file("new")));
    EXPECT_NO_THROW(refuse_locked_folder(folder.file("none")));
  }


  TEST(Output, lock_of_a_killed_process_is_taken_over)
  {
    const TemporaryFolder folder;
    const std::string     path = folder.file("lock");
    const KilledProcess   process([&]() { return FolderLock(path, "child"); });
    ASSERT_TRUE(std::filesystem::exists(path));
    LockHolder holder;
    EXPECT_EQ(FolderLock::look(path, holder), State::ours);
    EXPECT_EQ(holder.what, "child");

    const FolderLock lock(path, "parent");
    EXPECT_EQ(lock.state(), State::ours);
    EXPECT_EQ(FolderLock::look(path, holder), State::held);
    EXPECT_EQ(holder.what, "parent");
    EXPECT_EQ(holder.process, ::getpid());
  }


  TEST(Output, lock_of_a_process_that_lives_is_respected)
  {
    const TemporaryFolder folder;
    RunningProcess        process(
      [&]() { return FolderLock(folder.file("lock"), "x"); });
    EXPECT_TRUE(contains(refusal(folder.path).problem,
                         "process " + std::to_string(process.id())));
    process.kill();
    EXPECT_EQ(refusal(folder.path).problem, "");
  }


  TEST(Output, lock_of_another_host_is_refused_with_advice)
  {
    const TemporaryFolder folder;
    const std::string     path = folder.file("lock");
    const std::string     text = R"({"what":"waker run","host":"not-)" +
                             host_name() +
                             R"(","process":7,"since":"2026-01-31T12:00:00Z"})";
    put(path, text);
    const UserError error = refusal(folder.path);
    EXPECT_TRUE(
      contains(error.problem, "may be in use by waker run, process 7"))
      << error.problem;
    EXPECT_TRUE(contains(error.problem, "not-" + host_name()));
    EXPECT_TRUE(contains(error.problem, "2026-01-31"));
    EXPECT_TRUE(contains(error.allowed, "remove '" + path + "'"));
    EXPECT_EQ(get(path), text);

    std::filesystem::remove(path); // as it says
    EXPECT_EQ(refusal(folder.path).problem, "");
  }


  TEST(Output, lock_that_says_nothing_is_free)
  {
    // Its process was killed before it could write, or the disk was full.
    const TemporaryFolder folder;
    const std::string     path = folder.file("lock");
    std::string           whole;
    {
      const FolderLock lock(path, "a \"test\"");
      whole = get(path);
    }
    ASSERT_GT(whole.size(), 50u);
    for (std::size_t size = 0; size <= whole.size(); ++size)
      {
        put(path, whole.substr(0, size));
        EXPECT_EQ(refusal(folder.path).problem, "") << whole.substr(0, size);
        EXPECT_FALSE(std::filesystem::exists(path)); // taken, and let go
      }
    put(path, std::string(100, '\0')); // after a power cut
    EXPECT_EQ(refusal(folder.path).problem, "");
  }


  TEST(Output, lock_that_is_not_ours_stays)
  {
    const TemporaryFolder folder;
    const std::string     path = folder.file("lock");
    for (const std::string &text : {std::string("mine"),
                                    std::string("\n"),
                                    std::string("[]"),
                                    std::string("{}"),
                                    std::string(R"({"what":3})"),
                                    std::string(R"({"what":"a","host":"b"})"),
                                    std::string(R"({"what":"a"} )"),
                                    std::string(R"({"when":"a")"),
                                    R"({"what":")" + std::string(5000, 'x')})
      {
        put(path, text);
        const UserError error = refusal(folder.path);
        EXPECT_EQ(error.problem,
                  "'" + folder.path + "' holds a file lock that is not ours");
        EXPECT_TRUE(contains(error.allowed, "move '" + path + "' away"));
        EXPECT_USER_ERROR(refuse_locked_folder(folder.path),
                          "Output/Directory",
                          "holds a file lock that is not ours");
        remove_run_folder(folder.path);
        EXPECT_EQ(get(path), text);
      }
    std::filesystem::remove(path); // as it says
    EXPECT_EQ(refusal(folder.path).problem, "");
  }


  TEST(Output, lock_does_not_follow_a_link)
  {
    const TemporaryFolder folder;
    put(folder.file("mine"), "mine");
    std::filesystem::create_symlink("mine", folder.file("lock"));
    EXPECT_TRUE(contains(refusal(folder.path).problem, "cannot write"));
    EXPECT_THROW(refuse_locked_folder(folder.path), UserError);
    EXPECT_EQ(get(folder.file("mine")), "mine");
    std::filesystem::remove(folder.file("mine")); // dangling
    EXPECT_TRUE(contains(refusal(folder.path).problem, "cannot write"));
    EXPECT_FALSE(std::filesystem::exists(folder.file("mine")));
  }


  TEST(Output, lock_lets_one_in_at_a_time)
  {
    const TemporaryFolder folder;
    std::vector<pid_t>    processes;
    for (unsigned int i = 0; i < 6; ++i)
      processes.push_back(in_another_process([&]() {
        // Each comes in 30 times; two at once could not both make the folder.
        for (unsigned int n_in = 0; n_in < 30;)
          {
            const FolderLock lock(folder.file("lock"), "a test");
            if (lock.state() != State::ours)
              continue;
            if (::mkdir(folder.file("inside").c_str(), 0777) != 0)
              return 1;
            if (::rmdir(folder.file("inside").c_str()) != 0)
              return 2;
            ++n_in;
          }
        return 0;
      }));
    for (const pid_t process : processes)
      EXPECT_EQ(exit_code(process), 0);
    EXPECT_FALSE(std::filesystem::exists(folder.file("lock")));
  }
} // namespace Waker::output_folder_lock
