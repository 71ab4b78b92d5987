// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_store_machine_h
#define waker_store_machine_h

#include <cstdint>
#include <string>
#include <vector>

namespace Waker
{
  /// What computes realisations: it decides about their wall time and, in the
  /// last digits, about their results.
  struct Machine
  {
    // "unknown": of a journal without these
    std::string  host        = "unknown";
    std::string  processor   = "unknown"; // empty where the system hides it
    unsigned int n_cores     = 0;         // on line; 0: unknown
    std::string  version     = "unknown"; // of the program
    std::string  compiler    = "unknown";
    std::string  build_flags = "unknown";
  };

  /// This process.
  Machine
  this_machine();

  /// What a machine has done for a campaign.
  struct MachineUse
  {
    Machine       machine;
    std::string   start = "unknown"; // of the earliest journal, UTC, ISO 8601
    std::uint64_t n_journals     = 0;
    std::uint64_t n_realisations = 0;
    double        wall_time      = 0.; // sum over these realisations, s
  };

  /// Uses of the same machine become one; in order of host, then of what else
  /// tells machines apart. Those without a realisation are left out.
  std::vector<MachineUse>
  join(const std::vector<MachineUse> &uses);

  /// A JSON array of objects.
  std::string
  to_json(const std::vector<MachineUse> &uses);
} // namespace Waker

#endif
