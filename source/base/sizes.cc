// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/sizes.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <sys/resource.h>

namespace Waker
{
  namespace
  {
    constexpr double unlimited = std::numeric_limits<double>::infinity();


    /// The number that a file holds; `otherwise` where it holds none ("max").
    double
    number_in(const std::string &path, const double otherwise)
    {
      std::ifstream file(path);
      double        value;
      return file >> value ? value : otherwise;
    }


    /// The number (bytes) behind a name in a file of lines "name: value kB".
    double
    entry(const std::string &path, const std::string &name)
    {
      std::ifstream file(path);
      std::string   word, unit;
      double        value;
      while (file >> word)
        if (word == name && file >> value >> unit)
          return unit == "kB" ? 1024. * value : value;
      return unlimited;
    }


    /// The number behind a name in memory.stat; 0 if there is none.
    double
    statistic(const std::string &path, const std::string &name)
    {
      std::ifstream file(path);
      std::string   word;
      double        value;
      while (file >> word >> value)
        if (word == name)
          return value;
      return 0.;
    }


    /// What a control group and the groups around it leave.
    double
    left_by_groups(const std::string &mount,
                   std::string        group,
                   const std::string &limit,
                   const std::string &usage,
                   const std::string &cache)
    {
      double least = unlimited;
      while (true)
        {
          const std::string folder = mount + group + "/";
          // Pages of files go when they are needed.
          const double left = number_in(folder + limit, unlimited) -
                              number_in(folder + usage, 0.) +
                              statistic(folder + "memory.stat", cache);
          least = std::min(least, std::max(0., left));
          if (group.empty() || group == "/")
            return least;
          group.erase(group.rfind('/'));
        }
    }


    double
    left_by_control_groups(const std::string &root)
    {
      std::ifstream file(root + "proc/self/cgroup");
      std::string   line;
      double        least = unlimited;
      while (std::getline(file, line))
        {
          // "0::/group" (version 2) or "4:memory:/group" (version 1).
          const std::size_t first = line.find(':');
          const std::size_t last  = line.find(':', first + 1);
          if (first == std::string::npos || last == std::string::npos)
            continue;
          const std::string controllers =
            "," + line.substr(first + 1, last - first - 1) + ",";
          const std::string group = line.substr(last + 1);
          if (controllers == ",,")
            least = std::min(least,
                             left_by_groups(root + "sys/fs/cgroup",
                                            group,
                                            "memory.max",
                                            "memory.current",
                                            "file"));
          else if (controllers.find(",memory,") != std::string::npos)
            least = std::min(least,
                             left_by_groups(root + "sys/fs/cgroup/memory",
                                            group,
                                            "memory.limit_in_bytes",
                                            "memory.usage_in_bytes",
                                            "total_cache"));
        }
      return least;
    }


    double
    left_of_address_space(const std::string &root)
    {
      rlimit limit;
      if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return unlimited;
      const double used = entry(root + "proc/self/status", "VmSize:");
      return std::max(0.,
                      double(limit.rlim_cur) -
                        (std::isfinite(used) ? used : 0.));
    }
  } // namespace


  std::string
  count_text(const double count)
  {
    std::ostringstream text;
    text.precision(count < 1e6 ? 6 : 3);
    text << count;
    return text.str();
  }


  std::uint64_t
  checked_count(const std::string &path,
                const double       count,
                const std::string &things,
                const double       largest,
                const std::string &advice)
  {
    // False also for a count that is not a number.
    if (count >= 0. && count <= largest)
      return static_cast<std::uint64_t>(count);
    throw UserError(path,
                    "asks for " + count_text(count) + " " + things,
                    "at most " + count_text(largest) +
                      (advice.empty() ? "" : ": " + advice));
  }


  double
  available_memory(const std::string &root)
  {
    return std::min({entry(root + "proc/meminfo", "MemAvailable:"),
                     left_by_control_groups(root),
                     left_of_address_space(root)});
  }


  void
  require_memory(const std::string &path,
                 const std::string &what,
                 const double       bytes,
                 const std::string &advice,
                 const double       available)
  {
    if (bytes <= available)
      return;
    throw UserError(path,
                    what + ", about " + bytes_text(bytes) + " of memory",
                    "at most the " + bytes_text(available) +
                      " that this program can have here: " + advice);
  }


  std::string
  bytes_text(const double bytes)
  {
    static const char *const units[] = {"B", "kB", "MB", "GB", "TB", "PB"};
    double                   value   = bytes;
    unsigned int             unit    = 0;
    while (value >= 999.5 && unit + 1 < std::size(units))
      {
        value /= 1000.;
        ++unit;
      }
    std::ostringstream text;
    text.precision(value < 10. ? 2 : 3);
    text << value << " " << units[unit];
    return text.str();
  }


  std::string
  rough_duration_text(const double seconds)
  {
    struct Unit
    {
      double      length; // s
      const char *name;
    };
    for (const Unit unit : {Unit{365.25 * 86400., "years"},
                            Unit{86400., "days"},
                            Unit{3600., "hours"},
                            Unit{60., "minutes"}})
      if (seconds >= 2. * unit.length)
        return count_text(std::round(seconds / unit.length)) + " " + unit.name;
    return count_text(std::max(1., std::round(seconds))) + " s";
  }
} // namespace Waker
