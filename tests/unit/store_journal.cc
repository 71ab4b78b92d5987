// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/file_error.h>
#include <waker/base/hash.h>
#include <waker/store/journal.h>

#include "output_temporary_folder.h"
#include "processes.h"
#include "store_records.h"
#include "user_errors.h"
#include <csignal>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <sys/resource.h>

namespace Waker::store_journal
{
  namespace
  {
    const std::string hash = "0123abcd";


    void
    append(const std::string &path, const std::string &text)
    {
      std::ofstream(path, std::ios::binary | std::ios::app) << text;
    }


    std::string
    line(const std::uint64_t i)
    {
      return journal_line(synthetic_record(0, i), hash) + "\n";
    }


    /// Without a checksum, as earlier versions wrote it.
    std::string
    plain_line(const std::uint64_t i)
    {
      return to_json(synthetic_record(0, i)) + "\n";
    }


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


    /// Each journal of the folder: a name, "journal-00000.jsonl" is 0.
    std::string
    journal(const TemporaryFolder &folder, const unsigned int number = 0)
    {
      return folder.file("journal-0000" + std::to_string(number) + ".jsonl");
    }
  } // namespace


  TEST(Reliability, journals_return_what_was_appended)
  {
    const TemporaryFolder folder;
    {
      JournalWriter first(folder.path, hash);
      JournalWriter second(folder.path, hash, 0.); // sync each time
      EXPECT_EQ(first.path(), journal(folder, 0));
      EXPECT_EQ(second.path(), journal(folder, 1));
      for (const std::uint64_t i : {7, 2, 5})
        first.append(synthetic_record(1, i));
      for (const std::uint64_t i : {5, 1})
        second.append(synthetic_record(0, i));

      // Before the writers end.
      const JournalContents contents = read_journals(folder.path, hash);
      ASSERT_EQ(contents.records.size(), 5u);
      const std::vector<std::pair<unsigned int, std::uint64_t>> order = {
        {0, 1}, {0, 5}, {1, 2}, {1, 5}, {1, 7}};
      for (unsigned int k = 0; k < 5; ++k)
        EXPECT_EQ(to_json(contents.records[k]),
                  to_json(synthetic_record(order[k].first, order[k].second)));
      EXPECT_EQ(contents.counts.n_journals, 2u);
      EXPECT_EQ(contents.counts.n_records, 5u);
      EXPECT_TRUE(contents.counts.remarks.empty());
    }
    // A later writer leaves them alone.
    EXPECT_EQ(JournalWriter(folder.path, hash).path(), journal(folder, 2));
    EXPECT_EQ(read_journals(folder.path, hash).records.size(), 5u);
  }


  TEST(Reliability, journal_drops_a_last_line_without_end)
  {
    const TemporaryFolder folder;
    JournalWriter(folder.path, hash).append(synthetic_record(0, 0));
    append(journal(folder), line(1).substr(0, 200));
    JournalWriter(folder.path, hash).append(synthetic_record(0, 2));

    const JournalContents contents = read_journals(folder.path, hash);
    ASSERT_EQ(contents.records.size(), 2u);
    EXPECT_EQ(contents.records[1].realisation, 2u);
    EXPECT_EQ(contents.counts.n_truncated, 1u);
    EXPECT_EQ(contents.counts.n_damaged, 0u);
    ASSERT_EQ(contents.counts.remarks.size(), 1u);
    EXPECT_EQ(contents.counts.remarks[0],
              "journal-00000.jsonl:3: the last line has no end; dropped");
  }


  TEST(Reliability, journal_reader_waits_for_the_end_of_a_line)
  {
    const TemporaryFolder folder;
    JournalReader         reader(folder.path, hash);
    EXPECT_TRUE(reader.poll().empty());

    // The first line comes in two parts, too.
    JournalWriter(folder.path, hash).append(synthetic_record(0, 0));
    const std::string whole = get(journal(folder));
    put(journal(folder), whole.substr(0, 10));
    EXPECT_TRUE(reader.poll().empty());
    EXPECT_EQ(reader.counts().n_journals, 0u);
    append(journal(folder), whole.substr(10));
    EXPECT_EQ(reader.poll().size(), 1u);
    EXPECT_TRUE(reader.poll().empty());

    append(journal(folder), line(1) + line(2).substr(0, 30));
    EXPECT_EQ(reader.poll().size(), 1u);
    EXPECT_EQ(reader.counts().n_truncated, 1u);
    EXPECT_TRUE(reader.poll().empty());
    append(journal(folder), line(2).substr(30));
    const std::vector<Record> last = reader.poll();
    ASSERT_EQ(last.size(), 1u);
    EXPECT_EQ(to_json(last[0]) + "\n", plain_line(2));
    EXPECT_EQ(reader.counts().n_truncated, 0u);
    EXPECT_EQ(reader.counts().n_records, 3u);
  }


  TEST(Reliability, journal_counts_damaged_lines_and_keeps_the_rest)
  {
    const TemporaryFolder folder;
    JournalWriter(folder.path, hash).append(synthetic_record(0, 0));
    std::string holes = line(2);
    std::fill(holes.begin() + 40, holes.begin() + 80, '\0');
    append(journal(folder), line(1).substr(0, 99) + "\n" + holes + "\n");
    append(journal(folder), line(3));

    const JournalContents contents = read_journals(folder.path, hash);
    ASSERT_EQ(contents.records.size(), 2u);
    EXPECT_EQ(contents.records[1].realisation, 3u);
    EXPECT_EQ(contents.counts.n_damaged, 3u); // one is empty
    ASSERT_EQ(contents.counts.remarks.size(), 3u);
    EXPECT_EQ(contents.counts.remarks[0],
              "journal-00000.jsonl:3: its checksum is wrong; dropped");
  }


  TEST(Reliability, journals_of_other_campaigns_are_skipped_and_named)
  {
    const TemporaryFolder folder;
    JournalWriter(folder.path, hash).append(synthetic_record(0, 0));
    {
      JournalWriter other(folder.path, "ffff");
      other.append(synthetic_record(0, 1));
      other.append(synthetic_record(0, 2));
    }
    put(journal(folder, 2), "not JSON\n" + plain_line(3));
    put(journal(folder, 3), ""); // its writer was killed at once
    put(folder.file("journal.txt"), "mine\n");

    const JournalContents contents = read_journals(folder.path, hash);
    EXPECT_EQ(contents.records.size(), 1u);
    EXPECT_EQ(contents.counts.n_journals, 1u);
    EXPECT_EQ(contents.counts.n_foreign, 3u);
    EXPECT_EQ(contents.counts.n_damaged, 1u);
    ASSERT_EQ(contents.counts.remarks.size(), 2u);
    EXPECT_EQ(contents.counts.remarks[0],
              "journal-00001.jsonl: of another campaign (ffff, not 0123abcd); "
              "skipped");
    EXPECT_NE(contents.counts.remarks[1].find("journal-00002.jsonl:1:"),
              std::string::npos);
  }


  // One flipped bit anywhere loses one line, which is counted, and changes
  // none.
  TEST(Reliability, journal_finds_every_flipped_bit)
  {
    const TemporaryFolder folder;
    {
      JournalWriter writer(folder.path, hash);
      for (const std::uint64_t i : {0, 1, 2})
        writer.append(synthetic_record(0, i));
    }
    const std::string   whole = get(journal(folder));
    std::vector<Record> right = read_journals(folder.path, hash).records;
    ASSERT_EQ(right.size(), 3u);
    const std::size_t first = whole.find('\n') + 1;
    // All bits of a line with numbers, and each seventh of the whole file.
    const std::size_t second = whole.find('\n', first) + 1;
    const std::size_t third  = whole.find('\n', second) + 1;
    for (std::size_t bit = 0; bit < 8 * (whole.size() - 1); ++bit)
      {
        const std::size_t byte      = bit / 8;
        const bool        is_second = byte >= second && byte < third;
        if (!is_second && bit % 7 != 0)
          continue;
        std::string damaged = whole;
        damaged[byte]       = static_cast<char>(damaged[byte] ^ (1 << bit % 8));
        put(journal(folder), damaged);

        const JournalContents contents = read_journals(folder.path, hash);
        EXPECT_GE(contents.counts.n_damaged, 1u) << bit;
        EXPECT_EQ(contents.counts.remarks.empty(), false) << bit;
        // An end of line that is lost takes two with it.
        EXPECT_GE(contents.records.size(), 1u) << bit;
        if (byte < first - 1)
          {
            EXPECT_EQ(contents.records.size(), 3u) << bit;
          }
        else if (damaged[byte] != '\n' && whole[byte] != '\n')
          {
            EXPECT_EQ(contents.records.size(), 2u) << bit;
          }
        for (const Record &record : contents.records)
          EXPECT_EQ(fingerprint(record),
                    fingerprint(right.at(record.realisation)))
            << bit;
      }
  }


  TEST(Reliability, journal_without_checksums_must_hold_possible_values)
  {
    const TemporaryFolder folder;
    std::string           line = plain_line(1);
    const std::string     key  = "\"residual_height\":";
    line.insert(line.find(key) + key.size(), "1" + std::string(20, '0'));
    put(journal(folder),
        "{\"schema_version\":1,\"campaign\":\"0123abcd\"}\n" + plain_line(0) +
          line);
    const JournalContents contents = read_journals(folder.path, hash);
    ASSERT_EQ(contents.records.size(), 1u);
    EXPECT_EQ(contents.counts.n_damaged, 1u);
    ASSERT_EQ(contents.counts.remarks.size(), 1u);
    EXPECT_NE(
      contents.counts.remarks[0].find(
        "journal-00000.jsonl:3: cannot be read (\"residual_height\" is "),
      std::string::npos)
      << contents.counts.remarks[0];
  }


  TEST(Reliability, journal_whose_first_line_is_damaged_is_known_by_its_lines)
  {
    const TemporaryFolder folder;
    JournalWriter(folder.path, hash).append(synthetic_record(0, 1));
    std::string text = get(journal(folder));
    text[2] ^= 1;
    put(journal(folder),
        text + journal_line(synthetic_record(0, 2), "ffff") + "\n");
    const JournalContents contents = read_journals(folder.path, hash);
    ASSERT_EQ(contents.records.size(), 1u);
    EXPECT_EQ(contents.records[0].realisation, 1u);
    EXPECT_EQ(contents.counts.n_damaged, 1u);
    EXPECT_EQ(contents.counts.n_foreign, 1u);
    EXPECT_EQ(contents.counts.n_journals, 1u);
    ASSERT_EQ(contents.counts.machines.size(), 1u);
    EXPECT_EQ(contents.counts.machines[0].machine.host, "unknown");
    EXPECT_EQ(contents.counts.machines[0].start, "unknown");
  }


  TEST(Reliability, journal_of_a_newer_version_is_refused)
  {
    const TemporaryFolder folder;
    JournalWriter(folder.path, hash).append(synthetic_record(0, 0));
    put(journal(folder),
        sealed(R"({"schema_version":3,"campaign":"0123abcd"})", "") + "\n");
    try
      {
        read_journals(folder.path, hash);
        FAIL();
      }
    catch (const UserError &error)
      {
        EXPECT_EQ(error.where, journal(folder));
        EXPECT_NE(error.problem.find("newer version"), std::string::npos);
      }
    EXPECT_USER_ERROR(read_journals(folder.file("none"), hash),
                      folder.file("none"),
                      "cannot be read");
  }


  TEST(Reliability, journals_count_a_realisation_once)
  {
    const TemporaryFolder folder;
    Record                record = synthetic_record(0, 1);
    JournalWriter(folder.path, hash).append(record);
    JournalWriter second(folder.path, hash);
    record.wall_time *= 2.; // another computer
    second.append(record);
    record.residual_height += 1e-15;
    second.append(record);

    const JournalContents contents = read_journals(folder.path, hash);
    ASSERT_EQ(contents.records.size(), 1u);
    EXPECT_EQ(to_json(contents.records[0]), to_json(synthetic_record(0, 1)));
    EXPECT_EQ(contents.counts.n_records, 1u);
    EXPECT_EQ(contents.counts.n_repeated, 1u);
    EXPECT_EQ(contents.counts.n_conflicting, 1u);
    ASSERT_EQ(contents.counts.remarks.size(), 1u);
    EXPECT_EQ(contents.counts.remarks[0],
              "journal-00001.jsonl:3: another result of scenario 0, "
              "realisation 1; the first one is kept");
  }


  TEST(Reliability, journals_of_writers_at_the_same_time_lose_nothing)
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


  TEST(Reliability, journal_keeps_every_finished_line_when_killed)
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


  TEST(Reliability, journals_say_which_machine_computed)
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


  TEST(Reliability, journal_on_a_full_disk_keeps_whole_lines)
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


  TEST(Reliability, journal_that_cannot_be_created_is_refused)
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
} // namespace Waker::store_journal
