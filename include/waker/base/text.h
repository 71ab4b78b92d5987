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

  /// For a line of a message: blanks tidied, what cannot be printed replaced by
  /// "?", at most about `longest` bytes and three dots.
  std::string
  printable(const std::string &text, const std::size_t longest);

  /// The same in quotation marks, for a value of the user's.
  std::string
  in_quotes(const std::string &text);

  /// What is allowed, for a message: "a", "a or b", "a, b or c".
  std::string
  either(const std::vector<std::string> &alternatives);

  /// "1 number", "3 numbers".
  std::string
  counted(const std::size_t n, const std::string &noun);

  /// Is it UTF-8, without control characters but the tab?
  bool
  is_plain_text(const std::string &text);

  /// Without the mark that some editors and spreadsheets put before a file.
  std::string
  without_byte_order_mark(const std::string &text);
} // namespace Waker

#endif
