// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/hash.h>
#include <waker/output/files.h>
#include <waker/store/journal.h>
#include <waker/store/journal_header.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <tuple>

namespace Waker
{
  namespace
  {
    /// Also of one that somebody has renamed: its results count.
    bool
    is_journal_name(const std::string &name)
    {
      const std::string prefix = "journal-", suffix = ".jsonl";
      return name.size() > prefix.size() + suffix.size() &&
             name.compare(0, prefix.size(), prefix) == 0 &&
             name.compare(name.size() - suffix.size(), suffix.size(), suffix) ==
               0;
    }
  } // namespace



  JournalReader::JournalReader(const std::string &folder,
                               const std::string &campaign_hash)
    : folder(folder)
    , campaign_hash(campaign_hash)
  {}



  std::vector<Record>
  JournalReader::poll()
  {
    namespace fs = std::filesystem;
    std::error_code        error;
    fs::directory_iterator entry(folder, error);
    while (!error && entry != fs::directory_iterator())
      {
        const std::string name = entry->path().filename().string();
        if (is_journal_name(name))
          journals[name];
        entry.increment(error);
      }
    if (error)
      throw UserError(folder,
                      "cannot be read: " + error.message(),
                      "the folder of a campaign");

    std::vector<Record> records;
    for (auto &[name, journal] : journals)
      read_new_lines(name, journal, records);
    return records;
  }



  JournalCounts
  JournalReader::counts() const
  {
    JournalCounts           counts = counted;
    std::vector<MachineUse> uses;
    for (const auto &[name, journal] : journals)
      {
        counts.n_journals += journal.is_ours ? 1 : 0;
        uses.push_back(journal.use);
        if (journal.size > journal.position)
          {
            ++counts.n_truncated;
            counts.remarks.push_back(name + ":" +
                                     std::to_string(journal.n_lines + 1) +
                                     ": the last line has no end; dropped");
          }
      }
    counts.machines = join(uses);
    return counts;
  }



  void
  JournalReader::read_new_lines(const std::string   &name,
                                Journal             &journal,
                                std::vector<Record> &records)
  {
    const std::string path = join_path(folder, name);
    const std::string kind = kind_of_irregular_file(path);
    if (!kind.empty())
      throw UserError(path,
                      "is no regular file, but " + kind,
                      "a journal, as the program wrote it");
    std::error_code error;
    journal.size = std::filesystem::file_size(path, error);
    if (!error && journal.size <= journal.position)
      return;

    std::string text;
    if (!error)
      {
        text.resize(journal.size - journal.position);
        std::ifstream file(path, std::ios::binary);
        file.seekg(static_cast<std::streamoff>(journal.position));
        file.read(text.data(), static_cast<std::streamsize>(text.size()));
        // It may have lost a part of a line since.
        text.resize(static_cast<std::size_t>(file.gcount()));
        journal.size = journal.position + text.size();
        if (!file && !file.eof())
          error = std::error_code(errno, std::generic_category());
      }
    if (error)
      throw UserError(path,
                      "cannot be read: " + error.message(),
                      "a readable file");

    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos;
         end             = text.find('\n', begin))
      {
                    const std::string line = text.substr(begin, end - begin);
                    begin                  = end + 1;
                    ++journal.n_lines;
                    if (journal.n_lines == 1)
          read_header(name, line, journal);
        else
          read_line(name + ":" + std::to_string(journal.n_lines),
                    line,
                    journal,
                    records);
      }
    journal.position += begin;
  }



  void
  JournalReader::read_header(const std::string &name,
                             const std::string &line,
                             Journal           &journal)
  {
    const JournalHeader header = read_journal_header(line);
    if (header.damaged)
      {
        journal.kind = Kind::damaged;
        ++counted.n_damaged;
        counted.remarks.push_back(name +
                                  ":1: the first line, which names the "
                                  "campaign, is damaged; lines are taken if "
                                  "their checksum is of this campaign");
      }
    else if (header.campaign != campaign_hash)
      {
        journal.kind = Kind::foreign;
        counted.remarks.push_back(name + ": of another campaign (" +
                                  header.campaign + ", not " + campaign_hash +
                                  "); skipped");
      }
    else if (header.schema_version > journal_schema_version)
      throw UserError(join_path(folder, name),
                      "has schema version " +
                        std::to_string(header.schema_version) +
                        ": it was written by a newer version of the program",
                      "schema versions up to " +
                        std::to_string(journal_schema_version));
    else
      {
        journal.is_ours = true;
        journal.kind    = header.has_checksums ? Kind::checked : Kind::plain;
        journal.use     = header.use;
      }
  }



  void
  JournalReader::read_line(const std::string   &place,
                           const std::string   &line,
                           Journal             &journal,
                           std::vector<Record> &records)
  {
    const Seal seal = journal.kind == Kind::foreign
                        ? Seal::none
                        : check_seal(line, campaign_hash);
    const bool is_foreign =
      journal.kind == Kind::foreign ||
      (journal.kind == Kind::damaged && seal != Seal::whole);
    if (is_foreign)
      ++counted.n_foreign;
    else if (seal == Seal::broken ||
             (seal == Seal::none && journal.kind == Kind::checked))
      {
        ++counted.n_damaged;
        counted.remarks.push_back(place + ": its checksum is wrong; dropped");
      }
    else
      {
        journal.is_ours        = true;
        journal.use.n_journals = 1;
        read_record(place, line, journal.use, records);
      }
  }



  void
  JournalReader::read_record(const std::string   &place,
                             const std::string   &line,
                             MachineUse          &use,
                             std::vector<Record> &records)
  {
    Record record;
    try
      {
        record = record_from_json(line);
      }
    catch (const std::runtime_error &error)
      {
        ++counted.n_damaged;
        counted.remarks.push_back(place + ": cannot be read (" + error.what() +
                                  "); dropped");
        return;
      }

    const std::uint64_t print = fingerprint(record);
    const auto [earlier, is_new] =
      known.try_emplace({record.scenario, record.realisation}, print);
    if (is_new)
      {
        ++counted.n_records;
        ++use.n_realisations;
        use.wall_time += record.wall_time;
        records.push_back(std::move(record));
      }
    else if (earlier->second == print)
      ++counted.n_repeated;
    else
      {
        ++counted.n_conflicting;
        counted.remarks.push_back(
          place + ": another result of scenario " +
          std::to_string(record.scenario) + ", realisation " +
          std::to_string(record.realisation) + "; the first one is kept");
      }
  }



  JournalContents
  read_journals(const std::string &folder, const std::string &campaign_hash)
  {
    JournalReader   reader(folder, campaign_hash);
    JournalContents contents;
    contents.records = reader.poll();
    contents.counts  = reader.counts();
    std::sort(contents.records.begin(),
              contents.records.end(),
              [](const Record &a, const Record &b) {
                return std::tie(a.scenario, a.realisation) <
                       std::tie(b.scenario, b.realisation);
              });
    return contents;
  }
} // namespace Waker
