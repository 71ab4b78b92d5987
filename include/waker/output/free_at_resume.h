// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_free_at_resume_h
#define waker_output_free_at_resume_h

#include <string>
#include <vector>

namespace Waker
{
  /// The sections that decide nothing of a campaign's records, whole: of what
  /// comes after them, and of what only other commands do.
  const std::vector<std::string> &
  sections_free_in_campaigns();

  /// The sections of which a run may be resumed with other values, whole; of
  /// the others only Time stepping/End time. The manual lists them, too.
  const std::vector<std::string> &
  sections_free_at_resume();

  /// May a run be resumed with another value of this parameter?
  bool
  is_free_at_resume(const std::string &section, const std::string &name);
} // namespace Waker

#endif
