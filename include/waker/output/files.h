// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_files_h
#define waker_output_files_h

#include <waker/base/read_file.h>

#include <cstdint>
#include <string>

namespace Waker
{
  /**
   * Write a whole file under a temporary name ("<path>.tmp") and rename it: a
   * reader, or a run that was killed, never sees half a file.
   *
   * @param to_disk wait until the contents are on the disk (fsync), for files
   *        that must survive a power cut; slow (milliseconds)
   * @throws as throw_cannot_write()
   */
  void
  write_file(const std::string &path,
             const std::string &contents,
             const bool         to_disk = false);

  /// What all writers throw, with the path and the system's words for `error`,
  /// an errno: FileError of a full disk and the like, UserError
  /// "Output/Directory" of a place where nothing can be written.
  [[noreturn]] void
  throw_cannot_write(const std::string &path, const int error);

  /// UserError of a pipe, say, or a folder in place of a file of ours.
  [[noreturn]] void
  throw_no_regular_file(const std::string &path, const std::string &kind);

  /// Make a folder, and those above it. @throws as throw_cannot_write()
  void
  make_folder(const std::string &path);

  /// "folder/name"; just "name" if the folder is empty.
  std::string
  join_path(const std::string &folder, const std::string &name);

  /// A file that grows. A text is in it as a whole, with the operating system
  /// (kill -9 does not lose it), or not at all.
  class AppendFile
  {
  public:
    /// @param empty begin anew: what is in it is lost
    /// @throws UserError "Output/Directory", also of a symbolic link, and of
    /// what is no regular file
    AppendFile(const std::string &path, const bool empty);

    /// Takes over a descriptor, open for appending, of an empty file.
    AppendFile(const std::string &path, const int descriptor);

    ~AppendFile();

    AppendFile(const AppendFile &) = delete;
    AppendFile &
    operator=(const AppendFile &) = delete;

    /// @return false, with errno, if the disk is full or the device gone: the
    /// file is then as it was before
    bool
    write(const std::string &text);

    /// Wait until all is on the disk. @return false, with errno
    bool
    sync();

    const std::string &
    path() const
    {
      return name;
    }

  private:
    std::string   name;
    int           descriptor = -1;
    std::uint64_t length     = 0; // of whole texts, bytes
  };
} // namespace Waker

#endif
