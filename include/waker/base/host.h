// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_host_h
#define waker_base_host_h

#include <string>

namespace Waker
{
  /// Name of this computer, or "unknown".
  std::string
  host_name();

  /// Now, UTC: "2025-01-31T12:00:00Z".
  std::string
  utc_time();

  /// Give memory that was needed for a moment back to the system. By itself the
  /// C library would keep it for ever, as Open MPI tells it to.
  void
  give_back_memory();
} // namespace Waker

#endif
