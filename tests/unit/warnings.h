// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_warnings_h
#define waker_tests_warnings_h

#include <string>
#include <vector>

/// What is said of a case, as one text.
namespace Warnings
{
  /// Each with an end of line.
  inline std::string
  joined(const std::vector<std::string> &warnings)
  {
    std::string all;
    for (const std::string &warning : warnings)
      all += warning + "\n";
    return all;
  }


  inline bool
  has(const std::string &all, const std::string &text)
  {
    return all.find(text) != std::string::npos;
  }
} // namespace Warnings

#endif
