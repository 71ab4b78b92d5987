// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_numbers_h
#define waker_base_numbers_h

#include <limits>
#include <string>

namespace Waker
{
  /// No number: what has not been measured, or has no value.
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  /// How decimals are written, for errors about numbers: ", decimals with a
  /// point (0.25)".
  extern const char *const decimals_with_a_point;

  /**
   * A finite number, whatever the locale.
   *
   * @return false, and `number` as it was, unless the whole text is one
   */
  bool
  read_number(const std::string &text, double &number);

  /// The fewest digits that give the number again, for messages; "inf" and
  /// "nan", too, of which deal.II's to_string() makes an exception.
  std::string
  in_digits(const double number);

  /**
   * May this line be the titles above a table? Only if nothing between commas,
   * semicolons, blanks and quotation marks begins like a number, in whatever
   * way it is written: a row of the table must not pass for titles.
   */
  bool
  may_be_titles(const std::string &line);
} // namespace Waker

#endif
