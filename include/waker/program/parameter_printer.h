// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_program_parameter_printer_h
#define waker_program_parameter_printer_h

#include <iosfwd>
#include <string>

namespace Waker
{
  /**
   * Print every parameter with its default, range and text. Materials, layers
   * and boundary conditions appear once, with the name "<name>".
   *
   * @param format "prm" (a file to start from), "json", "xml", or "markdown"
   *        (the reference of the manual, doc/parameters.md)
   * @throws UserError for another format
   */
  void
  print_parameters(std::ostream &output, const std::string &format);
} // namespace Waker

#endif
