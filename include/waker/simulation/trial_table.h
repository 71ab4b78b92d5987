// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_trial_table_h
#define waker_simulation_trial_table_h

#include <waker/control/outcome.h>
#include <waker/simulation/factor_search.h>

#include <map>
#include <optional>
#include <string>

namespace Waker
{
  /// The realisation at one factor of a strength reduction.
  struct Trial
  {
    TrialResult result  = TrialResult::undecided;
    double      time    = 0.; // of failure, or of the end, s
    Outcome     outcome = Outcome::numerical_failure; // of the realisation
    std::optional<FailureReading> reading; // that has seen the failure
    Slopes                        slope    = Slopes::none; // none: not known
    unsigned int                  attempts = 1;

    bool
    failed_numerically() const
    {
      return outcome == Outcome::numerical_failure;
    }
  };


  /**
   * The trials made so far, on disk: an interrupted search goes on where it
   * was. A line a trial, with a checksum; a damaged line is dropped, and its
   * trial made again. Tables of earlier versions, whose trials were judged by
   * other readings, are refused.
   */
  class TrialTable
  {
  public:
    /**
     * @param folder the output folder
     * @param key of the case: a table of another one is refused
     * @param resume read what is there; writes nothing
     * @throws UserError "Output/Directory"
     */
    TrialTable(const std::string &folder,
               const std::string &key,
               const bool         resume);

    const Trial *
    find(const double factor) const;

    /// Of a resumed search: lines that were dropped.
    unsigned int
    n_damaged() const
    {
      return n_dropped;
    }

    const std::map<double, Trial> &
    all() const
    {
      return trials;
    }

    /// Add a trial and write the file.
    /// @throws UserError "Output/Directory": the file is then as before
    void
    add(const double factor, const Trial &trial);

    /// Write the file as it stands.
    void
    write() const;

  private:
    void
    read();

    std::string             path;
    std::string             key;
    std::map<double, Trial> trials;
    unsigned int            n_dropped = 0;
  };
} // namespace Waker

#endif
