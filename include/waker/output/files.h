// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_files_h
#define waker_output_files_h

#include <string>

namespace Waker
{
  /**
   * Write a whole file under a temporary name ("<path>.tmp") and rename it: a
   * reader, or a run that was killed, never sees half a file.
   *
   * @param to_disk wait until the contents are on the disk (fsync), for files
   *        that must survive a power cut; slow (milliseconds)
   * @throws UserError "Output/Directory" if the file cannot be written
   */
  void
  write_file(const std::string &path,
             const std::string &contents,
             const bool         to_disk = false);

  /// The whole file. @throws UserError with its path if it cannot be read
  std::string
  read_file(const std::string &path);

  /// "folder/name"; just "name" if the folder is empty.
  std::string
  join_path(const std::string &folder, const std::string &name);
} // namespace Waker

#endif
