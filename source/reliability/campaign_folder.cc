// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/log.h>
#include <waker/output/files.h>
#include <waker/output/output_folder.h>
#include <waker/reliability/campaign_folder.h>

#include <algorithm>
#include <filesystem>
#include <vector>

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
        refuse("'" + folder + "' holds another campaign (its parameters have " +
                 "the hash " + old.hash + ", these " + info.hash + ")",
               "the same parameters, but for Output, Snapshots, Slides, "
               "Histograms, Risk, and of Campaign the number of realisations "
               "and the rules for stopping; a new folder; or --overwrite");
      if (info.realisations < old.realisations)
        throw UserError("Campaign/Realisations",
                        "is " + std::to_string(info.realisations) +
                          ", but the campaign in '" + folder + "' has " +
                          std::to_string(old.realisations),
                        std::to_string(old.realisations) + " or more");
    }


    /// "log-2-of-10.txt" or "log-from-500.txt"?
    bool
    is_log_of_part(const std::string &name)
    {
      if (is_numbered(name, "log-from-", ".txt"))
        return true;
      const std::string of = "-of-";
      const std::size_t at = name.find(of);
      return at != std::string::npos &&
             is_numbered(name.substr(0, at), "log-", "") &&
             is_numbered(name.substr(at), of, ".txt");
    }


    /// The files that write_report() makes.
    std::vector<std::string>
    report_files()
    {
      return {"realisations.csv",
              "probabilities.csv",
              "probability_time.csv",
              "convergence.csv",
              "histograms.csv",
              "residual_resistance_width.csv",
              "classes.csv",
              "event_tree.csv",
              "fragility.csv",
              "fragility_curve.csv",
              "fragility_beta.csv",
              "report.json"};
    }


    /// The files of a campaign, by name; anything else stays.
    void
    remove_campaign(const std::string &folder)
    {
      const auto is_one_of = [](const std::vector<std::string> &ours) {
        return [ours](const std::string &name) {
          return std::find(ours.begin(), ours.end(), name) != ours.end();
        };
      };
      remove_files(
        folder,
        is_one_of(
          {"campaign.json", "parameters.prm", "log.txt", "results.h5"}));
      remove_files(folder, is_log_of_part);
      remove_files(folder, [](const std::string &name) {
        return is_numbered(name, "journal-", ".jsonl");
      });
      const std::string report = join_path(folder, "report");
      remove_files(report, is_one_of(report_files()));

      // Snapshots are run folders of their own. What is not empty stays.
      const std::string snapshots = join_path(folder, "snapshots");
      std::error_code   ignored;
      if (fs::is_directory(snapshots, ignored))
        for (const auto &entry : fs::directory_iterator(snapshots))
          if (entry.is_directory())
            remove_run_folder(entry.path().string());
      fs::remove(snapshots, ignored);
      fs::remove(report, ignored);
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


  std::string
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

    std::string warning;
    if (options.overwrite)
      remove_campaign(folder);
    else if (has_campaign(folder))
      {
        check_same(folder, info);
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
    write_file(join_path(folder, "parameters.prm"), info.parameters);
    info.write(info_path(folder));
    return warning;
  }
} // namespace Waker
