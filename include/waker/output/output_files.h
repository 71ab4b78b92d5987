// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_output_files_h
#define waker_output_output_files_h

#include <functional>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * The one list of what a run or a strength reduction writes to its folder.
   * Writers get names from here, and what removes an earlier run goes through
   * all that is here: a file that is not listed has no name to be written
   * under.
   */
  enum class OutputFile
  {
    parameters,
    log,
    statistics,
    summary,
    strength_table,
    strength_result
  };

  /// "statistics": its name in the output folder.
  std::string
  file_name(const OutputFile file);

  /// The same with the folder.
  std::string
  file_path(const std::string &folder, const OutputFile file);

  /// Time series of .vtu files for ParaView.
  enum class FieldSeries
  {
    particles,
    surface,
    tractions,
    walls,
    grid,
    top_view,
    ground_lines
  };

  constexpr unsigned int n_field_series =
    static_cast<unsigned int>(FieldSeries::ground_lines) + 1;

  /// "surface"
  std::string
  series_name(const FieldSeries series);

  /// "solution/surface-00012.vtu"
  std::string
  frame_name(const FieldSeries series, const std::size_t number);

  /// "checkpoints/checkpoint-0.bin"
  std::string
  checkpoint_name(const unsigned int slot);

  /// "lock": who is writing there (see folder_lock.h).
  extern const std::string lock_name;

  /// "campaign.json": a folder with it is a campaign's, not a run's.
  extern const std::string campaign_info_name;


  /// Files of ours in one folder, by their names.
  struct OwnFiles
  {
    std::string                              subfolder; // "": the folder itself
    std::function<bool(const std::string &)> is_ours;   // by name
  };

  /// "particles-00012.vtu" of "particles-" and ".vtu"?
  bool
  is_numbered(const std::string &name,
              const std::string &start,
              const std::string &end);

  /// "log.txt" of "log.txt.tmp" and "log.txt.2.tmp", which processes write
  /// first, and leave if they are killed.
  std::string
  without_temporary_end(std::string name);

  /// Is it one of them?
  std::function<bool(const std::string &)>
  is_one_of(const std::vector<std::string> &names);

  /// All that a run or a strength reduction may have written, but the lock.
  std::vector<OwnFiles>
  files_of_run();

  /**
   * Also of the lock.
   *
   * @throws UserError "Output/Directory" if a subfolder or a file of these is a
   *         symbolic link: what it points to, outside of the folder, would be
   *         changed; or a file is no regular one: a pipe would make us wait
   */
  void
  refuse_other_kinds(const std::string           &folder,
                     const std::vector<OwnFiles> &files);

  /**
   * Remove these files, also those that a killed process has left under a
   * temporary name ("log.txt.tmp"), or only the latter; then the subfolders
   * that are empty. Links are left alone.
   *
   * @throws UserError "Output/Directory"
   */
  void
  remove_files(const std::string           &folder,
               const std::vector<OwnFiles> &files,
               const bool                   temporary_only = false);
} // namespace Waker

#endif
