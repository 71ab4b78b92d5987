// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/hash.h>
#include <waker/base/read_file.h>
#include <waker/campaign/folder_keeper.h>
#include <waker/output/files.h>
#include <waker/store/campaign_files.h>
#include <waker/store/campaign_writer.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace Waker
{
  namespace fs = std::filesystem;

  namespace
  {
    /// What is noted of how far a realisation is; null if that is damaged, or
    /// gone, as the realisation has just been finished.
    nlohmann::ordered_json
    read_note(const std::string &directory)
    {
      try
        {
          const auto note = nlohmann::ordered_json::parse(
            read_file(join_path(directory, running_note_name)), nullptr, false);
          return note.is_object() ? note : nlohmann::ordered_json();
        }
      catch (const UserError &)
        {
          return {};
        }
    }


    double
    number(const nlohmann::ordered_json &note, const char *const name)
    {
      const auto found = note.find(name);
      return found != note.end() && found->is_number() ? found->get<double>()
                                                       : -1.;
    }
  } // namespace


  FolderKeeper::FolderKeeper(const std::string                 &folder,
                             const unsigned int                 scenario,
                             const std::uint64_t                realisation,
                             const std::string                 &hash,
                             const double                       interval,
                             const std::function<void(double)> &said)
    : directory(running_folder(folder, scenario, realisation))
    // A folder that was moved or copied is not another realisation's.
    , slots(directory,
            hash_of_text(hash + " " + std::to_string(scenario) + "-" +
                         std::to_string(realisation)))
    , interval(interval)
    , said(said)
    , last_note(Clock::now())
    , last_kept(last_note)
  {}


  std::string
  FolderKeeper::earlier()
  {
    if (interval == 0. || !fs::exists(directory))
      return "";
    try
      {
        std::string warning;
        std::string bytes = slots.read_latest(warning).blob;
        kept_time         = number(read_note(directory), "kept_time");
        return bytes;
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
      note(time);
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
    last_kept = last_note;
  }


  void
  FolderKeeper::note(const double time)
  {
    const nlohmann::ordered_json line = {{"time", time},
                                         {"kept_time", kept_time}};
    make_folder(directory);
    write_file(join_path(directory, running_note_name), line.dump() + "\n");
    last_note = Clock::now();
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
        const auto note =
          read_note(running_folder(folder, scenario, realisation));
        if (note.is_null())
          continue; // it will be written again
        running.time      = number(note, "time");
        running.kept_time = number(note, "kept_time");
        result.push_back(running);
      }
    return result;
  }
} // namespace Waker
