// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/log.h>
#include <waker/campaign/campaign_folder.h>
#include <waker/campaign/free_parameters.h>
#include <waker/output/files.h>
#include <waker/output/folder_lock.h>
#include <waker/output/output_files.h>
#include <waker/output/output_folder.h>
#include <waker/output/parameter_differences.h>
#include <waker/statistics/report.h>
#include <waker/store/campaign_files.h>

#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

namespace Waker
{
  namespace fs = std::filesystem;

  namespace
  {
    [[noreturn]] void
    refuse(const std::string &what, const std::string &allowed)
    {
      throw UserError("Output/Directory", what, allowed);
    }


    const std::string preparation = "waker campaign, which begins";


    std::string
    info_path(const std::string &folder)
    {
      return campaign_path(folder, CampaignFile::info);
    }


    bool
    has_campaign(const std::string &folder)
    {
      std::error_code error;
      return fs::exists(info_path(folder), error);
    }


    /// Is there nothing in the folder but what another part of the campaign,
    /// which is just making it, writes first?
    bool
    is_being_made(const std::string &folder)
    {
      const auto is_first = is_one_of(
        {campaign_info_name, file_name(OutputFile::parameters), lock_name});
      std::error_code        error;
      fs::directory_iterator entry(folder, error);
      for (; !error && entry != fs::directory_iterator();
           entry.increment(error))
        if (!is_first(without_temporary_end(entry->path().filename().string())))
          return has_campaign(folder); // complete by now
      return !error;
    }


    void
    check_same(const std::string &folder, const CampaignInfo &info)
    {
      const CampaignInfo old = CampaignInfo::read(info_path(folder));
      const std::string  differences =
        parameter_differences(old.parameters,
                              info.parameters,
                              is_free_in_campaigns);
      if (old.hash != info.hash)
        refuse("'" + folder + "' holds another campaign (its parameters have " +
                 "the hash " + old.hash + ", these " + info.hash + ")" +
                 (differences.empty() ? "" : ": " + differences),
               "the same parameters and input files, but for " +
                 free_in_campaigns() + "; a new folder; or --overwrite");
      if (info.realisations < old.realisations)
        throw UserError("Campaign/Realisations",
                        "is " + std::to_string(info.realisations) +
                          ", but the campaign in '" + folder + "' has " +
                          std::to_string(old.realisations),
                        std::to_string(old.realisations) + " or more");
    }


    /// The lock that a campaign holds while it makes its folder ready. Others
    /// that do the same are waited for.
    FolderLock
    lock_for_preparation(const std::string &folder)
    {
      const std::string path = join_path(folder, lock_name);
      for (unsigned int attempt = 0;; ++attempt)
        {
          FolderLock lock(path, preparation);
          if (lock.state() == FolderLock::State::held &&
              (lock.holder().what == preparation ||
               lock.holder().host.empty()) &&
              attempt < 600)
            {
              std::this_thread::sleep_for(std::chrono::milliseconds(50));
              continue;
            }
          require_lock(folder, path, lock.state(), lock.holder());
          return lock;
        }
    }
  } // namespace


  void
  check_campaign_folder(const std::string     &folder,
                        const CampaignInfo    &info,
                        const CampaignOptions &options)
  {
    if (options.overwrite)
      refuse_writers(folder);
    if (options.overwrite || has_campaign(folder))
      refuse_other_kinds(folder, files_of_campaign(folder));
    const bool joins = options.resume || options.is_part;
    if (options.validate_only && !joins)
      {
        check_output_folder(folder, FolderMode::only_checked);
        return;
      }
    if (has_campaign(folder) && joins)
      {
        check_output_folder(folder, FolderMode::resume);
        // A damaged one is written anew: the journals know their campaign.
        if (CampaignInfo::is_whole(info_path(folder)) || !options.resume)
          check_same(folder, info);
        return;
      }
    if (options.resume && !options.is_part)
      refuse("'" + folder + "' holds no campaign",
             "the folder of the campaign to be resumed");
    try
      {
        check_output_folder(folder,
                            options.overwrite ? FolderMode::overwrite
                                              : FolderMode::must_be_new);
      }
    catch (const UserError &)
      {
        // All tasks of a job array may begin in the same moment.
        if (!options.is_part || !is_being_made(folder))
          throw;
      }
  }


  namespace
  {
    /// With the lock held. @return a warning, or nothing
    std::string
    write_campaign_files(const std::string     &folder,
                         const CampaignInfo    &info,
                         const CampaignOptions &options)
    {
      check_campaign_folder(folder, info, options);
      remove_dead_writers(folder);
      std::string warning;
      if (options.overwrite)
        remove_files(folder, files_of_campaign(folder));
      else if (has_campaign(folder) &&
               !CampaignInfo::is_whole(info_path(folder)))
        warning = "campaign.json was damaged; it is written anew.";
      else if (has_campaign(folder))
        {
          const CampaignInfo old = CampaignInfo::read(info_path(folder));
          if (old.version != info.version || old.compiler != info.compiler ||
              old.build_flags != info.build_flags)
            warning = "Begun by version " + old.version + ", " + old.compiler +
                      ", " + old.build_flags +
                      ": results may differ in the last digits.";
          if (options.is_part && old.realisations == info.realisations)
            {
              if (old.parameters != info.parameters)
                warning += (warning.empty() ? "" : "\n") +
                           std::string("The parameters of output or analysis "
                                       "differ from those in the folder, which "
                                       "stay.");
              return warning;
            }
        }
      write_file(campaign_path(folder, CampaignFile::parameters),
                 info.parameters);
      info.write(info_path(folder));
      return warning;
    }
  } // namespace


  PreparedFolder
  prepare_campaign_folder(const std::string     &folder,
                          const CampaignInfo    &info,
                          const CampaignOptions &options)
  {
    make_folder(folder);
    const FolderLock lock    = lock_for_preparation(folder);
    std::string      warning = write_campaign_files(folder, info, options);
    // Before the lock goes: from now on --overwrite is refused.
    return {std::make_unique<CampaignWriter>(folder), std::move(warning)};
  }
} // namespace Waker
