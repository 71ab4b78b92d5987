// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/output/files.h>
#include <waker/output/output_folder.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <unistd.h>
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


    bool
    ends_with(const std::string &text, const std::string &end)
    {
      return text.size() >= end.size() &&
             text.compare(text.size() - end.size(), end.size(), end) == 0;
    }



    /// "log.txt" of "log.txt.tmp" and "log.txt.2.tmp", which killed processes
    /// leave.
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



    void
    make_folder(const fs::path &folder)
    {
      std::error_code error;
      fs::create_directories(folder, error);
      if (error)
        refuse("cannot make the folder '" + folder.string() +
                 "': " + error.message(),
               "a folder that can be made");
    }
  } // namespace


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


  void
  remove_files(const std::string                              &folder,
               const std::function<bool(const std::string &)> &is_ours,
               const bool                                      temporary_only)
  {
    std::error_code error;
    if (!fs::is_directory(folder, error))
      return;
    std::vector<fs::path> found;
    for (const auto &entry : fs::directory_iterator(folder))
      {
        const std::string name = entry.path().filename().string();
        if (entry.is_regular_file() && is_ours(without_temporary_end(name)) &&
            (!temporary_only || ends_with(name, ".tmp")))
          found.push_back(entry.path());
      }
    for (const fs::path &path : found)
      if (!fs::remove(path, error) && error)
        refuse("cannot remove '" + path.string() + "': " + error.message(),
               "a folder whose files may be removed");
  }


  namespace
  {
    bool
    is_file_of_run(const std::string &name)
    {
      for (const char *const ours : {"parameters.prm",
                                     "log.txt",
                                     "statistics",
                                     "summary.json",
                                     "particles.pvd",
                                     "surface.pvd",
                                     "tractions.pvd",
                                     "grid.pvd",
                                     "strength_reduction.csv",
                                     "strength_reduction.json"})
        if (name == ours)
          return true;
      return false;
    }


    bool
    is_file_of_solution(const std::string &name)
    {
      return is_numbered(name, "particles-", ".vtu") ||
             is_numbered(name, "surface-", ".vtu") ||
             is_numbered(name, "tractions-", ".vtu") ||
             is_numbered(name, "grid-", ".vtu");
    }


    bool
    is_checkpoint(const std::string &name)
    {
      return is_numbered(name, "checkpoint-", ".bin");
    }


    void
    remove_run(const fs::path &folder)
    {
      remove_files(folder.string(), is_file_of_run);
      remove_files((folder / "solution").string(), is_file_of_solution);
      remove_files((folder / "checkpoints").string(), is_checkpoint);

      // These fail, as they should, where something of the user's is left.
      std::error_code ignored;
      fs::remove(folder / "solution", ignored);
      fs::remove(folder / "checkpoints", ignored);
    }


    /// What a killed process was writing.
    void
    remove_leftovers(const fs::path &folder)
    {
      const auto remove = [](const fs::path &where,
                             bool            is_ours(const std::string &)) {
        remove_files(where.string(), is_ours, /* temporary_only = */ true);
      };
      remove(folder, is_file_of_run);
      remove(folder / "solution", is_file_of_solution);
      remove(folder / "checkpoints", is_checkpoint);
    }
  } // namespace


  void
  remove_run_folder(const std::string &folder)
  {
    remove_run(folder);
    std::error_code ignored;
    fs::remove(folder, ignored); // fails, as it should, if not empty
  }


  void
  refuse_campaign_folder(const std::string &directory)
  {
    std::error_code error;
    if (fs::exists(fs::path(directory) / "campaign.json", error))
      refuse("'" + directory + "' holds a campaign",
             "another folder for a single run, --set Output/Directory=...");
  }


  void
  check_output_folder(const std::string &directory, const FolderMode mode)
  {
    if (directory.empty())
      refuse("is empty", "the path of a folder");

    std::error_code error;
    const fs::path  folder(directory);
    if (!fs::exists(folder, error))
      {
        if (mode == FolderMode::resume)
          refuse("'" + directory + "' does not exist",
                 "the folder of the run to be resumed");
        // The nearest folder above that exists is where we would make it.
        fs::path parent = fs::absolute(folder, error).lexically_normal();
        while (parent.has_relative_path() && !fs::exists(parent, error))
          parent = parent.parent_path();
        if (!fs::is_directory(parent, error))
          refuse("cannot make '" + directory + "': '" + parent.string() +
                   "' is not a folder",
                 "a folder that can be made");
        if (::access(parent.c_str(), W_OK | X_OK) != 0)
          refuse("cannot make '" + directory + "' in '" + parent.string() +
                   "': " + std::strerror(errno),
                 "a folder that can be made");
        return;
      }

    if (!fs::is_directory(folder, error))
      refuse("'" + directory + "' is a file", "a folder, or a new name");
    if (::access(folder.c_str(), R_OK | W_OK | X_OK) != 0)
      refuse("'" + directory +
               "' cannot be written to: " + std::strerror(errno),
             "a writable folder");
    if (mode == FolderMode::must_be_new && !fs::is_empty(folder, error))
      refuse("'" + directory + "' is not empty",
             "an empty or new folder; or --overwrite, or --resume");
  }


  void
  prepare_output_folder(const std::string &directory,
                        const FolderMode   mode,
                        const std::string &parameters)
  {
    check_output_folder(directory, mode);
    const fs::path folder(directory);
    make_folder(folder);
    if (mode == FolderMode::overwrite)
      remove_run(folder);
    else if (mode == FolderMode::resume)
      remove_leftovers(folder);
    make_folder(folder / "solution");
    write_file(join_path(directory, "parameters.prm"), parameters);
  }
} // namespace Waker
