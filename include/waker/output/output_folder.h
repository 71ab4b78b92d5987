// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_output_folder_h
#define waker_output_output_folder_h

#include <string>

namespace Waker
{
  /// Remove a run from its folder, and the folder if nothing else is in it. A
  /// link in place of the folder stays.
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
    resume,      // go on
    only_checked // nothing will be written: it may hold anything
  };

  /**
   * Would prepare_output_folder() work? Writes nothing.
   *
   * The folder itself may be a symbolic link: it is then the folder that the
   * link points to. What we write in it may not.
   *
   * @throws UserError "Output/Directory" if the folder is a file, cannot be
   *         made, is not writable, is not empty (must_be_new), is not there
   *         (resume), or has a link in place of what a run writes
   */
  void
  check_output_folder(const std::string &directory, const FolderMode mode);

  /// What a check of the input says of its folder: "Valid. Nothing was
  /// written.", and what a run would need if it is not empty.
  std::string
  valid_text(const std::string &directory);

  /**
   * With the folder's lock held (see folder_lock.h): make "solution/" in it,
   * remove the files of an earlier run
   * (overwrite) or what its killed process has left half written (resume), and
   * write parameters.prm.
   *
   * Only files that a run writes are ever removed, by their names
   * (output_files.h): anything else in the folder stays.
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
