// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_store_campaign_writer_h
#define waker_store_campaign_writer_h

#include <waker/output/folder_lock.h>
#include <waker/output/output_files.h>

#include <cstdint>
#include <optional>
#include <string>

namespace Waker
{
  /**
   * A process that computes realisations of the campaign in a folder. Any
   * number may do so at a time, on any number of hosts: each has a lock file of
   * its own in "writers/", and claims a realisation before it begins it, so
   * that no two compute the same. A claim is a second name of the lock file, so
   * that it ends with its process, however that ends.
   *
   * A file system without links has no claims: a realisation may then be
   * computed twice, with the same result, which counts once.
   */
  class CampaignWriter
  {
  public:
    /// @throws UserError "Output/Directory" if the lock file cannot be made
    explicit CampaignWriter(const std::string &folder);
    ~CampaignWriter();
    CampaignWriter(const CampaignWriter &) = delete;
    CampaignWriter &
    operator=(const CampaignWriter &) = delete;

    /// A realisation that is ours until the object is gone.
    class Claim
    {
    public:
      explicit Claim(const std::string &path);
      ~Claim();
      Claim(Claim &&other) noexcept;
      Claim &
      operator=(Claim &&) = delete;

    private:
      std::string path; // empty: nothing to remove
    };

    /// @return nothing if another process that lives has claimed it
    std::optional<Claim>
    claim(const unsigned int scenario, const std::uint64_t realisation) const;

  private:
    std::string folder;
    FolderLock  lock;
  };


  /// Has a process that lives claimed this realisation?
  bool
  is_claimed(const std::string  &folder,
             const unsigned int  scenario,
             const std::uint64_t realisation);

  /// @throws UserError "Output/Directory" if a process computes in the folder,
  /// or may do so on another host
  void
  refuse_writers(const std::string &folder);

  /// Remove what processes of this host have left that are there no more.
  void
  remove_dead_writers(const std::string &folder);

  /// The files of all writers.
  OwnFiles
  files_of_writers();
} // namespace Waker

#endif
