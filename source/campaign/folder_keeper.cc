// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/read_file.h>
#include <waker/campaign/folder_keeper.h>
#include <waker/output/files.h>
#include <waker/store/campaign_files.h>
#include <waker/store/campaign_writer.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <tuple>

namespace Waker
{
  namespace fs = std::filesystem;

  FolderKeeper::FolderKeeper(const std::string                 &folder,
                             const unsigned int                 scenario,
                             const std::uint64_t                realisation,
                             const std::string                 &hash,
                             const double                       interval,
                             const std::function<void(double)> &said)
    : directory(running_folder(folder, scenario, realisation))
    , slots(directory, hash)
    , interval(interval)
    , said(said)
    , start(Clock::now())
    , last_note(start)
    , last_kept(start)
  {}


  std::string
  FolderKeeper::earlier()
  {
    if (interval == 0. || !fs::exists(directory))
      return "";
    try
      {
        std::string warning;
        return slots.read_latest(warning).blob;
      }
    catch (const UserError &)
      {
        // None, damaged, or of another campaign: it begins anew.
        return "";
      }
  }


  double
  FolderKeeper::seconds_since(const Clock::time_point moment) const
  {
    return std::chrono::duration<double>(Clock::now() - moment).count();
  }


  bool
  FolderKeeper::is_due(const double time, const bool last)
  {
    said(time);
    if (interval == 0.)
      return false;
    if (seconds_since(last_note) > note_interval)
      {
        note(time);
        last_note = Clock::now();
      }
    // What a few seconds have computed is computed again as fast as it is read.
    return seconds_since(last_kept) >
           (last ? std::min(interval, note_interval) : interval);
  }


  void
  FolderKeeper::keep(const std::uint64_t step,
                     const double        time,
                     const std::string  &bytes)
  {
    slots.write(step, bytes);
    kept_time = time;
    note(time);
    last_note = last_kept = Clock::now();
  }


  void
  FolderKeeper::note(const double time) const
  {
    const nlohmann::ordered_json line = {{"time", time},
                                         {"kept_time", kept_time}};
    make_folder(directory);
    write_file(join_path(directory, running_note_name), line.dump() + "\n");
  }


  void
  FolderKeeper::remove() const
  {
    if (!fs::exists(directory))
      return;
    remove_files(directory, files_of_running());
    std::error_code ignored; // others may be in it
    fs::remove(directory, ignored);
    fs::remove(fs::path(directory).parent_path(), ignored);
  }


  std::vector<RunningRealisation>
  running_realisations(const std::string &folder)
  {
    std::vector<RunningRealisation> result;
    for (const auto &[scenario, realisation] : running_numbers(folder))
      {
        const std::string path =
          join_path(running_folder(folder, scenario, realisation),
                    running_note_name);
        RunningRealisation running;
        running.scenario    = scenario;
        running.realisation = realisation;
        running.is_alive    = is_claimed(folder, scenario, realisation);
        std::error_code error;
        const auto      written = fs::last_write_time(path, error);
        if (error)
          continue; // finished just now
        running.age = std::chrono::duration<double>(
                        fs::file_time_type::clock::now() - written)
                        .count();
        const auto json =
          nlohmann::json::parse(read_file(path), nullptr, false);
        if (!json.is_object())
          continue; // damaged: it will be written again
        running.time      = json.value("time", 0.);
        running.kept_time = json.value("kept_time", -1.);
        result.push_back(running);
      }
    return result;
  }
} // namespace Waker
