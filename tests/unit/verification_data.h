// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_verification_data_h
#define waker_tests_verification_data_h

#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <set>
#include <string>

/// Numbers for the pages of doc/verification: written only if the environment
/// variable WAKER_VERIFICATION_DATA names a folder.
namespace Verification
{
  /// Is this the first row of the file in this process?
  inline bool
  first_row(const std::string &path)
  {
    static std::set<std::string> begun;
    return begun.insert(path).second;
  }


  /// Append a row of comma-separated values to <folder>/<name>.csv; the first
  /// one of this process makes the file new, with the header.
  template <typename... Values>
  void
  row(const std::string &name,
      const std::string &header,
      const Values &...values)
  {
    const char *const folder = std::getenv("WAKER_VERIFICATION_DATA");
    if (folder == nullptr)
      return;
    const std::string path  = std::string(folder) + "/" + name + ".csv";
    const bool        first = first_row(path);
    std::ofstream     file(path, first ? std::ios::trunc : std::ios::app);
    if (first)
      file << header << '\n';
    file << std::setprecision(10);
    const char *separator = "";
    ((file << separator << values, separator = ","), ...);
    file << '\n';
  }
} // namespace Verification

#endif
