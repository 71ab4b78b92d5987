// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/output/files.h>
#include <waker/output/folder_lock.h>
#include <waker/output/output_files.h>
#include <waker/output/output_folder.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <unistd.h>

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
  } // namespace


  namespace
  {
    /// Is there nothing in the folder but perhaps its lock?
    bool
    is_unused(const fs::path &folder)
    {
      std::error_code        error;
      fs::directory_iterator entry(folder, error);
      for (; !error && entry != fs::directory_iterator();
           entry.increment(error))
        if (entry->path().filename() != lock_name)
          return false;
      return !error;
    }
  } // namespace


  void
  remove_run_folder(const std::string &folder)
  {
    std::error_code error;
    if (fs::is_symlink(fs::symlink_status(folder, error)))
      return;
    remove_files(folder, files_of_run());
    const std::string lock = join_path(folder, lock_name);
    LockHolder        holder;
    if (FolderLock::look(lock, holder) != FolderLock::State::foreign)
      FolderLock::remove_dead(lock); // of a killed process
    fs::remove(folder, error);       // fails, as it should, if not empty
  }


  void
  refuse_campaign_folder(const std::string &directory)
  {
    std::error_code error;
    if (fs::exists(join_path(directory, campaign_info_name), error))
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
    if (mode == FolderMode::must_be_new && !is_unused(folder))
      refuse("'" + directory + "' is not empty",
             "an empty or new folder; or --overwrite, or --resume");
    if (mode != FolderMode::must_be_new)
      refuse_other_kinds(directory, files_of_run());
  }


  std::string
  valid_text(const std::string &directory)
  {
    std::error_code error;
    const bool      is_empty =
      !fs::exists(directory, error) || fs::is_empty(directory, error);
    return "Valid. Nothing was written." +
           (is_empty
              ? std::string()
              : " '" + directory + "' is not empty: --overwrite or --resume.");
  }


  void
  prepare_output_folder(const std::string &directory,
                        const FolderMode   mode,
                        const std::string &parameters)
  {
    const fs::path folder(directory);
    make_folder(directory);
    if (mode == FolderMode::must_be_new && !is_unused(folder))
      refuse("'" + directory + "' is not empty any more",
             "an empty or new folder; or --overwrite, or --resume");
    if (mode != FolderMode::must_be_new)
      refuse_other_kinds(directory, files_of_run());
    if (mode == FolderMode::overwrite)
      remove_files(directory, files_of_run());
    else if (mode == FolderMode::resume)
      {
        remove_files(directory, files_of_run(), /* temporary_only = */ true);
        // What came out is not known any more until the end.
        for (const OutputFile result :
             {OutputFile::summary, OutputFile::strength_result})
          ::unlink(file_path(directory, result).c_str());
      }
    make_folder(folder /
                fs::path(frame_name(FieldSeries::particles, 0)).parent_path());
    write_file(file_path(directory, OutputFile::parameters), parameters);
  }
} // namespace Waker
