// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_expression_scan_h
#define waker_base_expression_scan_h

#include <set>
#include <string>
#include <vector>

namespace Waker
{
  /// What an expression is made of.
  struct ExpressionScan
  {
    std::set<std::string> names;   // variables, constants and functions in it
    std::string           problem; // empty: none
    std::string           advice;  // what would cure it, may be empty
  };

  /**
   * Read an expression before muParser does, which takes more than a formula:
   * "0,25" is 25 to it (the part after the last comma counts), "t = 3" changes
   * t, and deal.II's rand() gives another number each time.
   *
   * @param variables x, y, ..., t
   */
  ExpressionScan
  scan_expression(const std::string              &text,
                  const std::vector<std::string> &variables);

  /// Functions of an expression: all that give the same value for the same
  /// arguments.
  extern const std::vector<std::string> expression_functions;
} // namespace Waker

#endif
