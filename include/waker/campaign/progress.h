// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_progress_h
#define waker_campaign_progress_h

#include <waker/campaign/campaign_parameters.h>
#include <waker/store/record.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace Waker
{
  /// What a record says to the stop rules.
  struct Event
  {
    explicit Event(const Record &record);

    bool numerical_failure;
    bool undecided; // nobody knows whether it would have failed
    bool initial_failure;
    bool flooding;
  };


  struct Counts
  {
    std::uint64_t n           = 0; // finished, all of them
    std::uint64_t n_failures  = 0; // numerical ones
    std::uint64_t n_undecided = 0; // moving, under changing loads, at the box
    std::uint64_t n_initial   = 0; // S1
    std::uint64_t n_flooding  = 0; // F

    /// Those that the probabilities are of.
    std::uint64_t
    n_decided() const
    {
      return n - n_failures - n_undecided;
    }

    void
    add(const Event &event);
  };


  /// Do the rules of `parameters` say that this is enough?
  bool
  enough(const CampaignParameters &parameters, const Counts &counts);


  /**
   * What has been done of a campaign, and where its stop rules end it.
   *
   * The rules are looked at after whole batches of realisations, counted from
   * the first, and only when all before are finished. So the number at which a
   * scenario ends does not depend on who computed what and when; realisations
   * beyond it may exist and are not used.
   */
  class Progress
  {
  public:
    Progress(const CampaignParameters &parameters,
             const unsigned int        n_scenarios);

    void
    add(const Record &record);

    bool
    is_done(const unsigned int scenario, const std::uint64_t realisation) const;

    /// The realisations 0 .. end - 1 of a scenario are wanted: N, or fewer once
    /// a rule has stopped it.
    std::uint64_t
    end(const unsigned int scenario) const
    {
      return scenarios[scenario].end;
    }

    /// Has a rule stopped it before N?
    bool
    stopped(const unsigned int scenario) const
    {
      return scenarios[scenario].stopped;
    }

    /// Of those wanted and done.
    const Counts &
    counts(const unsigned int scenario) const
    {
      return scenarios[scenario].counts;
    }

    /// Wanted, over all scenarios, and how many of these are done.
    std::uint64_t
    n_wanted() const;

    std::uint64_t
    n_done() const;

    bool
    complete() const
    {
      return n_done() == n_wanted();
    }

  private:
    struct Scenario
    {
      std::vector<std::optional<Event>> realisations; // none: not done
      std::uint64_t                     end     = 0;
      bool                              stopped = false;
      Counts counts; // of the realisations below `end`

      std::uint64_t prefix = 0; // all before are done
      Counts        prefix_counts;
    };

    void
    advance_prefix(Scenario &scenario) const;

    CampaignParameters    parameters;
    std::vector<Scenario> scenarios;
  };
} // namespace Waker

#endif
