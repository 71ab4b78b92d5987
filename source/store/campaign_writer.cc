// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/host.h>
#include <waker/output/files.h>
#include <waker/store/campaign_writer.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <unistd.h>
#include <utility>
#include <vector>

namespace Waker
{
  namespace fs = std::filesystem;

  namespace
  {
    const std::string subfolder    = "writers";
    const std::string lock_end     = ".lock";
    const std::string claim_prefix = "claim-";


    bool
    is_lock_of_writer(const std::string &name)
    {
      return name.size() > lock_end.size() &&
             name.compare(name.size() - lock_end.size(),
                          lock_end.size(),
                          lock_end) == 0;
    }


    std::string
    claim_path(const std::string  &folder,
               const unsigned int  scenario,
               const std::uint64_t realisation)
    {
      return join_path(join_path(folder, subfolder),
                       claim_prefix + std::to_string(scenario) + "-" +
                         std::to_string(realisation));
    }


    /// "claim-0-17"
    bool
    is_claim(const std::string &name)
    {
      const std::size_t minus = name.rfind('-');
      return minus != std::string::npos &&
             is_numbered(name.substr(0, minus), claim_prefix, "") &&
             is_numbered(name.substr(minus), "-", "");
    }


    bool
    is_file_of_writer(const std::string &name)
    {
      return is_lock_of_writer(name) || is_claim(name);
    }


    /// A name that no other process on any host has.
    std::string
    own_path(const std::string &folder)
    {
      std::string name = host_name();
      for (char &c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.')
          c = '-';
      const std::string start =
        join_path(join_path(folder, subfolder),
                  name + "-" + std::to_string(::getpid()));
      std::string path = start + lock_end;
      // Two objects of one process.
      LockHolder holder;
      for (unsigned int number = 2;
           FolderLock::look(path, holder) != FolderLock::State::ours;
           ++number)
        path = start + "-" + std::to_string(number) + lock_end;
      return path;
    }


    /// Paths of the files in "writers/" whose names `is_ours` knows.
    std::vector<std::string>
    files(const std::string &folder, bool is_ours(const std::string &))
    {
      std::vector<std::string> paths;
      std::error_code          error;
      fs::directory_iterator   entry(join_path(folder, subfolder), error);
      for (; !error && entry != fs::directory_iterator();
           entry.increment(error))
        if (is_ours(entry->path().filename().string()))
          paths.push_back(entry->path().string());
      std::sort(paths.begin(), paths.end());
      return paths;
    }


    FolderLock
    make_lock(const std::string &folder)
    {
      const std::string place = join_path(folder, subfolder);
      for (unsigned int attempt = 0;; ++attempt)
        {
          make_folder(place);
          std::optional<FolderLock> lock;
          try
            {
              const std::string path = own_path(folder);
              // Of a process that had our number: its claims are names of it.
              FolderLock::remove_dead(path);
              lock.emplace(path, "waker campaign");
            }
          catch (const UserError &)
            {
              // The last one of others may have removed the folder, and the
              // next one have made it again.
              if (attempt >= 100)
                throw;
              continue;
            }
          require_lock(folder, lock->path(), lock->state(), lock->holder());
          return std::move(*lock);
        }
    }
  } // namespace


  CampaignWriter::CampaignWriter(const std::string &folder)
    : folder(folder)
    , lock(make_lock(folder))
  {}


  CampaignWriter::~CampaignWriter()
  {
    lock = FolderLock();
    std::error_code ignored;
    fs::remove(join_path(folder, subfolder), ignored); // if it is empty
  }


  std::optional<CampaignWriter::Claim>
  CampaignWriter::claim(const unsigned int  scenario,
                        const std::uint64_t realisation) const
  {
    const std::string path = claim_path(folder, scenario, realisation);
    // A second attempt where the claim of a dead process was in the way.
    for (unsigned int attempt = 0; attempt < 2; ++attempt)
      {
        if (::link(lock.path().c_str(), path.c_str()) == 0)
          return Claim(path);
        if (errno != EEXIST)
          return Claim(""); // no links here
        if (!FolderLock::remove_dead(path))
          return {};
      }
    return {};
  }


  CampaignWriter::Claim::Claim(const std::string &path)
    : path(path)
  {}


  CampaignWriter::Claim::~Claim()
  {
    if (!path.empty())
      ::unlink(path.c_str());
  }


  CampaignWriter::Claim::Claim(Claim &&other) noexcept
    : path(std::exchange(other.path, ""))
  {}


  bool
  is_claimed(const std::string  &folder,
             const unsigned int  scenario,
             const std::uint64_t realisation)
  {
    LockHolder holder;
    return FolderLock::look(claim_path(folder, scenario, realisation),
                            holder) == FolderLock::State::held;
  }


  void
  refuse_writers(const std::string &folder)
  {
    for (const std::string &path : files(folder, is_lock_of_writer))
      {
        LockHolder holder;
        const auto state = FolderLock::look(path, holder);
        // Here names decide: what cannot be read is a damaged one of ours.
        if (state != FolderLock::State::foreign)
          require_lock(folder, path, state, holder);
      }
  }


  void
  remove_dead_writers(const std::string &folder)
  {
    for (const std::string &path : files(folder, is_file_of_writer))
      {
        LockHolder holder;
        const auto state = FolderLock::look(path, holder);
        if (state == FolderLock::State::ours ||
            state == FolderLock::State::foreign)
          FolderLock::remove_dead(path);
      }
  }


  OwnFiles
  files_of_writers()
  {
    return {subfolder, is_file_of_writer};
  }
} // namespace Waker
