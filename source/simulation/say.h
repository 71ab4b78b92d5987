// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_say_h
#define waker_source_simulation_say_h

#include <waker/base/log.h>

#include <cstdio>

namespace Waker
{
  /// A line of the log, of a format of printf.
  template <typename... Arguments>
  void
  say(Log &log, const char *format, const Arguments... arguments)
  {
    char text[512];
    // The unused last argument keeps a format without arguments legal.
    std::snprintf(text, sizeof text, format, arguments..., 0);
    log.line(text);
  }
} // namespace Waker

#endif
