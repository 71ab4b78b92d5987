// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_folder_keeper_h
#define waker_campaign_folder_keeper_h

#include <waker/campaign/keeper.h>
#include <waker/output/checkpoint.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * Keeps a realisation in its campaign's folder, in "running/0-17/": a
   * checkpoint in two slots (CheckpointSlots) every so many seconds of
   * computing, and how far it is, in "progress.json", more often.
   */
  class FolderKeeper : public Keeper
  {
  public:
    /// Seconds between two notes of how far it is.
    static constexpr double note_interval = 5.;

    /**
     * @param hash of the campaign
     * @param interval between two checkpoints, s of wall time; 0: none
     * @param said called with the time (s) of every moment
     */
    FolderKeeper(const std::string                 &folder,
                 const unsigned int                 scenario,
                 const std::uint64_t                realisation,
                 const std::string                 &hash,
                 const double                       interval,
                 const std::function<void(double)> &said);

    std::string
    earlier() override;

    bool
    is_due(const double time, const bool last) override;

    void
    keep(const std::uint64_t step,
         const double        time,
         const std::string  &bytes) override;

    /// The realisation is in the journal: what was kept goes.
    void
    remove() const;

  private:
    using Clock = std::chrono::steady_clock;

    double
    seconds_since(const Clock::time_point moment) const;

    void
    note(const double time);

    std::string                 directory;
    CheckpointSlots             slots;
    double                      interval;
    std::function<void(double)> said;
    double                      kept_time = -1.; // of the state kept, s
    Clock::time_point           last_note, last_kept;
  };


  /// A realisation under way, or left by a process that is no more.
  struct RunningRealisation
  {
    unsigned int  scenario    = 0;
    std::uint64_t realisation = 0;
    double        time        = 0.;  // s
    double        kept_time   = -1.; // of its last checkpoint, s; -1: none
    double        age         = 0.;  // s since it was noted
    bool          is_alive    = false;
  };

  /// Those in a campaign's folder, by their numbers.
  std::vector<RunningRealisation>
  running_realisations(const std::string &folder);
} // namespace Waker

#endif
