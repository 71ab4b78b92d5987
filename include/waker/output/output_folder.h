// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_output_folder_h
#define waker_output_output_folder_h

#include <string>

namespace Waker
{
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
   * if `mode` says so, and write parameters.prm.
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
