// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/version.h>
#include <waker/control/outcome.h>
#include <waker/simulation/factor_report.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace Waker
{
  namespace
  {
    nlohmann::ordered_json
    or_null(const std::optional<double> &value)
    {
      return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
    }


    nlohmann::ordered_json
    or_null(const std::string &value)
    {
      return value.empty() ? nlohmann::ordered_json()
                           : nlohmann::ordered_json(value);
    }


    /// "" if none has.
    std::string
    reading_of(const Trial &trial)
    {
      return trial.reading ? name_of(*trial.reading) : "";
    }
  } // namespace


  std::string
  describe_trial(const double factor, const Trial &trial)
  {
    char text[200];
    std::snprintf(text,
                  sizeof text,
                  "factor %.4f: %-9s at t = %.2f s (%s)",
                  factor,
                  to_string(trial.result).c_str(),
                  trial.time,
                  to_string(trial.outcome).c_str());
    const std::string reading = reading_of(trial);
    const std::string slope   = name_of(trial.slope);
    return text + (reading.empty() ? "" : ", by " + reading) +
           (slope.empty() ? "" : ", " + slope + " slope");
  }


  std::string
  search_json(const FactorSearch &search,
              const TrialTable   &table,
              const std::string  &strengths,
              const std::string  &hash)
  {
    nlohmann::ordered_json json;
    json["schema_version"]        = 2;
    json["strengths"]             = strengths;
    json["factor_of_safety"]      = or_null(search.factor());
    json["highest_stable_factor"] = or_null(search.highest_stable());
    json["lowest_failed_factor"]  = or_null(search.lowest_failed());
    json["undecided_factors"]     = search.undecided();
    json["failure"]               = nlohmann::ordered_json();
    if (search.lowest_failed())
      {
        const Trial &trial = *table.find(*search.lowest_failed());
        json["failure"]    = {{"reading", or_null(reading_of(trial))},
                              {"slope", or_null(name_of(trial.slope))},
                              {"time_s", trial.time}};
      }
    unsigned int n_numerical = 0;
    for (const auto &[factor, trial] : table.all())
      n_numerical += trial.failed_numerically();
    json["trials"]             = table.all().size();
    json["numerical_failures"] = n_numerical;
    json["parameters_hash"]    = hash;
    json["version"]            = WAKER_VERSION;
    return json.dump(2) + "\n";
  }


  std::string
  search_conclusion(const FactorSearch &search, const TrialTable &table)
  {
    std::set<std::string> outcomes; // of those that did not decide
    for (const double factor : search.undecided())
      outcomes.insert(to_string(table.find(factor)->outcome));
    std::string why;
    for (const std::string &outcome : outcomes)
      why += (why.empty() ? "" : ", ") + outcome;
    if (outcomes.count(to_string(Outcome::still_moving)) > 0)
      why += ": raise \"Time stepping/End time\"";

    std::ostringstream text;
    if (search.factor())
      text << "Factor of safety: " << *search.factor() << " (stable at "
           << *search.highest_stable() << ", fails at "
           << *search.lowest_failed() << ", " << table.all().size()
           << " trials)";
    else if (search.highest_stable() && search.lowest_failed())
      text << "No factor of safety: stable at " << *search.highest_stable()
           << ", fails at " << *search.lowest_failed()
           << ", and not decided at " << search.undecided().size()
           << " factor(s) between them (" << why << ").";
    else if (!search.undecided().empty())
      text << "No factor of safety: an end of the bracket, "
           << search.undecided().front() << ", is not decided (" << why << ").";
    else if (search.lowest_failed())
      text << "Fails at the lower factor " << *search.lowest_failed()
           << " already: lower \"Strength reduction/Lower factor\".";
    else
      text << "Stable at the upper factor " << *search.highest_stable()
           << " still: raise \"Strength reduction/Upper factor\".";
    // A smaller factor has failed: chance, or trouble with the numbers.
    if (search.lowest_failed())
      for (const auto &[factor, trial] : table.all())
        if (factor > *search.lowest_failed() &&
            trial.result != TrialResult::failed)
          text << " Strange: " << factor << " did not fail ("
               << to_string(trial.outcome) << "), but "
               << *search.lowest_failed() << " did.";
    return text.str();
  }
} // namespace Waker
