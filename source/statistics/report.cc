// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/log.h>
#include <waker/output/files.h>
#include <waker/statistics/estimates.h>
#include <waker/statistics/histograms.h>
#include <waker/statistics/quantities.h>
#include <waker/statistics/report.h>
#include <waker/statistics/report_tables.h>
#include <waker/store/campaign_files.h>

#include <cmath>
#include <cstdio>

namespace Waker
{
  namespace
  {
    std::string
    number(const double value)
    {
      char text[40];
      std::snprintf(text, sizeof text, "%.4g", value);
      return text;
    }


    /// "0.12 [0.1, 0.14]", or of a bound "at most 0.01".
    template <typename Bounded>
    std::string
    bounded_text(const Bounded &p, const EstimateKind kind)
    {
      switch (kind)
        {
          case EstimateKind::unknown:
            return "-";
          case EstimateKind::upper_bound:
            return "at most " + number(p.high);
          case EstimateKind::lower_bound:
            return "at least " + number(p.low);
          case EstimateKind::estimate:
            break;
        }
      return number(p.estimate) + " [" + number(p.low) + ", " + number(p.high) +
             "]";
    }


    std::string
    probability_text(const BoundedProbability &p)
    {
      return bounded_text(p, kind_of(p.estimate));
    }


    std::string
    line(const std::string &name, const Proportion &p)
    {
      char text[200];
      std::snprintf(text,
                    sizeof text,
                    "\n  %-8s %-30s %llu of %llu",
                    name.c_str(),
                    probability_text(bounded(p)).c_str(),
                    static_cast<unsigned long long>(p.count),
                    static_cast<unsigned long long>(p.n));
      return p.n == 0 ? "\n  " + name + " -" : text;
    }


    std::string
    risk_text(const Risk &risk)
    {
      std::string text;
      const auto  add = [&](const char *const            of,
                           const std::optional<Budget> &budget) {
        if (budget)
          text += std::string("\n    budget of ") + of + ", " +
                  number(budget->budget) + ": " + to_string(budget->verdict);
      };
      add("all mechanisms", risk.all_mechanisms);
      add("macro-instability", risk.macro_instability);
      if (risk.risk)
        text +=
          "\n    risk " + bounded_text(*risk.risk, risk.risk->kind) + " euro";
      return text;
    }


    std::string
    yearly_text(const Yearly &yearly)
    {
      return "\nPer year, with the distribution of water levels:\n  P(S1)    " +
             probability_text(yearly.initial) + "\n  P(F)     " +
             probability_text(yearly.flooding) + risk_text(yearly.risk) +
             "\n    the water is above the highest level of the sweep with " +
             number(yearly.above_the_highest) +
             (std::isfinite(yearly.share_from_above)
                ? ", which makes up " + number(100. * yearly.share_from_above) +
                    " % of P(F)"
                : "") +
             (yearly.undecided.empty()
                ? ""
                : "\n    " + yearly.undecided +
                    ": the bounds hold whatever these would have done");
    }
  } // namespace


  std::optional<LevelDistribution>
  read_level_distribution(const RiskParameters &parameters)
  {
    switch (parameters.distribution)
      {
        case LevelSource::none:
          return {};
        case LevelSource::gumbel:
          return LevelDistribution::gumbel(parameters.location,
                                           parameters.scale);
        case LevelSource::table:
          break;
      }
    std::string text;
    try
      {
        text = read_input_file(parameters.level_table);
      }
    catch (const UserError &error)
      {
        throw UserError("Risk/Level table",
                        "'" + parameters.level_table + "' " + error.problem,
                        error.allowed +
                          "; a relative path begins in the folder in which "
                          "waker is started");
      }
    return LevelDistribution::parse_table(text, parameters.level_table);
  }


  namespace
  {
    /// A larger share of numerical failures may bias what is estimated from
    /// the others.
    constexpr double tolerable_failures = 0.05;


    std::vector<std::string>
    all_notes(const CampaignInfo                     &info,
              const std::vector<AnalysedScenario>    &scenarios,
              const std::vector<std::vector<Record>> &records_by_scenario,
              const std::vector<FragilityPoint>      &points)
    {
      std::vector<std::string> notes =
        undecided_notes(info, records_by_scenario);
      for (const AnalysedScenario &scenario : scenarios)
        {
          const ScenarioEstimate e = scenario.estimate();
          const std::uint64_t    n = e.n + e.n_numerical + e.n_undecided();
          if (e.n_numerical > tolerable_failures * n)
            notes.push_back(
              Log::warning_mark +
              (info.swept_parameter.empty()
                 ? ""
                 : info.swept_parameter + " = " + scenario.info->value + ": ") +
              std::to_string(e.n_numerical) + " of " + std::to_string(n) +
              " realisations failed numerically; if these are not like the "
              "others, the probabilities are biased");
        }
      const std::string equal_levels = equal_levels_note(info);
      if (points.empty() && !equal_levels.empty())
        notes.push_back(equal_levels);
      for (const std::string &note : fragility_notes(points))
        notes.push_back(note);
      return notes;
    }
  } // namespace


  void
  write_report(const CampaignInfo                     &info,
               const std::vector<std::vector<Record>> &records_by_scenario,
               const AnalysisParameters               &parameters,
               const std::string                      &directory,
               const std::vector<MachineUse>          &machines)
  {
    const auto distribution = read_level_distribution(parameters.risk);
    const auto scenarios    = analyse(info, records_by_scenario, parameters);
    const auto points       = fragility_points(info, records_by_scenario);
    std::vector<std::string> notes =
      all_notes(info, scenarios, records_by_scenario, points);
    const std::optional<Yearly> yearly_risk = yearly(
      info.sweeps_water_level(), points, distribution, parameters.risk, notes);

    const auto write = [&](const char *const name, const std::string &text) {
      write_file(report_path(directory, name), text);
    };
    using namespace ReportTables;
    const HistogramParameters &bins = parameters.histograms;
    write("realisations.csv", realisations(scenarios));
    write("probabilities.csv", probabilities(scenarios));
    write("probability_time.csv", probability_time(scenarios));
    write("convergence.csv", convergence(scenarios));
    write("histograms.csv", histograms(scenarios, bins));
    write("residual_resistance_width.csv",
          residual_resistance_width(scenarios, bins));
    write("classes.csv", classes(scenarios));
    write("quantities.csv", ReportTables::quantities(scenarios));
    write("event_tree.csv", event_tree(scenarios));
    write("fragility.csv", fragility(points));
    write("fragility_curve.csv", fragility_curve(points));
    write("fragility_beta.csv", fragility_beta(points));
    write("fragility_export.csv", fragility_export(points));
    write("fragility_export_upper.csv", fragility_export_upper(points));
    write("risk.csv",
          risk(scenarios, distribution, yearly_risk, parameters.risk));
    write("report.json",
          report_json(info,
                      scenarios,
                      points,
                      parameters,
                      distribution,
                      yearly_risk,
                      notes,
                      machines));
  }


  std::string
  report_text(const CampaignInfo                     &info,
              const std::vector<std::vector<Record>> &records_by_scenario,
              const AnalysisParameters               &parameters,
              const std::optional<LevelDistribution> &distribution)
  {
    const auto  scenarios = analyse(info, records_by_scenario, parameters);
    std::string text = "Probabilities with 95 % intervals (Clopper-Pearson):";
    for (const AnalysedScenario &scenario : scenarios)
      {
        const ScenarioEstimate e = scenario.estimate();
        if (!info.swept_parameter.empty())
          text += "\n" + info.swept_parameter + " = " + scenario.info->value;
        const std::uint64_t lost = e.n_lost();
        if (e.n + lost == 0)
          {
            text += "\n  no realisation yet";
            continue;
          }
        text += line("P(S1)", e.by_any.initial);
        const std::pair<const char *, const Proportion *> readings[] = {
          {"  W or H", &e.by_geometry.initial},
          {"  W < W_i", &e.by_width.initial},
          {"  moved", &e.by_displacement.initial}};
        for (const auto &[name, p] : readings)
          if (p->count != e.by_any.initial.count || p->n != e.n)
            text += line(name, *p);
        if (e.by_displacement.initial.count > 0)
          {
            text += line("  inner", e.inner_slides);
            text += line("  outer", e.outer_slides);
          }
        // Without a level nothing can flood.
        const bool may_flood = scenario.info->may_flood();
        if (may_flood)
          {
            text += line("P(F)", e.by_any.flooding);
            text += line("P(F|S1)", e.by_any.flooding_given);
          }
        for (const ClassCount &c : count_classes(*scenario.records,
                                                 scenario.slides,
                                                 scenario.info->base_level))
          if (c.failure_class != FailureClass::none && c.share.count > 0)
            text += "\n    " + to_string(c.failure_class) +
                    (c.flooded ? ", flooded: " : ", not flooded: ") +
                    std::to_string(c.share.count);
        if (e.n_not_final > 0)
          text += "\n  " + std::to_string(e.n_not_final) +
                  " initial failure(s) not flooded so far, but not at rest, "
                  "under changing loads or against the box: counted as not "
                  "flooded above";
        const auto left_out = [&](const std::uint64_t n,
                                  const std::string  &what) {
          if (n > 0)
            text +=
              "\n  " + std::to_string(n) + " " + what + ", not counted above";
        };
        left_out(e.n_numerical, "numerical failure(s)");
        left_out(e.n_still_moving, "still moving at the end time");
        left_out(e.n_loads_change, "whose loads still changed at the end time");
        left_out(e.n_stopped_by_box, "held by a side of the box");
        if (lost + e.n_not_final > 0)
          {
            text += may_flood ? "\n  if all of these had failed and flooded:"
                              : "\n  if all of these had failed:";
            text += line("P(S1)", e.if_all_failed.initial);
            if (may_flood)
              text += line("P(F)", e.if_all_failed.flooding);
          }
        if (e.n_beyond_law > 0)
          text +=
            "\n  " + std::to_string(e.n_beyond_law) +
            " whose draw is beyond a law at points, at up to " +
            std::to_string(e.most_points_beyond_law) +
            " of them (a dilatancy angle above the friction angle counts as the "
            "most that the law takes, an overconsolidation ratio below 1 as it "
            "is): counted above";
        if (!may_flood)
          text += "\n  no water level: nothing can flood";
        for (const Quantity &q : quantities(*scenario.records))
          text +=
            "\n  " + q.name + ": mean " + number(q.mean()) +
            (q.values.size() > 1
               ? ", deviation " + number(q.standard_deviation()) + ", from " +
                   number(q.quantile(0.)) + " to " + number(q.quantile(1.))
               : "") +
            (q.unit.empty() ? "" : " " + q.unit) + ", of " +
            std::to_string(q.values.size());
        if (!distribution && may_flood)
          text +=
            risk_text(assess_risk(flooding_of(scenario), parameters.risk));
      }

    const auto points = fragility_points(info, records_by_scenario);
    std::vector<std::string> notes =
      all_notes(info, scenarios, records_by_scenario, points);
    const std::optional<Yearly> yearly_risk = yearly(
      info.sweeps_water_level(), points, distribution, parameters.risk, notes);
    if (yearly_risk)
      text += yearly_text(*yearly_risk);
    for (const std::string &note : notes)
      text += "\n" + note;
    return text;
  }
} // namespace Waker
