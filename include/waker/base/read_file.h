// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_read_file_h
#define waker_base_read_file_h

#include <cstdint>
#include <iosfwd>
#include <limits>
#include <string>

namespace Waker
{
  /// The largest input file (bytes): a file of another kind, taken for one of
  /// ours, should not fill the memory.
  constexpr std::uint64_t largest_input = 256000000;

  /**
   * The whole of a file. Only a regular one, or a link to one: a pipe may never
   * end, can be read once only, and makes who opens it wait.
   *
   * @param largest bytes; it is refused before it is read
   * @throws UserError with its path if it cannot be read or is no such file
   */
  std::string
  read_file(
    const std::string  &path,
    const std::uint64_t largest = std::numeric_limits<std::uint64_t>::max());

  /// A file of the user's: at most `largest_input`. @throws as read_file()
  std::string
  read_input_file(const std::string &path);

  /**
   * A file that a parameter names, without a byte order mark.
   *
   * @param path of the parameter
   * @param holds what the file holds, for the error: "the surface that ..."
   * @throws UserError at `path` if it has no name, cannot be read or is empty
   */
  std::string
  read_named_file(const std::string &file,
                  const std::string &path,
                  const std::string &holds);

  /// Standard input, say, to its end, with the same limit.
  /// @param name of it, for messages
  /// @throws UserError with the name
  std::string
  read_input(std::istream       &stream,
             const std::string  &name,
             const std::uint64_t largest = largest_input);

  /// "a pipe", "a device", ... of what is there and is no regular file; empty
  /// for a regular file, for nothing at all, and for a link to either.
  std::string
  kind_of_irregular_file(const std::string &path);
} // namespace Waker

#endif
