// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_parameter_differences_h
#define waker_output_parameter_differences_h

#include <functional>
#include <string>

namespace Waker
{
  /**
   * For people: in what two texts of parameters.prm differ, the first few of
   * them, "Water/Level (4.75 there, 4.5 here)"; the contents of input files, of
   * which the texts hold the hash, among them. Empty if they do not differ.
   *
   * @param is_free of section and name: may it differ? Then it is left out
   */
  std::string
  parameter_differences(
    const std::string &there,
    const std::string &here,
    const std::function<bool(const std::string &, const std::string &)>
      &is_free);
} // namespace Waker

#endif
