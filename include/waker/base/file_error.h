// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_file_error_h
#define waker_base_file_error_h

#include <stdexcept>
#include <string>

namespace Waker
{
  /**
   * A file could not be written: a full disk, a quota, a device's error. No
   * mistake in the input, and something may have been written by then: the
   * program exits with code 4.
   */
  class FileError : public std::runtime_error
  {
  public:
    /**
     * @param path of the file
     * @param what has gone wrong: "cannot be written: No space left on device"
     */
    FileError(const std::string &path, const std::string &what)
      : std::runtime_error(path + ": " + what)
      , path(path)
      , problem(what)
    {}

    std::string path;
    std::string problem;
    /// Is there something with which --resume can go on?
    bool can_be_resumed = true;
  };
} // namespace Waker

#endif
