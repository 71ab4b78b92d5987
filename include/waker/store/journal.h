// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_store_journal_h
#define waker_store_journal_h

#include <waker/output/files.h>
#include <waker/store/machine.h>
#include <waker/store/record.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Waker
{
  /// Of the lines of a journal; a test keeps the earlier ones readable. 1:
  /// lines without checksums.
  constexpr unsigned int journal_schema_version = 2;

  /// The line of a record, without its end: JSON with a checksum that includes
  /// the hash of the campaign, so that a line proves whose it is.
  std::string
  journal_line(const Record &record, const std::string &campaign_hash);

  /**
   * A file journal-NNNNN.jsonl of its own in the folder of a campaign: a line
   * that says whose it is and which machine writes, then one line per finished
   * realisation. A line is with the operating system when append() returns:
   * kill -9 of this process does not lose it. The folder may be shared by any
   * number of writers, on any number of machines.
   */
  class JournalWriter
  {
  public:
    /**
     * Creates the file.
     *
     * @param folder        of the campaign, exists
     * @param campaign_hash CampaignInfo::hash
     * @param sync_interval seconds after which append() waits until all is on
     *        the disk (fsync), against power cuts; < 0: never
     * @throws UserError with the folder if no file can be made there
     */
    JournalWriter(const std::string &folder,
                  const std::string &campaign_hash,
                  const double       sync_interval = 10.);
    ~JournalWriter();

    JournalWriter(const JournalWriter &) = delete;
    JournalWriter &
    operator=(const JournalWriter &) = delete;

    /**
     * Write the line of a record.
     *
     * @throws UserError with the path if the disk is full, a quota reached or
     *         the device gone. The file ends with the last whole line then,
     *         so that another attempt may follow.
     */
    void
    append(const Record &record);

    const std::string &
    path() const;

  private:
    void
    write_line(const std::string &line);

    std::unique_ptr<AppendFile> file;
    std::string                 campaign_hash;

    double                                sync_interval;
    std::chrono::steady_clock::time_point last_sync;
  };



  /// What was in the journals of a folder and is not among the records.
  struct JournalCounts
  {
    std::uint64_t n_journals  = 0; // of this campaign
    std::uint64_t n_records   = 0; // kept
    std::uint64_t n_truncated = 0; // last lines without an end
    /// Whole lines that cannot be read, whose checksum is wrong, or whose
    /// values are impossible.
    std::uint64_t n_damaged = 0;
    std::uint64_t n_foreign = 0; // lines in journals of other campaigns
    /// Of a realisation that had been read before, with the same result.
    std::uint64_t n_repeated = 0;
    /// The same, with another result: the first one in order of file is kept.
    std::uint64_t n_conflicting = 0;

    /// Who computed the records kept (see join()).
    std::vector<MachineUse> machines;

    /// A sentence with file and line for each of these, but the repeated.
    std::vector<std::string> remarks;
  };



  /**
   * Reads the journals of a campaign while others still write them: each
   * poll() returns what has been added since the last one. A line without an
   * end is left for the next poll.
   */
  class JournalReader
  {
  public:
    JournalReader(const std::string &folder, const std::string &campaign_hash);

    /**
     * The new records, in order of file and line, each realisation of a
     * scenario once only.
     *
     * @throws UserError with the path if a file or the folder cannot be read,
     *         or is of a newer version of the program
     */
    std::vector<Record>
    poll();

    /// Up to the last poll. Lines without an end: those that are so now.
    JournalCounts
    counts() const;

  private:
    /// What its first line says.
    enum class Kind
    {
      unknown, // not read yet
      plain,   // lines without checksums, schema version 1
      checked, // each line must have its checksum
      damaged, // the first line: a line is ours if its checksum fits
      foreign  // of another campaign
    };

    struct Journal
    {
      MachineUse    use;
      std::uint64_t position = 0;     // behind the last whole line, bytes
      std::uint64_t size     = 0;     // when last looked at, bytes
      std::uint64_t n_lines  = 0;     // read
      bool          is_ours  = false; // has lines of this campaign
      Kind          kind     = Kind::unknown;
    };

    void
    read_new_lines(const std::string   &name,
                   Journal             &journal,
                   std::vector<Record> &records);

    void
    read_header(const std::string &name,
                const std::string &line,
                Journal           &journal);

    void
    read_line(const std::string   &place,
              const std::string   &line,
              Journal             &journal,
              std::vector<Record> &records);

    void
    read_record(const std::string   &place,
                const std::string   &line,
                MachineUse          &use,
                std::vector<Record> &records);

    std::string                    folder;
    std::string                    campaign_hash;
    std::map<std::string, Journal> journals;
    JournalCounts                  counted;

    /// Of (scenario, realisation): the fingerprint of the record kept.
    std::map<std::pair<unsigned int, std::uint64_t>, std::uint64_t> known;
  };



  struct JournalContents
  {
    std::vector<Record> records; // in order of scenario and realisation
    JournalCounts       counts;
  };

  /// All journals of a folder, as JournalReader.
  JournalContents
  read_journals(const std::string &folder, const std::string &campaign_hash);
} // namespace Waker

#endif
