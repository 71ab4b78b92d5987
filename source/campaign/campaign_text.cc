// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/campaign/campaign_text.h>
#include <waker/statistics/intervals.h>
#include <waker/store/campaign_info.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace Waker
{
  std::string
  work_time_text(const double seconds)
  {
    char text[40];
    if (seconds < 100.)
      std::snprintf(text, sizeof text, "%.1f s", seconds);
    else if (seconds < 6000.)
      std::snprintf(text, sizeof text, "%.1f min", seconds / 60.);
    else
      std::snprintf(text, sizeof text, "%.1f h", seconds / 3600.);
    return text;
  }


  std::string
  campaign_text(const CampaignInfo &info,
                const int           n_ranks,
                const unsigned int  ranks_per_realisation)
  {
    std::string text =
      "Campaign " + info.hash + ": " + std::to_string(info.scenarios.size()) +
      " scenario(s) of up to " + std::to_string(info.realisations) +
      " realisations, seed " + std::to_string(info.seed) + ", " +
      std::to_string(n_ranks) + " rank(s)";
    if (ranks_per_realisation > 1)
      text +=
        ", " + std::to_string(ranks_per_realisation) + " for each realisation";
    if (!info.swept_parameter.empty())
      for (const ScenarioInfo &scenario : info.scenarios)
        text += "\n  " + info.swept_parameter + " = " + scenario.value;
    return text;
  }


  std::string
  progress_text(const Progress &progress, const CampaignInfo &info)
  {
    const unsigned int n_scenarios = info.scenarios.size();
    Counts             sum;
    for (unsigned int s = 0; s < n_scenarios; ++s)
      {
        const Counts &counts = progress.counts(s);
        sum.n += counts.n;
        sum.n_failures += counts.n_failures;
        sum.n_undecided += counts.n_undecided;
        sum.n_initial += counts.n_initial;
        sum.n_flooding += counts.n_flooding;
      }
    std::string text = std::to_string(sum.n) + " of at most " +
                       std::to_string(progress.n_wanted()) + ", S1 " +
                       std::to_string(sum.n_initial);
    const bool may_flood =
      std::any_of(info.scenarios.begin(),
                  info.scenarios.end(),
                  [](const ScenarioInfo &s) { return s.may_flood(); });
    if (may_flood)
      text += ", flooded " + std::to_string(sum.n_flooding);
    if (sum.n_failures > 0)
      text += ", numerical failures " + std::to_string(sum.n_failures);
    if (sum.n_undecided > 0)
      text += ", undecided " + std::to_string(sum.n_undecided);
    if (n_scenarios == 1 && sum.n_decided() > 0)
      {
        const char *const event = may_flood ? "P(F)" : "P(S1)";
        const Proportion  p =
          proportion(may_flood ? sum.n_flooding : sum.n_initial,
                     sum.n_decided());
        char numbers[80];
        if (p.count == 0)
          std::snprintf(numbers, sizeof numbers, ", %s <= %.3g", event, p.high);
        else
          std::snprintf(numbers,
                        sizeof numbers,
                        ", %s = %.3g [%.3g, %.3g]",
                        event,
                        p.estimate,
                        p.low,
                        p.high);
        text += numbers;
      }
    return text;
  }


  std::string
  running_text(const std::uint64_t realisation, const double time)
  {
    char text[80];
    std::snprintf(text,
                  sizeof text,
                  "; no. %llu at t = %.3g s",
                  static_cast<unsigned long long>(realisation),
                  time);
    return text;
  }


  std::string
  running_text(const RunningRealisation &running)
  {
    char text[200];
    std::snprintf(
      text,
      sizeof text,
      "realisation %llu of scenario %u: %s at t = %.3g s (%s ago), ",
      static_cast<unsigned long long>(running.realisation),
      running.scenario,
      running.is_alive ? "under way," : "left",
      running.time,
      work_time_text(running.age).c_str());
    std::string result = text;
    if (running.kept_time < 0.)
      return result + "no checkpoint";
    std::snprintf(text,
                  sizeof text,
                  "checkpoint at t = %.3g s",
                  running.kept_time);
    return result + text;
  }


  std::string
  work_text(const Work &work, const int n_ranks)
  {
    char text[200];
    std::snprintf(text,
                  sizeof text,
                  "%llu realisations in %s on %d rank(s)",
                  static_cast<unsigned long long>(work.n),
                  work_time_text(work.wall).c_str(),
                  n_ranks);
    std::string result = text;
    // Nothing done, or in no time: there is no rate.
    const double time = work.wall * n_ranks;
    if (work.n > 0 && time > 0.)
      {
        std::snprintf(text,
                      sizeof text,
                      ": %.0f an hour and core; ranks busy %.1f %%",
                      work.n / time * 3600.,
                      100. * work.busy / time);
        result += text;
        std::snprintf(text,
                      sizeof text,
                      "; random fields %.2g s each",
                      work.fields / work.n);
        result += text;
      }
    return result;
  }


  std::string
  pace_text(const std::uint64_t n_done,
            const std::uint64_t n_wanted,
            const double        busy)
  {
    // Journals may say anything.
    const double mean = busy / n_done;
    if (n_done == 0 || !(mean > 0.) || !std::isfinite(mean) ||
        !std::isfinite(3600. / mean))
      return "";
    char text[80];
    std::snprintf(text,
                  sizeof text,
                  "%.0f realisations an hour and core",
                  3600. / mean);
    std::string result = text;
    if (n_wanted > n_done)
      result += "; at most " + work_time_text((n_wanted - n_done) * mean) +
                " of one core to go";
    return result;
  }
} // namespace Waker
