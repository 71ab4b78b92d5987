// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/log.h>
#include <waker/campaign/campaign_folder.h>
#include <waker/campaign/campaign_text.h>
#include <waker/campaign/folder_keeper.h>
#include <waker/campaign/progress.h>
#include <waker/output/files.h>
#include <waker/statistics/report.h>
#include <waker/statistics/results_file.h>
#include <waker/store/campaign_files.h>
#include <waker/store/journal.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    struct FolderContents
    {
      CampaignInfo        info;
      JournalCounts       counts;
      std::vector<Record> records; // wanted
      std::uint64_t       n_surplus = 0;
      std::uint64_t       n_wanted  = 0;

      std::vector<std::vector<Record>>
      by_scenario() const
      {
        std::vector<std::vector<Record>> result(info.scenarios.size());
        for (const Record &record : records)
          result[record.scenario].push_back(record);
        return result;
      }
    };


    FolderContents
    read_folder(const std::string &folder, const Input &input, const bool all)
    {
      FolderContents contents;
      contents.info =
        CampaignInfo::read(campaign_path(folder, CampaignFile::info));
      JournalContents journals = read_journals(folder, contents.info.hash);
      contents.counts          = journals.counts;

      CampaignParameters parameters = input.reliability.campaign;
      parameters.realisations       = contents.info.realisations;
      Progress progress(parameters, contents.info.scenarios.size());
      for (const Record &record : journals.records)
        progress.add(record);
      contents.n_wanted = progress.n_wanted();
      for (Record &record : journals.records)
        if (record.scenario < contents.info.scenarios.size() &&
            (all || record.realisation < progress.end(record.scenario)))
          contents.records.push_back(std::move(record));
        else
          ++contents.n_surplus;
      return contents;
    }


    void
    print_remarks(const FolderContents &contents, Log &log)
    {
      for (const std::string &remark : contents.counts.remarks)
        log.line("  " + remark);
      if (contents.n_surplus > 0)
        log.line("  " + std::to_string(contents.n_surplus) +
                 " realisations beyond the end that a stop rule set are left "
                 "out (merge --all takes them in).");
    }
  } // namespace


  bool
  merge_campaign(const std::string &folder,
                 const Input       &input,
                 const bool         all,
                 Log               &log)
  {
    const FolderContents contents = read_folder(folder, input, all);
    if (contents.records.empty())
      throw UserError(folder,
                      "has no finished realisation",
                      "the folder of a campaign with at least one");
    const ReliabilityParameters &parameters = input.reliability;
    write_store(campaign_path(folder, CampaignFile::store),
                contents.info,
                contents.records,
                parameters.analysis.slides,
                contents.counts,
                contents.n_surplus);
    const std::string report = report_folder(folder);
    make_folder(report);
    const auto records = contents.by_scenario();
    write_report(contents.info,
                 records,
                 parameters.analysis,
                 report,
                 contents.counts.machines);

    log.line("Merged " + std::to_string(contents.records.size()) +
             " realisations from " +
             std::to_string(contents.counts.n_journals) + " journal(s) to " +
             campaign_path(folder, CampaignFile::store) + " and " + report +
             "/");
    print_remarks(contents, log);
    log.line(report_text(contents.info,
                         records,
                         parameters.analysis,
                         read_level_distribution(parameters.analysis.risk)));
    const bool has_result =
      std::any_of(contents.records.begin(),
                  contents.records.end(),
                  [](const Record &record) {
                    return record.outcome != Outcome::numerical_failure;
                  });
    if (!has_result)
      log.warning("no realisation gave a result: all of them failed "
                  "numerically");
    return has_result;
  }


  void
  print_status(const std::string &folder, const Input &input, Log &log)
  {
    const FolderContents contents = read_folder(folder, input, false);
    double               busy     = 0.;
    for (const Record &record : contents.records)
      busy += record.wall_time * record.ranks.value_or(1);
    log.line("Campaign " + contents.info.hash + " in " + folder + ": " +
             std::to_string(contents.records.size()) + " of " +
             std::to_string(contents.n_wanted) + " realisations done");
    const std::string pace =
      pace_text(contents.records.size(), contents.n_wanted, busy);
    if (!pace.empty())
      log.line("  " + pace);
    for (const RunningRealisation &running : running_realisations(folder))
      log.line("  " + running_text(running));
    print_remarks(contents, log);
    const AnalysisParameters &analysis = input.reliability.analysis;
    // A table that is missing here must not keep the rest from the reader.
    std::optional<LevelDistribution> distribution;
    std::string                      missing;
    try
      {
        distribution = read_level_distribution(analysis.risk);
      }
    catch (const UserError &error)
      {
        missing = "Nothing per year: " + error.where + " " + error.problem +
                  " (" + error.allowed + ")";
      }
    log.line(report_text(
      contents.info, contents.by_scenario(), analysis, distribution));
    if (!missing.empty())
      log.line(missing);
  }
} // namespace Waker
