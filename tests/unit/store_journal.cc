// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/hash.h>
#include <waker/store/journal.h>

#include "store_journal_lines.h"
#include "user_errors.h"
#include <gtest/gtest.h>

namespace Waker::store_journal
{
  using namespace JournalLines;

  namespace
  {
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


  } // namespace


  TEST(Store, journals_return_what_was_appended)
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


  TEST(Store, journal_drops_a_last_line_without_end)
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


  TEST(Store, journal_reader_waits_for_the_end_of_a_line)
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


  TEST(Store, journal_counts_damaged_lines_and_keeps_the_rest)
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


  TEST(Store, journals_of_other_campaigns_are_skipped_and_named)
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
  TEST(Store, journal_finds_every_flipped_bit)
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
    // Each fifth bit of a line with numbers, and each 23rd of the whole file:
    // in turn the first to the last of a byte.
    const std::size_t second = whole.find('\n', first) + 1;
    const std::size_t third  = whole.find('\n', second) + 1;
    for (std::size_t bit = 0; bit < 8 * (whole.size() - 1); ++bit)
      {
        const std::size_t byte      = bit / 8;
        const bool        is_second = byte >= second && byte < third;
        if (bit % (is_second ? 5 : 23) != 0)
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


  TEST(Store, journal_without_checksums_must_hold_possible_values)
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


  TEST(Store, journal_whose_first_line_is_damaged_is_known_by_its_lines)
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


  TEST(Store, journal_of_a_newer_version_is_refused)
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


  TEST(Store, journals_count_a_realisation_once)
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
} // namespace Waker::store_journal
