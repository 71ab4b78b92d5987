// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_interrupt_h
#define waker_base_interrupt_h

#include <csignal>

namespace Waker
{
  /// Somebody's wish that work ends at the next moment from which it can go on
  /// later: a number that a signal handler sets.
  class Interrupt
  {
  public:
    /// It never comes.
    Interrupt() = default;

    /// @param signal not 0: it has come. May be null; must outlive this object.
    Interrupt(const volatile std::sig_atomic_t *const signal)
      : signal(signal)
    {}

    bool
    has_come() const
    {
      return signal != nullptr && *signal != 0;
    }

  private:
    const volatile std::sig_atomic_t *signal = nullptr;
  };
} // namespace Waker

#endif
