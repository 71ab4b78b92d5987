// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_store_campaign_files_h
#define waker_store_campaign_files_h

#include <waker/output/output_files.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace Waker
{
  /**
   * The one list of what a campaign writes to its folder, as OutputFile is for
   * a run: writers get names from here, --overwrite removes what is here.
   */
  enum class CampaignFile
  {
    info,       // campaign.json
    parameters, // parameters.prm
    log,
    store // results.h5
  };

  /// Path in a campaign's folder.
  std::string
  campaign_path(const std::string &folder, const CampaignFile file);

  /// "log-2-of-10.txt" of the tasks of a job array, "log-from-500.txt".
  std::string
  chunk_log_name(const std::uint64_t chunk, const std::uint64_t n_chunks);
  std::string
  interval_log_name(const std::uint64_t first);

  /// "journal-00012.jsonl"
  std::string
  journal_name(const unsigned int number);

  /// The folder of the tables, "report".
  std::string
  report_folder(const std::string &folder);

  /// Path of a table in the report's folder.
  /// @throws std::logic_error if the table is not in the list
  std::string
  report_path(const std::string &report_folder, const std::string &name);

  /// "snapshots"
  std::string
  snapshots_folder(const std::string &folder);

  /// "0-17", of scenario 0 and realisation 17.
  std::string
  snapshot_name(const unsigned int scenario, const std::uint64_t realisation);

  /// Name of the folder of a snapshot that this process is making.
  std::string
  unfinished_name(const std::string &snapshot);

  /// "running/0-17": what is kept of a realisation under way.
  std::string
  running_folder(const std::string  &folder,
                 const unsigned int  scenario,
                 const std::uint64_t realisation);

  /// In it: how far it is.
  extern const std::string running_note_name;

  /// Scenario and realisation of the running folders that are there, ascending.
  std::vector<std::pair<unsigned int, std::uint64_t>>
  running_numbers(const std::string &folder);

  /// The files of one of them.
  std::vector<OwnFiles>
  files_of_running();

  /// All that a campaign may have written in its folder, those of its snapshots
  /// that are there among them; and what a run would: the folder may have been
  /// one's before.
  std::vector<OwnFiles>
  files_of_campaign(const std::string &folder);
} // namespace Waker

#endif
