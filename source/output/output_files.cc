// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/output/checkpoint.h>
#include <waker/output/files.h>
#include <waker/output/output_files.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>

namespace Waker
{
  namespace fs = std::filesystem;

  const std::string lock_name          = "lock";
  const std::string campaign_info_name = "campaign.json";

  namespace
  {
    const std::array<std::string, 6> file_names = {{"parameters.prm",
                                                    "log.txt",
                                                    "statistics",
                                                    "summary.json",
                                                    "strength_reduction.csv",
                                                    "strength_reduction.json"}};

    const std::array<std::string, n_field_series> series_names = {
      {"particles",
       "surface",
       "tractions",
       "walls",
       "grid",
       "top_view",
       "ground_lines"}};

    const std::string frames      = "solution";
    const std::string checkpoints = "checkpoints";


    bool
    ends_with(const std::string &text, const std::string &end)
    {
      return text.size() >= end.size() &&
             text.compare(text.size() - end.size(), end.size(), end) == 0;
    }


    std::string
    place(const std::string &folder, const OwnFiles &files)
    {
      return files.subfolder.empty() ? folder
                                     : join_path(folder, files.subfolder);
    }


    bool
    is_link(const std::string &path)
    {
      std::error_code error;
      return fs::is_symlink(fs::symlink_status(path, error));
    }


    /// @throws UserError of a subfolder that is none
    void
    require_folders(const std::string &folder, const OwnFiles &files)
    {
      std::error_code error;
      fs::path        path(folder);
      if (!files.subfolder.empty())
        for (const fs::path &part : fs::path(files.subfolder))
          {
            path /= part;
            if (fs::exists(path, error) && !fs::is_directory(path, error))
              throw UserError("Output/Directory",
                              "'" + path.string() +
                                "' is no folder, in place of one of a run's",
                              "a folder without it: remove it, or take another "
                              "folder");
          }
    }


    /// The first folder on the way into a subfolder that is a link; or nothing.
    std::string
    link_on_the_way(const std::string &folder, const OwnFiles &files)
    {
      fs::path path(folder);
      if (!files.subfolder.empty())
        for (const fs::path &part : fs::path(files.subfolder))
          {
            path /= part;
            if (is_link(path.string()))
              return path.string();
          }
      return "";
    }


    /// Call f(path) for each file in a folder that is ours, or would be. A
    /// folder that is not there, or a link, has none.
    template <typename Function>
    void
    for_each_file(const std::string &folder,
                  const OwnFiles    &files,
                  const Function    &f)
    {
      const std::string where = place(folder, files);
      std::error_code   error;
      if (!link_on_the_way(folder, files).empty())
        return;
      fs::directory_iterator entry(where, error);
      std::vector<fs::path>  found;
      for (; !error && entry != fs::directory_iterator();
           entry.increment(error))
        if (files.is_ours(
              without_temporary_end(entry->path().filename().string())))
          found.push_back(entry->path());
      std::sort(found.begin(), found.end());
      for (const fs::path &path : found)
        f(path);
    }
  } // namespace


  std::string
  without_temporary_end(std::string name)
  {
    if (!ends_with(name, ".tmp"))
      return name;
    name.resize(name.size() - 4);
    const std::size_t dot = name.rfind('.');
    if (dot != std::string::npos && dot + 1 < name.size() &&
        name.find_first_not_of("0123456789", dot + 1) == std::string::npos)
      name.resize(dot);
    return name;
  }


  std::string
  file_name(const OutputFile file)
  {
    return file_names.at(static_cast<std::size_t>(file));
  }


  std::string
  file_path(const std::string &folder, const OutputFile file)
  {
    return join_path(folder, file_name(file));
  }


  std::string
  series_name(const FieldSeries series)
  {
    return series_names.at(static_cast<std::size_t>(series));
  }


  std::string
  frame_name(const FieldSeries series, const std::size_t number)
  {
    char digits[24];
    std::snprintf(digits, sizeof digits, "%05zu", number);
    return frames + "/" + series_name(series) + "-" + digits + ".vtu";
  }


  std::string
  checkpoint_name(const unsigned int slot)
  {
    return checkpoints + "/checkpoint-" + std::to_string(slot) + ".bin";
  }


  bool
  is_numbered(const std::string &name,
              const std::string &start,
              const std::string &end)
  {
    if (name.compare(0, start.size(), start) != 0 || !ends_with(name, end) ||
        name.size() <= start.size() + end.size())
      return false;
    return std::all_of(name.begin() + start.size(),
                       name.end() - end.size(),
                       [](const char c) { return c >= '0' && c <= '9'; });
  }


  std::function<bool(const std::string &)>
  is_one_of(const std::vector<std::string> &names)
  {
    return [names](const std::string &name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
  }


  std::vector<OwnFiles>
  files_of_run()
  {
    std::vector<std::string> top(file_names.begin(), file_names.end());
    for (const std::string &name : series_names)
      top.push_back(name + ".pvd");
    const auto is_frame = [](const std::string &name) {
      return std::any_of(series_names.begin(),
                         series_names.end(),
                         [&](const std::string &series) {
                           return is_numbered(name, series + "-", ".vtu");
                         });
    };
    const auto is_checkpoint = [](const std::string &name) {
      return is_numbered(name, "checkpoint-", ".bin");
    };
    return {{"", is_one_of(top)},
            {frames, is_frame},
            {checkpoints, is_checkpoint}};
  }


  void
  refuse_other_kinds(const std::string           &folder,
                     const std::vector<OwnFiles> &files)
  {
    const auto refuse = [](const std::string &path) {
      throw UserError(
        "Output/Directory",
        "'" + path + "' is a symbolic link, in place of what a run writes",
        "a folder without such links: what they point to is not "
        "ours to change. Remove the link, or take another folder");
    };
    for (const OwnFiles &own : files)
      {
        const std::string link = link_on_the_way(folder, own);
        if (!link.empty())
          refuse(link);
        require_folders(folder, own);
        for_each_file(folder, own, [&](const fs::path &path) {
          if (is_link(path.string()))
            refuse(path.string());
          const std::string kind = kind_of_irregular_file(path.string());
          if (!kind.empty())
            throw_no_regular_file(path.string(), kind);
        });
      }
    const std::string lock = join_path(folder, lock_name);
    const std::string kind = kind_of_irregular_file(lock);
    if (!kind.empty())
      throw_no_regular_file(lock, kind);
  }


  void
  remove_files(const std::string           &folder,
               const std::vector<OwnFiles> &files,
               const bool                   temporary_only)
  {
    std::error_code error;
    for (const OwnFiles &own : files)
      for_each_file(folder, own, [&](const fs::path &path) {
        if (!fs::is_regular_file(fs::symlink_status(path, error)) ||
            (temporary_only && !ends_with(path.string(), ".tmp")))
          return;
        if (!fs::remove(path, error) && error)
          throw UserError("Output/Directory",
                          "cannot remove '" + path.string() +
                            "': " + error.message(),
                          "a folder whose files may be removed");
      });
    if (temporary_only)
      return;
    // From the inside out. This fails, as it should, where something of the
    // user's is left.
    for (auto own = files.rbegin(); own != files.rend(); ++own)
      if (!own->subfolder.empty() && link_on_the_way(folder, *own).empty())
        fs::remove(place(folder, *own), error);
  }
} // namespace Waker
