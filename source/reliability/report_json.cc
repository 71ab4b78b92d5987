// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/reliability/estimates.h>
#include <waker/reliability/report_tables.h>
#include <waker/reliability/risk.h>

#include <nlohmann/json.hpp>

namespace Waker
{
  namespace
  {
    using Json = nlohmann::ordered_json; // writes NaN and infinity as null

    Json
    to_json(const Proportion &p)
    {
      return {{"count", p.count},
              {"n", p.n},
              {"estimate", p.estimate},
              {"low", p.low},
              {"high", p.high}};
    }


    Json
    to_json(const BoundedProbability &p)
    {
      return {{"estimate", p.estimate}, {"low", p.low}, {"high", p.high}};
    }


    Json
    to_json(const Estimate &e)
    {
      return {{"P_S1", to_json(e.initial)},
              {"P_F", to_json(e.flooding)},
              {"P_F_given_S1", to_json(e.flooding_given)}};
    }


    Json
    to_json(const std::optional<Budget> &budget)
    {
      if (!budget)
        return nullptr;
      return {{"budget", budget->budget},
              {"verdict", to_string(budget->verdict)}};
    }


    Json
    to_json(const EventTree &tree)
    {
      return {{"probability", tree.probability},
              {"direct", to_json(tree.direct)},
              {"length", tree.length},
              {"truncated", tree.truncated},
              {"critical_slide", tree.critical_slide},
              {"critical_path", tree.critical_path}};
    }


    Json
    scenario_json(const AnalysedScenario &scenario)
    {
      const ScenarioEstimate e = estimate(*scenario.records);
      Json                   json;
      json["value"]               = scenario.info->value;
      json["water_level"]         = scenario.info->water_level;
      json["crest_level"]         = scenario.info->crest_level;
      json["scales"]              = scenario.info->scales;
      json["n"]                   = e.n;
      json["n_numerical_failure"] = e.n_numerical;
      json["n_still_moving"]      = e.n_still_moving;
      json["n_loads_change"]      = e.n_loads_change;
      json["n_stopped_by_box"]    = e.n_stopped_by_box;
      json["n_S1_not_final"]      = e.n_not_final;
      json["by_any"]              = to_json(e.by_any);
      json["by_geometry"]         = to_json(e.by_geometry);
      json["by_width"]            = to_json(e.by_width);
      json["by_displacement"]     = to_json(e.by_displacement);
      json["inner_slides"]        = to_json(e.inner_slides);
      json["outer_slides"]        = to_json(e.outer_slides);
      json["if_all_failed"]       = to_json(e.if_all_failed);
      json["if_none_failed"]      = to_json(e.if_none_failed);
      json["event_tree"]          = to_json(scenario.tree);
      return json;
    }


    Json
    risk_json(const BoundedProbability &flooding,
              const RiskParameters     &parameters)
    {
      const Risk risk = assess_risk(flooding, parameters);
      Json       json;
      json["P_F"]               = to_json(flooding);
      json["all_mechanisms"]    = to_json(risk.all_mechanisms);
      json["macro_instability"] = to_json(risk.macro_instability);
      json["risk_euro"] = risk.risk ? to_json(*risk.risk) : Json(nullptr);
      return json;
    }


    /// Yearly probabilities; null if they cannot be had.
    Json
    yearly_json(const std::string                      &swept_parameter,
                const std::vector<FragilityPoint>      &points,
                const std::optional<LevelDistribution> &distribution,
                const RiskParameters                   &parameters,
                std::vector<std::string>               &notes)
    {
      if (!distribution)
        return nullptr;
      // One level says nothing about the others.
      if (swept_parameter != "Water/Level" || points.size() < 2)
        {
          notes.push_back("No yearly probability, budget or risk: this takes "
                          "a sweep of Water/Level with realisations at two "
                          "levels or more.");
          return nullptr;
        }
      const double lowest  = points.front().water_level;
      const double highest = points.back().water_level;
      const double above   = distribution->exceedance(highest);
      const double crest   = highest + points.back().freeboard;

      Json json;
      json["P_S1"] = to_json(
        yearly_probability(initial_failure_curve(points), *distribution));
      const BoundedProbability flooding =
        yearly_probability(flooding_curve(points), *distribution);
      json["P_F"]                       = to_json(flooding);
      json["P_level_below_the_lowest"]  = 1. - distribution->exceedance(lowest);
      json["P_level_above_the_highest"] = above;
      json["P_level_above_the_crest"]   = distribution->exceedance(crest);
      json["share_from_above_the_highest"] =
        above * flooding_curve(points).estimate.values.back() /
        flooding.estimate;
      json["risk"] = risk_json(flooding, parameters);
      notes.push_back(
        "Below the lowest and above the highest swept water level "
        "probabilities are taken as constant; overflow of an intact dyke is "
        "not counted.");
      const std::vector<double> &table = distribution->table_levels();
      if (!table.empty() && (table.front() > lowest || table.back() < highest))
        notes.push_back("The level table does not reach over all swept water "
                        "levels and was extrapolated.");
      return json;
    }


    Json
    point_statistics_json(const RiskParameters &parameters)
    {
      if (!(parameters.factor_of_safety > 0. && parameters.strength_cov > 0.))
        return nullptr;
      return {{"factor_of_safety", parameters.factor_of_safety},
              {"strength_variation", parameters.strength_cov},
              {"P_factor_below_1",
               failure_by_point_statistics(parameters.factor_of_safety,
                                           parameters.strength_cov)}};
    }
  } // namespace


  std::string
  report_json(const CampaignInfo                     &info,
              const std::vector<AnalysedScenario>    &scenarios,
              const std::vector<FragilityPoint>      &points,
              const AnalysisParameters               &parameters,
              const std::optional<LevelDistribution> &distribution,
              const std::vector<MachineUse>          &machines)
  {
    std::vector<std::string> notes;
    Json                     json;
    json["schema_version"]   = 1;
    json["version"]          = info.version;
    json["hash"]             = info.hash;
    json["seed"]             = info.seed;
    json["realisations"]     = info.realisations;
    json["swept_parameter"]  = info.swept_parameter;
    json["machines"]         = Json::parse(to_json(machines));
    json["confidence_level"] = confidence_level;
    json["scenarios"]        = Json::array();
    for (const AnalysedScenario &scenario : scenarios)
      {
        Json entry = scenario_json(scenario);
        if (!distribution)
          {
            const Proportion f = estimate(*scenario.records).by_any.flooding;
            entry["risk_given_level"] =
              risk_json({f.estimate, f.low, f.high}, parameters.risk);
          }
        json["scenarios"].push_back(entry);
      }
    json["yearly"] = yearly_json(
      info.swept_parameter, points, distribution, parameters.risk, notes);
    json["point_statistics"] = point_statistics_json(parameters.risk);
    json["notes"]            = notes;
    return json.dump(2) + '\n';
  }
} // namespace Waker
