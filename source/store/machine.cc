// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/host.h>
#include <waker/output/summary.h>
#include <waker/store/machine.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>
#include <unistd.h>

namespace Waker
{
  namespace
  {
    std::string
    processor_name()
    {
      std::ifstream     file("/proc/cpuinfo");
      std::string       line;
      const std::string title = "model name";
      while (std::getline(file, line))
        if (line.compare(0, title.size(), title) == 0)
          {
            const auto begin = line.find_first_not_of(" \t:", title.size());
            return begin == std::string::npos ? "" : line.substr(begin);
          }
      return "";
    }
  } // namespace



  Machine
  this_machine()
  {
    // All cores, not those that mpirun leaves to this rank.
    const long    n_cores = ::sysconf(_SC_NPROCESSORS_ONLN);
    const Summary program;
    return {host_name(),
            processor_name(),
            n_cores > 0 ? static_cast<unsigned int>(n_cores) : 0,
            program.version,
            program.compiler,
            program.build_flags};
  }



  std::vector<MachineUse>
  join(const std::vector<MachineUse> &uses)
  {
    const auto key = [](const Machine &m) {
      return std::tie(
        m.host, m.processor, m.n_cores, m.version, m.compiler, m.build_flags);
    };
    const auto is_before = [&key](const Machine &a, const Machine &b) {
      return key(a) < key(b);
    };
    std::map<Machine, MachineUse, decltype(is_before)> joined(is_before);
    for (const MachineUse &use : uses)
      if (use.n_realisations > 0)
        {
          const auto [found, is_new] = joined.try_emplace(use.machine, use);
          if (is_new)
            continue;
          MachineUse &sum = found->second;
          sum.n_journals += use.n_journals;
          sum.n_realisations += use.n_realisations;
          sum.wall_time += use.wall_time;
          // As text: "unknown" comes after all dates.
          sum.start = std::min(sum.start, use.start);
        }

    std::vector<MachineUse> result;
    for (const auto &entry : joined)
      result.push_back(entry.second);
    return result;
  }



  std::string
  to_json(const std::vector<MachineUse> &uses)
  {
    using Json = nlohmann::ordered_json;
    Json json  = Json::array();
    for (const MachineUse &use : uses)
      json.push_back({{"host", use.machine.host},
                      {"processor", use.machine.processor},
                      {"cores", use.machine.n_cores},
                      {"version", use.machine.version},
                      {"compiler", use.machine.compiler},
                      {"build_flags", use.machine.build_flags},
                      {"start", use.start},
                      {"journals", use.n_journals},
                      {"realisations", use.n_realisations},
                      {"wall_time", use.wall_time}});
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
} // namespace Waker
