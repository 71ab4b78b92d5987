// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_folder_watch_h
#define waker_campaign_folder_watch_h

#include <waker/campaign/progress.h>
#include <waker/store/journal.h>

#include <string>

namespace Waker
{
  /// Where a campaign stands, by the journals in its folder.
  class FolderWatch
  {
  public:
    FolderWatch(const std::string        &folder,
                const std::string        &hash,
                const CampaignParameters &parameters,
                const unsigned int        n_scenarios)
      : progress(parameters, n_scenarios)
      , reader(folder, hash)
    {
      poll();
    }

    void
    poll()
    {
      for (const Record &record : reader.poll())
        progress.add(record);
    }

    std::uint64_t
    n_damaged() const
    {
      return reader.counts().n_damaged;
    }

    Progress progress;

  private:
    JournalReader reader;
  };
} // namespace Waker

#endif
