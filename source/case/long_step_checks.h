// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_case_long_step_checks_h
#define waker_source_case_long_step_checks_h

#include <waker/case/parameters.h>

namespace Waker
{
  /// What cannot be with a scheme that has long steps.
  /// @throws UserError
  void
  check_long_steps(const Parameters &parameters);
} // namespace Waker

#endif
