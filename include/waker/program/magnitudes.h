// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_program_magnitudes_h
#define waker_program_magnitudes_h

#include <waker/program/declared_parameters.h>

#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * The first number in a text that no quantity in m, s, kPa, kN or Mg has:
   * other than 0, and not from 1e-15 to 1e15 in size. Squares and products of
   * such numbers are none that one can compute with. Digits within a word are
   * no number.
   */
  std::optional<std::string>
  odd_magnitude(const std::string &text);

  /// Is there none in lists, tables and expressions? Names, files, and what is
  /// as by default are not looked at.
  /// @throws UserError with the path of the parameter
  void
  check_magnitudes(const std::vector<DeclaredParameter> &parameters);
} // namespace Waker

#endif
