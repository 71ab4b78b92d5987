// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_program_parameter_printer_h
#define waker_program_parameter_printer_h

#include <iosfwd>
#include <string>

namespace Waker
{
  enum class ParameterFormat
  {
    prm, // a file to start from
    json,
    xml,
    markdown // doc/parameters.md
  };

  constexpr const char *
  name_of(const ParameterFormat choice)
  {
    switch (choice)
      {
        case ParameterFormat::prm:
          return "prm";
        case ParameterFormat::json:
          return "json";
        case ParameterFormat::xml:
          return "xml";
        case ParameterFormat::markdown:
          return "markdown";
      }
    return nullptr;
  }


  /**
   * Print every parameter with its default, range and text. Materials, layers
   * and boundary conditions appear once, with the name "<name>".
   */
  void
  print_parameters(std::ostream &output, const ParameterFormat format);
} // namespace Waker

#endif
