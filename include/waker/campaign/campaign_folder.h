// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_campaign_folder_h
#define waker_campaign_campaign_folder_h

#include <waker/campaign/campaign.h>
#include <waker/store/campaign_writer.h>

#include <memory>
#include <string>

namespace Waker
{
  class Log;

  /// Would prepare_campaign_folder() work? Writes nothing.
  /// @throws UserError "Output/Directory"
  void
  check_campaign_folder(const std::string     &folder,
                        const CampaignInfo    &info,
                        const CampaignOptions &options);

  struct PreparedFolder
  {
    /// This process computes there, as others can see.
    std::unique_ptr<CampaignWriter> writer;
    /// A line for the log, or nothing: the campaign was begun by another
    /// version, or the part has other parameters of the analysis.
    std::string warning;
  };

  /**
   * Make the folder, or join the campaign in it (resume, parts): its hash must
   * be that of `info`, its number of realisations not larger. Writes
   * campaign.json and parameters.prm; a part leaves those that are there unless
   * it brings more realisations. `overwrite` removes the files of an earlier
   * campaign, by their names, and nothing else; not while others compute there.
   *
   * Several processes may do this at the same time: one after the other.
   */
  PreparedFolder
  prepare_campaign_folder(const std::string     &folder,
                          const CampaignInfo    &info,
                          const CampaignOptions &options);

  /**
   * Merge the journals of a folder: results.h5 and report/. Realisations
   * beyond the number at which a stop rule ended their scenario are left out
   * unless `all`.
   *
   * @param input the first scenario of the campaign's parameters
   * @return has any realisation given a result? If all failed numerically, the
   *   log warns of it
   * @throws UserError if there is nothing to merge, FileError if it cannot be
   * written
   */
  bool
  merge_campaign(const std::string &folder,
                 const Input       &input,
                 const bool         all,
                 Log               &log);

  /// How far a campaign is, for the user; may be called while it runs.
  void
  print_status(const std::string &folder, const Input &input, Log &log);
} // namespace Waker

#endif
