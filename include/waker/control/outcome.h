// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_control_outcome_h
#define waker_control_outcome_h

#include <waker/measures/failure_record.h>

#include <string>
#include <vector>

namespace Waker
{
  /// How a dyke ended. The numbers are those of the store: new ones come last.
  enum class Outcome
  {
    stable,          // at rest, under loads that are constant
    initial_failure, // it has slid, and the water is kept out so far
    flooding,
    numerical_failure,
    // It has not failed, but nobody knows whether it would have:
    still_moving,
    loads_change,
    stopped_by_box
  };

  constexpr unsigned int n_outcomes = 7;

  /// "stable", "initial failure", "flooding", "numerical failure", "still
  /// moving", "loads still change", "stopped by the box".
  std::string
  to_string(const Outcome outcome);

  /// The outcome of that name. @return false if there is none
  bool
  outcome_from_string(const std::string &name, Outcome &outcome);

  /// Every outcome, in the order of its number in the store.
  std::vector<Outcome>
  all_outcomes();

  /// Does it say whether the dyke failed?
  inline bool
  is_decided(const Outcome outcome)
  {
    return outcome == Outcome::stable || outcome == Outcome::initial_failure ||
           outcome == Outcome::flooding;
  }

  /// What keeps the state in which a run ended from being final.
  struct Unrest
  {
    /// The dyke has not been at rest for the rest duration.
    bool moving = false;
    /// Loads changed within the rest duration before the end, or will.
    bool loads_change = false;
    /// Soil has come to a side of the box, which holds it.
    bool at_box = false;

    bool
    is_final() const
    {
      return !moving && !loads_change && !at_box;
    }
  };

  /// "" if the state is final; else why it is not, in words.
  std::string
  to_string(const Unrest &unrest);

  /// The outcome of a run that has ended without numerical failure. A failed
  /// dyke has failed whatever else happens to it.
  Outcome
  outcome_of(const FailureRecord &failure, const Unrest &unrest);
} // namespace Waker

#endif
