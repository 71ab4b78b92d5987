// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_case_stiffness_checks_h
#define waker_source_case_stiffness_checks_h

#include <waker/case/parameters.h>

namespace Waker
{
  /// What cannot be with a law whose stiffness depends on the pressure.
  /// @throws UserError
  void
  check_stiffness(const Parameters &parameters);
} // namespace Waker

#endif
