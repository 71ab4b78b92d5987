// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_parameter_differences_h
#define waker_output_parameter_differences_h

#include <string>

namespace Waker
{
  /**
   * For people: in what two texts of parameters.prm differ, the first few of
   * them, "Water/Level (4.75 there, 4.5 here)"; the contents of input files, of
   * which the texts hold the hash, among them. Section "Output" is left out.
   * Empty if they do not differ.
   */
  std::string
  parameter_differences(const std::string &there, const std::string &here);
} // namespace Waker

#endif
