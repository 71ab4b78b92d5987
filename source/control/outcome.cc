// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/control/outcome.h>

#include <array>

namespace Waker
{
  std::string
  to_string(const Outcome outcome)
  {
    static const std::array<const char *, n_outcomes> names = {
      {"stable",
       "initial failure",
       "flooding",
       "numerical failure",
       "still moving",
       "loads still change",
       "stopped by the box"}};
    return names.at(static_cast<std::size_t>(outcome));
  }


  std::vector<Outcome>
  all_outcomes()
  {
    std::vector<Outcome> outcomes;
    for (unsigned int i = 0; i < n_outcomes; ++i)
      outcomes.push_back(static_cast<Outcome>(i));
    return outcomes;
  }


  bool
  outcome_from_string(const std::string &name, Outcome &outcome)
  {
    for (const Outcome candidate : all_outcomes())
      if (name == to_string(candidate))
        {
          outcome = candidate;
          return true;
        }
    return false;
  }


  std::string
  to_string(const Unrest &unrest)
  {
    std::string text;
    const auto  add = [&](const bool holds, const char *const words) {
      if (holds)
        text += (text.empty() ? "" : ", ") + std::string(words);
    };
    add(unrest.moving, "still moving");
    add(unrest.loads_change, "loads still change");
    add(unrest.at_box, "soil lies against a side of the box");
    return text;
  }


  Outcome
  outcome_of(const FailureRecord &failure, const Unrest &unrest)
  {
    return failure.flooded()     ? Outcome::flooding
           : failure.failed()    ? Outcome::initial_failure
           : unrest.loads_change ? Outcome::loads_change
           : unrest.moving       ? Outcome::still_moving
           : unrest.at_box       ? Outcome::stopped_by_box
                                 : Outcome::stable;
  }
} // namespace Waker
