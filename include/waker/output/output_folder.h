// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_output_folder_h
#define waker_output_output_folder_h

#include <functional>
#include <string>

namespace Waker
{
  /// "particles-00012.vtu" of "particles-" and ".vtu"?
  bool
  is_numbered(const std::string &name,
              const std::string &start,
              const std::string &end);

  /// Remove the files of a folder whose names `is_ours` knows, also those that
  /// a killed process has left under a temporary name ("log.txt.tmp"), or only
  /// these.
  /// @throws UserError "Output/Directory"
  void
  remove_files(const std::string                              &folder,
               const std::function<bool(const std::string &)> &is_ours,
               const bool temporary_only = false);

  /// Remove a run from its folder, and the folder if nothing else is in it.
  void
  remove_run_folder(const std::string &folder);

  /// @throws UserError "Output/Directory" if the folder holds a campaign, whose
  /// files a run would replace
  void
  refuse_campaign_folder(const std::string &directory);

  /// What a run does with a folder that is not empty.
  enum class FolderMode
  {
    must_be_new, // refuse
    overwrite,   // remove what a run has written there, and nothing else
    resume       // go on
  };

  /**
   * Would prepare_output_folder() work? Writes nothing.
   *
   * @throws UserError "Output/Directory" if the folder is a file, cannot be
   *         made, is not writable, is not empty (must_be_new), or is not there
   *         (resume)
   */
  void
  check_output_folder(const std::string &directory, const FolderMode mode);

  /**
   * Make the folder and "solution/" in it, remove the files of an earlier run
   * (overwrite) or what its killed process has left half written (resume), and
   * write parameters.prm.
   *
   * Only files that a run writes are ever removed, by their names: anything
   * else in the folder stays.
   *
   * @param parameters the text of all values used
   * @throws UserError as check_output_folder()
   */
  void
  prepare_output_folder(const std::string &directory,
                        const FolderMode   mode,
                        const std::string &parameters);
} // namespace Waker

#endif
