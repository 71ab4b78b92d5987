// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_case_head_line_checks_h
#define waker_source_case_head_line_checks_h

#include <waker/case/parameters.h>

namespace Waker
{
  /// Head lines, reference lines and the phreatic line: that they reach over
  /// all soil, do not cross, and follow water that stands there.
  /// @throws UserError "Pore water/...", "Head lines/...", "Reference
  /// lines/..."
  void
  check_lines_of_water(const Parameters &p);

  /// What does not go without a phreatic line.
  /// @throws UserError of its path
  void
  check_without_line(const Parameters &p);

  /// Loads that the soil has not consolidated under.
  /// @throws UserError "Tractions/<name>/...", "Load programmes/..."
  void
  check_quick_loads(const Parameters &p);
} // namespace Waker

#endif
