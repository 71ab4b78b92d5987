// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_last_change_h
#define waker_base_last_change_h

#include <functional>
#include <limits>

namespace Waker
{
  /// The last time (s) at which a value changes, where it is no number. The
  /// later of two is their maximum.
  namespace LastChange
  {
    constexpr double never = -std::numeric_limits<double>::infinity();
    /// It may change at any time: an expression of t.
    constexpr double unknown = std::numeric_limits<double>::infinity();
  } // namespace LastChange

  /**
   * Does a function of the time change between two times (s) by more than 1e-6
   * of its largest value there? Looked at in 1001 moments: no proof, but all
   * that can be asked of an expression. What is not finite changes.
   */
  bool
  varies(const std::function<double(const double)> &f,
         const double                               from,
         const double                               to);
} // namespace Waker

#endif
