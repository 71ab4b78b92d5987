// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/statistics/estimates.h>
#include <waker/statistics/yearly.h>

#include <cstdint>
#include <cstdio>

namespace Waker
{
  namespace
  {
    std::string
    counted(const FragilityPoint &point, const Proportion &p)
    {
      char text[100];
      std::snprintf(text,
                    sizeof text,
                    "%llu of %llu at %.4g m",
                    static_cast<unsigned long long>(p.count),
                    static_cast<unsigned long long>(p.n),
                    point.water_level);
      return text;
    }


    /// The fall that is hardest to explain by chance: the pair of levels, the
    /// lower one first, with the largest gap (negative: overlap) between the
    /// intervals of falling estimates.
    struct Fall
    {
      const FragilityPoint *lower  = nullptr;
      const FragilityPoint *higher = nullptr;
      double                gap    = 0.;
    };


    Fall
    largest_fall(const std::vector<FragilityPoint> &points,
                 Proportion FragilityPoint::*const which)
    {
      Fall fall;
      for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j)
          {
            const Proportion &a = points[i].*which, &b = points[j].*which;
            const double      gap = a.low - b.high;
            if (a.estimate > b.estimate &&
                (fall.lower == nullptr || gap > fall.gap))
              fall = {&points[i], &points[j], gap};
          }
      return fall;
    }
  } // namespace


  std::optional<Yearly>
  yearly(const bool                              sweeps_water_level,
         const std::vector<FragilityPoint>      &points,
         const std::optional<LevelDistribution> &distribution,
         const RiskParameters                   &parameters,
         std::vector<std::string>               &notes)
  {
    if (!distribution)
      return {};
    // One level says nothing about the others.
    if (!sweeps_water_level || points.size() < 2)
      {
        notes.push_back("No yearly probability, budget or risk: this takes "
                        "a sweep of Water/Level with realisations at two "
                        "levels or more.");
        return {};
      }
    const double lowest  = points.front().water_level;
    const double highest = points.back().water_level;
    const double crest   = highest + points.back().freeboard;

    Yearly             result;
    const BoundedCurve flooding = flooding_curve(points);
    result.initial =
      yearly_probability(initial_failure_curve(points), *distribution);
    result.flooding          = yearly_probability(flooding, *distribution);
    result.below_the_lowest  = 1. - distribution->exceedance(lowest);
    result.above_the_highest = distribution->exceedance(highest);
    result.above_the_crest   = distribution->exceedance(crest);
    result.share_from_above  = result.above_the_highest *
                              flooding.estimate.values.back() /
                              result.flooding.estimate;
    result.risk = assess_risk(result.flooding, parameters);

    std::uint64_t n_lost = 0, n_not_final = 0, n_all = 0;
    for (const FragilityPoint &point : points)
      {
        n_lost += point.n_lost;
        n_not_final += point.n_not_final;
        n_all += point.flooding.n + point.n_lost;
      }
    result.undecided = undecided_text(n_lost, n_not_final, n_all);

    notes.push_back(
      "Below the lowest and above the highest swept water level "
      "probabilities are taken as constant; overflow of an intact dyke is "
      "not counted.");
    const std::vector<double> &table = distribution->table_levels();
    if (!table.empty() && (table.front() > lowest || table.back() < highest))
      notes.push_back("The level table does not reach over all swept water "
                      "levels and was extrapolated.");
    return result;
  }


  namespace
  {
    /// ": 3 still moving, 12 loads still change (...)": of those that are not
    /// decided.
    std::string
    why_undecided(const std::vector<std::vector<Record>> &records_by_scenario)
    {
      std::string text;
      for (const Outcome outcome : all_outcomes())
        {
          std::uint64_t n = 0;
          for (const std::vector<Record> &records : records_by_scenario)
            for (const Record &record : records)
              n += record.outcome == outcome ? 1 : 0;
          if (n == 0 || is_decided(outcome))
            continue;
          text += (text.empty() ? ": " : ", ") + std::to_string(n) + " " +
                  to_string(outcome);
          if (outcome == Outcome::loads_change)
            text += " (a later Time stepping/End time decides; with Delay it "
                    "is 7 delays after the last change of the water outside)";
        }
      return text;
    }
  } // namespace


  std::vector<std::string>
  undecided_notes(const CampaignInfo                     &info,
                  const std::vector<std::vector<Record>> &records_by_scenario)
  {
    std::uint64_t n_lost = 0, n_not_final = 0, n_all = 0;
    std::string   where;
    for (std::size_t s = 0; s < records_by_scenario.size(); ++s)
      {
        const ScenarioEstimate e   = estimate(records_by_scenario[s]);
        const std::uint64_t    all = e.n + e.n_lost();
        const std::string text = undecided_text(e.n_lost(), e.n_not_final, all);
        n_lost += e.n_lost();
        n_not_final += e.n_not_final;
        n_all += all;
        if (!text.empty() && !info.swept_parameter.empty())
          where += (where.empty() ? " = " : "; ") + info.scenarios[s].value +
                   ": " + text;
      }
    const std::string all = undecided_text(n_lost, n_not_final, n_all);
    if (all.empty())
      return {};
    return {all + why_undecided(records_by_scenario) +
            (where.empty() ? "" : " (" + info.swept_parameter + where + ")") +
            ". Undecided are in no estimate. Bounds of the fragility curves, "
            "of P per year, of risks and budgets hold whatever these would "
            "have done: upper ones as if all had failed and flooded, lower "
            "ones as if nothing more had happened."};
  }


  std::vector<std::string>
  fragility_notes(const std::vector<FragilityPoint> &points)
  {
    std::vector<std::string> notes;
    if (points.size() < 2)
      return notes;
    const Fall flooding = largest_fall(points, &FragilityPoint::flooding);
    if (flooding.lower != nullptr)
      notes.push_back(
        "P(F|h) falls with rising water, " +
        counted(*flooding.lower, flooding.lower->flooding) + " and " +
        counted(*flooding.higher, flooding.higher->flooding) +
        (flooding.gap > 0.
           ? ": more than chance explains. Higher water is not safer: is this "
             "one dyke, and does it settle before the end time?"
           : ", as chance may have it. The columns P_F_monotone are the nearest "
             "curve that rises."));
    const Fall initial = largest_fall(points, &FragilityPoint::initial);
    if (initial.lower != nullptr)
      notes.push_back(
        "P(S1|h) falls with rising water, " +
        counted(*initial.lower, initial.lower->initial) + " and " +
        counted(*initial.higher, initial.higher->initial) +
        (initial.gap > 0. ? ", more than chance explains"
                          : ", as chance may have it") +
        ": the water holds the outer slope. It is not made monotone.");

    std::string bounds;
    for (const FragilityPoint &point : points)
      if (kind_of(point.flooding.estimate) != EstimateKind::estimate)
        bounds += (bounds.empty() ? "" : "; ") + counted(point, point.flooding);
    if (!bounds.empty())
      notes.push_back("Flooded: " + bounds +
                      ". There P(F|h) has a bound but no finite reliability "
                      "index.");
    return notes;
  }
} // namespace Waker
