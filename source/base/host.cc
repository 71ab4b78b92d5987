// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/host.h>

#include <ctime>
#include <unistd.h>

#ifdef __GLIBC__
#  include <malloc.h>
#endif

namespace Waker
{
  std::string
  host_name()
  {
    char name[256] = "";
    // A name that is too long may come without its end.
    if (::gethostname(name, sizeof name - 1) != 0 || name[0] == '\0')
      return "unknown";
    return name;
  }


  std::string
  utc_time()
  {
    const std::time_t now   = std::time(nullptr);
    std::tm           parts = {};
    ::gmtime_r(&now, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text;
  }


  void
  give_back_memory()
  {
#ifdef __GLIBC__
    ::malloc_trim(0);
#endif
  }
} // namespace Waker
