// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/host.h>
#include <waker/output/files.h>
#include <waker/store/campaign_files.h>
#include <waker/store/campaign_writer.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <unistd.h>

namespace Waker
{
  namespace fs = std::filesystem;

  namespace
  {
    std::vector<std::string>
    names()
    {
      return {campaign_info_name,
              file_name(OutputFile::parameters),
              file_name(OutputFile::log),
              "results.h5"};
    }

    const std::vector<std::string> report_names = {
      "realisations.csv",
      "probabilities.csv",
      "probability_time.csv",
      "convergence.csv",
      "histograms.csv",
      "residual_resistance_width.csv",
      "quantities.csv",
      "classes.csv",
      "event_tree.csv",
      "fragility.csv",
      "fragility_curve.csv",
      "fragility_beta.csv",
      "fragility_export.csv",
      "fragility_export_upper.csv",
      "risk.csv",
      "report.json"};

    const std::string report    = "report";
    const std::string snapshots = "snapshots";
    const std::string running   = "running";


    /// Two numbers between `start`, `middle` and `end`?
    bool
    has_two_numbers(const std::string &name,
                    const std::string &start,
                    const std::string &middle,
                    const std::string &end)
    {
      const std::size_t at = name.find(middle, start.size());
      return at != std::string::npos &&
             is_numbered(name.substr(0, at), start, "") &&
             is_numbered(name.substr(at), middle, end);
    }


    bool
    is_log_of_part(const std::string &name)
    {
      return is_numbered(name, "log-from-", ".txt") ||
             has_two_numbers(name, "log-", "-of-", ".txt");
    }


    /// "0-17", or ".0-17.node7.123", which a killed process has left.
    bool
    is_snapshot(const std::string &name)
    {
      if (name.compare(0, 1, ".") != 0)
        return has_two_numbers(name, "", "-", "");
      const std::size_t dot = name.find('.', 1);
      return dot != std::string::npos &&
             has_two_numbers(name.substr(1, dot - 1), "", "-", "");
    }
  } // namespace


  std::string
  campaign_path(const std::string &folder, const CampaignFile file)
  {
    return join_path(folder, names().at(static_cast<std::size_t>(file)));
  }


  std::string
  chunk_log_name(const std::uint64_t chunk, const std::uint64_t n_chunks)
  {
    return "log-" + std::to_string(chunk) + "-of-" + std::to_string(n_chunks) +
           ".txt";
  }


  std::string
  interval_log_name(const std::uint64_t first)
  {
    return "log-from-" + std::to_string(first) + ".txt";
  }


  std::string
  journal_name(const unsigned int number)
  {
    char digits[16];
    std::snprintf(digits, sizeof digits, "%05u", number);
    return "journal-" + std::string(digits) + ".jsonl";
  }


  std::string
  report_folder(const std::string &folder)
  {
    return join_path(folder, report);
  }


  std::string
  report_path(const std::string &report_folder, const std::string &name)
  {
    if (!is_one_of(report_names)(name))
      throw std::logic_error("'" + name +
                             "' is not in the list of a campaign's files");
    return join_path(report_folder, name);
  }


  std::string
  snapshots_folder(const std::string &folder)
  {
    return join_path(folder, snapshots);
  }


  std::string
  snapshot_name(const unsigned int scenario, const std::uint64_t realisation)
  {
    return std::to_string(scenario) + "-" + std::to_string(realisation);
  }


  std::string
  unfinished_name(const std::string &snapshot)
  {
    return "." + snapshot + "." + host_name() + "." +
           std::to_string(::getpid());
  }


  const std::string running_note_name = "progress.json";


  std::string
  running_folder(const std::string  &folder,
                 const unsigned int  scenario,
                 const std::uint64_t realisation)
  {
    return join_path(join_path(folder, running),
                     snapshot_name(scenario, realisation));
  }


  std::vector<std::pair<unsigned int, std::uint64_t>>
  running_numbers(const std::string &folder)
  {
    std::vector<std::pair<unsigned int, std::uint64_t>> numbers;
    std::error_code                                     error;
    fs::directory_iterator entry(join_path(folder, running), error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error))
      {
        const std::string name = entry->path().filename().string();
        // Numbers of a file name that is not ours may be of any length.
        if (has_two_numbers(name, "", "-", "") && name.size() < 19)
          numbers.emplace_back(std::stoul(name),
                               std::stoull(name.substr(name.find('-') + 1)));
      }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  }


  std::vector<OwnFiles>
  files_of_running()
  {
    const fs::path checkpoint = checkpoint_name(0);
    return {{"", is_one_of({running_note_name})},
            {checkpoint.parent_path().string(), [](const std::string &name) {
               return is_numbered(name, "checkpoint-", ".bin");
             }}};
  }


  std::vector<OwnFiles>
  files_of_campaign(const std::string &folder)
  {
    const auto none = [](const std::string &) { return false; };
    const auto top  = [](const std::string &name) {
      return is_one_of(names())(name) || is_log_of_part(name) ||
             is_numbered(name, "journal-", ".jsonl");
    };
    std::vector<OwnFiles> files = {{"", top},
                                   {report, is_one_of(report_names)},
                                   files_of_writers(),
                                   {snapshots, none}};
    for (const OwnFiles &of_run : files_of_run())
      files.push_back(of_run);
    for (const auto &[scenario, realisation] : running_numbers(folder))
      for (OwnFiles of_running : files_of_running())
        {
          of_running.subfolder =
            join_path(running_folder("", scenario, realisation),
                      of_running.subfolder);
          files.push_back(of_running);
        }
    files.push_back({running, none});

    std::error_code        error;
    fs::directory_iterator entry(snapshots_folder(folder), error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error))
      if (is_snapshot(entry->path().filename().string()))
        for (OwnFiles of_run : files_of_run())
          {
            const std::string place =
              join_path(snapshots, entry->path().filename().string());
            if (of_run.subfolder.empty())
              {
                of_run.subfolder   = place;
                const auto is_ours = of_run.is_ours;
                of_run.is_ours     = [is_ours](const std::string &name) {
                  return is_ours(name) || name == lock_name;
                };
              }
            else
              of_run.subfolder = join_path(place, of_run.subfolder);
            files.push_back(of_run);
          }
    return files;
  }
} // namespace Waker
