// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_end_warnings_h
#define waker_simulation_end_warnings_h

#include <waker/base/log.h>
#include <waker/control/outcome.h>
#include <waker/observers/observer.h>

namespace Waker
{
  /// What only the end of a run shows: a dyke that the mapping keeps moving,
  /// loads that have left with their soil, walls that may have held nothing.
  template <int dim>
  void
  warn_at_end(const StepView<dim> &view, const Outcome outcome, Log &log);
} // namespace Waker

#endif
