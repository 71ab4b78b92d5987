// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_text_h
#define waker_base_text_h

#include <string>
#include <vector>

namespace Waker
{
  /// Blanks removed at both ends, and runs of them made one.
  std::string
  tidy(const std::string &text);

  /// The parts of `text` between separators, tidied, those that are empty
  /// among them; none of an empty text.
  std::vector<std::string>
  split(const std::string &text, const char separator);
} // namespace Waker

#endif
