// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_output_temporary_file_h
#define waker_source_output_temporary_file_h

#include <cstddef>
#include <string>

namespace Waker
{
  /// A new file under a name of our own beside `path`, "<path>.tmp" if there is
  /// none: the tasks of a job array may write the same file at the same time.
  /// One that a killed process has left stays. Private to the room.
  struct TemporaryFile
  {
    explicit TemporaryFile(const std::string &path);

    std::string name;
    int         descriptor; // open for writing; -1 if it cannot be made
    int         error;      // why: an errno; or 0
  };


  /// At its end. @return an errno, or 0
  int
  append(const TemporaryFile &file, const std::string &text);

  /// Over what is there.
  /// @param at first byte of the file
  /// @return an errno, or 0
  int
  overwrite(const TemporaryFile &file,
            const std::size_t    at,
            const std::string   &text);

  /// The end of it: closed, and renamed to `path`, or removed if there has been
  /// an error.
  /// @param to_disk is it to outlast a power cut? Then what other processes
  ///        have written must be on the disk already.
  /// @return `error` or, if that is 0, what goes wrong here
  int
  finish(const TemporaryFile &file,
         const std::string   &path,
         const bool           to_disk,
         int                  error);
} // namespace Waker

#endif
