// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_sizes_h
#define waker_base_sizes_h

#include <cstdint>
#include <string>

namespace Waker
{
  /*
   * Sizes that follow from input. They are computed in double precision, where
   * nothing overflows, and checked before they become integers and before
   * anything of that size is allocated or looped over.
   */

  /**
   * A number of things as an integer.
   *
   * @param path of the parameter that is to blame, "Grid/Cell size"
   * @param count not rounded; may be infinite or not a number
   * @param things their name, "cells along x"
   * @param largest that is allowed, at most 2^53
   * @param advice what would help, appended to what is allowed; may be empty
   * @throws UserError with the number, unless 0 <= count <= largest
   */
  std::uint64_t
  checked_count(const std::string &path,
                const double       count,
                const std::string &things,
                const double       largest,
                const std::string &advice = "");

  /**
   * Memory (bytes) that this process may still take: the least of what the
   * machine has available, what its control groups (containers, batch jobs;
   * versions 1 and 2) leave, and the limit of its address space. Infinite where
   * nothing is known.
   *
   * @param root of the file system, for tests
   */
  double
  available_memory(const std::string &root = "/");

  /**
   * @param path of the parameter that is to blame
   * @param what needs the memory, "is 1e-05 m: 4e+10 cells"
   * @param bytes that it will need
   * @param available bytes
   * @param advice what would help
   * @throws UserError if there are not as many
   */
  void
  require_memory(const std::string &path,
                 const std::string &what,
                 const double       bytes,
                 const std::string &advice,
                 const double       available = available_memory());

  /// "5600", "3e+12".
  std::string
  count_text(const double count);

  /// "31 MB", "4.2 GB".
  std::string
  bytes_text(const double bytes);

  /// A time that is only estimated: "40 s", "3 minutes", "5 hours", "12 days".
  std::string
  rough_duration_text(const double seconds);
} // namespace Waker

#endif
