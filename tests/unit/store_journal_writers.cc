// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/file_error.h>
#include <waker/store/journal.h>

#include "processes.h"
#include "store_journal_lines.h"
#include <csignal>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <sys/resource.h>

namespace Waker::store_journal_writers
{
  using namespace JournalLines;

  namespace
  {
    FileError
    error_of_writing_to(const std::string &folder)
    {
      try
        {
          const JournalWriter writer(folder, hash);
        }
      catch (const FileError &error)
        {
          return error;
        }
      return {"", ""};
    }
  } // namespace


  TEST(Store, journals_of_writers_at_the_same_time_lose_nothing)
  {
    const TemporaryFolder folder;
    constexpr unsigned    n_writers = 4;
    constexpr unsigned    n_each    = 150;
    std::vector<pid_t>    writers;
    for (unsigned int w = 0; w < n_writers; ++w)
      writers.push_back(in_another_process([&]() {
        JournalWriter writer(folder.path, hash, -1.);
        for (unsigned int i = 0; i < n_each; ++i)
          writer.append(synthetic_record(w, i));
        return 0;
      }));

    // Read along.
    JournalReader                                    reader(folder.path, hash);
    std::set<std::pair<unsigned int, std::uint64_t>> read;
    const auto                                       take = [&]() {
      for (const Record &record : reader.poll())
        {
          EXPECT_TRUE(
            read.insert({record.scenario, record.realisation}).second);
          EXPECT_EQ(to_json(record),
                    to_json(
                      synthetic_record(record.scenario, record.realisation)));
        }
    };
    for (const pid_t pid : writers)
      {
        while (::waitpid(pid, nullptr, WNOHANG) == 0)
          take();
      }
    take();
    EXPECT_EQ(read.size(), n_writers * n_each);
    EXPECT_EQ(reader.counts().n_journals, n_writers);
    EXPECT_EQ(reader.counts().n_repeated, 0u);
    EXPECT_TRUE(reader.counts().remarks.empty());
  }


  TEST(Store, journal_keeps_every_finished_line_when_killed)
  {
    for (const unsigned int n_before_the_kill : {1u, 17u, 60u})
      {
        const TemporaryFolder folder;
        int                   ends[2];
        ASSERT_EQ(::pipe(ends), 0);
        const pid_t pid = in_another_process([&]() {
          JournalWriter writer(folder.path, hash, -1.);
          for (std::uint64_t i = 0;; ++i)
            {
              writer.append(synthetic_record(0, i));
              if (::write(ends[1], "x", 1) != 1)
                return 1;
            }
          return 0;
        });
        ::close(ends[1]);

        char         said;
        unsigned int n_finished = 0;
        while (n_finished < n_before_the_kill && ::read(ends[0], &said, 1) == 1)
          ++n_finished;
        ::kill(pid, SIGKILL);
        EXPECT_EQ(exit_code(pid), -SIGKILL);
        while (::read(ends[0], &said, 1) == 1) // what it had said until then
          ++n_finished;
        ::close(ends[0]);

        const JournalContents contents = read_journals(folder.path, hash);
        EXPECT_GE(contents.records.size(), n_finished);
        EXPECT_LE(contents.records.size(), n_finished + 1);
        for (std::size_t i = 0; i < contents.records.size(); ++i)
          EXPECT_EQ(to_json(contents.records[i]) + "\n", plain_line(i));
      }
  }


  TEST(Store, journals_say_which_machine_computed)
  {
    const TemporaryFolder folder;
    {
      JournalWriter first(folder.path, hash), second(folder.path, hash);
      for (const std::uint64_t i : {0, 1, 2})
        first.append(synthetic_record(0, i));
      second.append(synthetic_record(0, 3));
      second.append(synthetic_record(0, 3)); // not counted twice
    }
    JournalContents contents = read_journals(folder.path, hash);
    ASSERT_EQ(contents.counts.machines.size(), 1u);
    const MachineUse here      = contents.counts.machines[0];
    char             host[256] = "";
    ::gethostname(host, sizeof host - 1);
    EXPECT_EQ(here.machine.host, host);
    EXPECT_GE(here.machine.n_cores, 1u);
    EXPECT_NE(here.machine.compiler, "unknown");
    EXPECT_NE(here.machine.build_flags, "unknown");
    ASSERT_EQ(here.start.size(), 20u) << here.start;
    EXPECT_EQ(here.start.substr(0, 2) + here.start.substr(19), "20Z");
    EXPECT_EQ(here.n_journals, 2u);
    EXPECT_EQ(here.n_realisations, 4u);
    EXPECT_NEAR(here.wall_time, 4 * 0.25, 1e-12);

    // A journal of an earlier version, and one with values of another kind.
    put(journal(folder, 2),
        R"({"schema_version":1,"campaign":"0123abcd","version":"0.1.0"})"
        "\n" +
          plain_line(4));
    put(journal(folder, 3),
        R"({"schema_version":1,"campaign":"0123abcd","version":"0.1.0",)"
        R"("host":"aa","cores":"many","later":{}})"
        "\n" +
          plain_line(5) + plain_line(6));
    contents = read_journals(folder.path, hash);
    EXPECT_EQ(contents.records.size(), 7u);
    EXPECT_TRUE(contents.counts.remarks.empty());
    std::map<std::string, MachineUse> uses;
    for (const MachineUse &use : contents.counts.machines)
      uses[use.machine.host] = use;
    ASSERT_EQ(uses.size(), 3u);
    EXPECT_EQ(uses["unknown"].n_realisations, 1u);
    EXPECT_EQ(uses["unknown"].machine.processor, "unknown");
    EXPECT_EQ(uses["unknown"].machine.version, "0.1.0");
    EXPECT_EQ(uses["unknown"].machine.n_cores, 0u);
    EXPECT_EQ(uses["unknown"].start, "unknown");
    EXPECT_EQ(uses["aa"].n_realisations, 2u);
    EXPECT_EQ(uses["aa"].machine.n_cores, 0u);
  }


  TEST(Store, journal_on_a_full_disk_keeps_whole_lines)
  {
    const TemporaryFolder folder;
    const auto            exit = exit_code(in_another_process([&]() {
      // The system takes a part of the line that goes beyond the limit, as a
      // full disk does.
      ::signal(SIGXFSZ, SIG_IGN);
      rlimit limit;
      ::getrlimit(RLIMIT_FSIZE, &limit);
      const rlim_t none = limit.rlim_cur;
      limit.rlim_cur    = 5000;
      ::setrlimit(RLIMIT_FSIZE, &limit);

      JournalWriter writer(folder.path, hash);
      std::uint64_t n_written = 0;
      try
        {
          for (; n_written < 100; ++n_written)
            writer.append(synthetic_record(0, n_written));
          return 1;
        }
      catch (const FileError &error)
        {
          if (error.path != writer.path() ||
              error.problem != "cannot be written: File too large")
            return 2;
        }
      if (n_written < 2 || get(writer.path()).back() != '\n' ||
          read_journals(folder.path, hash).records.size() != n_written)
        return 3;

      // Space again: the same writer goes on.
      limit.rlim_cur = none;
      ::setrlimit(RLIMIT_FSIZE, &limit);
      writer.append(synthetic_record(0, n_written));
      return static_cast<int>(10 + n_written);
    }));
    ASSERT_GT(exit, 10) << exit;

    const JournalContents contents = read_journals(folder.path, hash);
    ASSERT_EQ(contents.records.size(), static_cast<std::size_t>(exit - 9));
    for (std::size_t i = 0; i < contents.records.size(); ++i)
      EXPECT_EQ(to_json(contents.records[i]) + "\n", plain_line(i));
    EXPECT_TRUE(contents.counts.remarks.empty());
  }


  TEST(Store, journal_that_cannot_be_created_is_refused)
  {
    const TemporaryFolder folder;
    put(folder.file("file"), "mine");
    const FileError none = error_of_writing_to(folder.file("none"));
    EXPECT_EQ(none.path, folder.file("none/journal-00000.jsonl"));
    EXPECT_EQ(none.problem, "cannot be written: No such file or directory");
    EXPECT_EQ(error_of_writing_to(folder.file("file")).problem,
              "cannot be written: Not a directory");

    // No room for its first line: no file either.
    const int code = exit_code(in_another_process([&]() {
      ::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit = {20, 20};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      return error_of_writing_to(folder.path).problem ==
                 "cannot be written: File too large"
               ? 0
               : 1;
    }));
    EXPECT_EQ(code, 0);
    EXPECT_FALSE(std::filesystem::exists(journal(folder)));

    // Root may write everywhere; its child is somebody else.
    ASSERT_EQ(::chmod(folder.path.c_str(), 0555), 0);
    const int refused = exit_code(in_another_process([&]() {
      const bool is_root = ::geteuid() == 0;
      if (is_root && (::setgid(65534) != 0 || ::setuid(65534) != 0))
        return 2;
      return error_of_writing_to(folder.path).problem ==
                 "cannot be written: Permission denied"
               ? 0
               : 1;
    }));
    ASSERT_EQ(::chmod(folder.path.c_str(), 0755), 0);
    if (refused == 2)
      GTEST_SKIP() << "this root may not become somebody else";
    EXPECT_EQ(refused, 0);
  }
} // namespace Waker::store_journal_writers
