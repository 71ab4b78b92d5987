// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_store_journal_header_h
#define waker_store_journal_header_h

#include <waker/store/machine.h>

#include <string>

namespace Waker
{
  /// The first line of a journal: whose it is, and which machine writes it.
  struct JournalHeader
  {
    bool         damaged        = false; // the rest is not known
    bool         has_checksums  = false; // each line of the journal has one
    unsigned int schema_version = 0;
    std::string  campaign; // CampaignInfo::hash
    MachineUse   use;
  };

  /// The line, without its end, of a journal that this process writes.
  std::string
  journal_header_line(const std::string &campaign_hash);

  JournalHeader
  read_journal_header(const std::string &line);
} // namespace Waker

#endif
