// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/log.h>
#include <waker/output/files.h>
#include <waker/output/output_folder.h>
#include <waker/reliability/campaign_folder.h>

#include <algorithm>
#include <filesystem>

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


    std::string
    info_path(const std::string &folder)
    {
      return join_path(folder, "campaign.json");
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
      std::error_code        error;
      fs::directory_iterator entry(folder, error);
      for (; !error && entry != fs::directory_iterator();
           entry.increment(error))
        {
          const std::string name = entry->path().filename().string();
          if (name.rfind("campaign.json", 0) != 0 &&
              name.rfind("parameters.prm", 0) != 0)
            return has_campaign(folder); // complete by now
        }
      return !error;
    }


    void
    check_same(const std::string &folder, const CampaignInfo &info)
    {
      const CampaignInfo old = CampaignInfo::read(info_path(folder));
      if (old.hash != info.hash)
        refuse(
          "'" + folder +
            "' holds another campaign (its parameters have the "
            "hash " +
            old.hash + ", these " + info.hash + ")",
          "the same parameters, but for Output, Slides, Risk, Snapshots and "
          "the number of realisations; a new folder; or --overwrite");
    }


    /// The files of a campaign, by name; anything else stays.
    void
    remove_campaign(const std::string &folder)
    {
      std::vector<fs::path> found;
      for (const auto &entry : fs::directory_iterator(folder))
        {
          const std::string name   = entry.path().filename().string();
          const auto        begins = [&name](const char *text) {
            return name.rfind(text, 0) == 0;
          };
          if (entry.is_regular_file() &&
              (begins("journal-") || begins("log") || begins("campaign.json") ||
               begins("parameters.prm") || begins("results.h5")))
            found.push_back(entry.path());
        }
      const fs::path  report = fs::path(folder) / "report";
      std::error_code ignored;
      if (fs::is_directory(report, ignored))
        for (const auto &entry : fs::directory_iterator(report))
          if (entry.path().extension() == ".csv" ||
              entry.path().extension() == ".json")
            found.push_back(entry.path());
      for (const fs::path &path : found)
        {
          std::error_code error;
          if (!fs::remove(path, error) && error)
            refuse("cannot remove '" + path.string() + "': " + error.message(),
                   "a folder whose files may be removed");
        }
      fs::remove(report, ignored); // fails, as it should, if not empty

      // Snapshots are run folders of their own.
      const fs::path snapshots = fs::path(folder) / "snapshots";
      if (fs::is_directory(snapshots, ignored))
        {
          for (const auto &entry : fs::directory_iterator(snapshots))
            if (entry.is_directory())
              {
                prepare_output_folder(entry.path().string(),
                                      FolderMode::overwrite,
                                      "");
                fs::remove(entry.path() / "parameters.prm", ignored);
                fs::remove(entry.path() / "solution", ignored);
                fs::remove(entry.path(), ignored);
              }
          fs::remove(snapshots, ignored);
        }
    }
  } // namespace


  void
  check_campaign_folder(const std::string     &folder,
                        const CampaignInfo    &info,
                        const CampaignOptions &options)
  {
    const bool joins = options.resume || options.is_part;
    if (has_campaign(folder) && joins)
      {
        check_output_folder(folder, FolderMode::resume);
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


  void
  prepare_campaign_folder(const std::string     &folder,
                          const CampaignInfo    &info,
                          const CampaignOptions &options)
  {
    check_campaign_folder(folder, info, options);
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
      refuse("cannot make the folder '" + folder + "': " + error.message(),
             "a folder that can be made");
    if (options.overwrite && !options.is_part)
      remove_campaign(folder);
    else if (has_campaign(folder))
      {
        check_same(folder, info);
        // What a longer campaign has done stays wanted.
        if (CampaignInfo::read(info_path(folder)).realisations >=
            info.realisations)
          return;
      }
    write_file(join_path(folder, "parameters.prm"), info.parameters);
    info.write(info_path(folder));
  }
} // namespace Waker
