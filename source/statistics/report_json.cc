// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/statistics/estimates.h>
#include <waker/statistics/quantities.h>
#include <waker/statistics/report_tables.h>

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
              {"high", p.high},
              {"kind", to_string(kind_of(p.estimate))}};
    }


    Json
    to_json(const BoundedProbability &p)
    {
      return {{"estimate", p.estimate},
              {"low", p.low},
              {"high", p.high},
              {"kind", to_string(kind_of(p.estimate))}};
    }


    Json
    to_json(const BoundedIndex &beta)
    {
      return {{"estimate", beta.estimate},
              {"low", beta.low},
              {"high", beta.high}};
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
    to_json(const EventTree &tree, const bool may_flood)
    {
      // Of nothing the sums are 0, which is no estimate.
      const bool known = may_flood && tree.direct.n > 0;
      return {{"probability", known ? Json(tree.probability) : Json(nullptr)},
              {"direct", to_json(tree.direct)},
              {"length", tree.length},
              {"truncated", known ? Json(tree.truncated) : Json(nullptr)},
              {"truncated_direct", to_json(tree.truncated_direct)},
              {"critical_slide", tree.critical_slide},
              {"critical_path", tree.critical_path}};
    }


    Json
    scenario_json(const AnalysedScenario &scenario)
    {
      const ScenarioEstimate e = scenario.estimate();
      Json                   json;
      json["value"]                  = scenario.info->value;
      json["water_level"]            = scenario.info->water_level;
      json["crest_level"]            = scenario.info->crest_level;
      json["base_level"]             = scenario.info->base_level;
      json["scales"]                 = scenario.info->scales;
      json["n"]                      = e.n;
      json["n_numerical_failure"]    = e.n_numerical;
      json["n_still_moving"]         = e.n_still_moving;
      json["n_loads_change"]         = e.n_loads_change;
      json["n_stopped_by_box"]       = e.n_stopped_by_box;
      json["n_S1_not_final"]         = e.n_not_final;
      json["n_beyond_law"]           = e.n_beyond_law;
      json["most_points_beyond_law"] = e.most_points_beyond_law;
      json["by_any"]                 = to_json(e.by_any);
      json["by_geometry"]            = to_json(e.by_geometry);
      json["by_width"]               = to_json(e.by_width);
      json["by_displacement"]        = to_json(e.by_displacement);
      json["inner_slides"]           = to_json(e.inner_slides);
      json["outer_slides"]           = to_json(e.outer_slides);
      json["if_all_failed"]          = to_json(e.if_all_failed);
      json["if_none_failed"]         = to_json(e.if_none_failed);
      json["event_tree"] = to_json(scenario.tree, scenario.info->may_flood());
      json["quantities"] = Json::object();
      for (const Quantity &q : quantities(*scenario.records))
        json["quantities"][q.name] = {{"unit", q.unit},
                                      {"n", q.values.size()},
                                      {"mean", q.mean()},
                                      {"standard_deviation",
                                       q.standard_deviation()},
                                      {"least", q.quantile(0.)},
                                      {"p05", q.quantile(0.05)},
                                      {"median", q.quantile(0.5)},
                                      {"p95", q.quantile(0.95)},
                                      {"largest", q.quantile(1.)}};
      return json;
    }


    Json
    risk_json(const BoundedProbability &flooding, const Risk &risk)
    {
      Json json;
      json["P_F"]               = to_json(flooding);
      json["all_mechanisms"]    = to_json(risk.all_mechanisms);
      json["macro_instability"] = to_json(risk.macro_instability);
      if (risk.risk)
        json["risk_euro"] = {{"estimate", risk.risk->estimate},
                             {"low", risk.risk->low},
                             {"high", risk.risk->high},
                             {"kind", to_string(risk.risk->kind)}};
      else
        json["risk_euro"] = nullptr;
      return json;
    }


    /// Null if they cannot be had.
    Json
    to_json(const std::optional<Yearly> &yearly)
    {
      if (!yearly)
        return nullptr;
      Json json;
      json["P_S1"]                         = to_json(yearly->initial);
      json["P_F"]                          = to_json(yearly->flooding);
      json["P_level_below_the_lowest"]     = yearly->below_the_lowest;
      json["P_level_above_the_highest"]    = yearly->above_the_highest;
      json["P_level_above_the_crest"]      = yearly->above_the_crest;
      json["share_from_above_the_highest"] = yearly->share_from_above;
      json["risk"]      = risk_json(yearly->flooding, yearly->risk);
      json["undecided"] = yearly->undecided;
      return json;
    }


    Json
    fragility_json(const std::vector<FragilityPoint> &points)
    {
      Json json = Json::array();
      if (points.empty())
        return json;
      const BoundedCurve monotone = flooding_curve(points);
      for (const FragilityPoint &point : points)
        {
          const BoundedProbability flooding = monotone.at(point);
          Json                     entry;
          entry["water_level"]     = point.water_level;
          entry["freeboard"]       = point.freeboard;
          entry["P_S1"]            = to_json(point.initial);
          entry["P_F"]             = to_json(point.flooding);
          entry["n_undecided"]     = point.n_lost;
          entry["n_S1_not_final"]  = point.n_not_final;
          entry["P_F_monotone"]    = to_json(flooding);
          entry["beta_F_monotone"] = to_json(reliability_index(flooding));
          json.push_back(entry);
        }
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
              const std::optional<Yearly>            &yearly_risk,
              const std::vector<std::string>         &notes,
              const std::vector<MachineUse>          &machines)
  {
    Json json;
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
            const BoundedProbability flooding = flooding_of(scenario);
            entry["risk_given_level"] =
              risk_json(flooding, assess_risk(flooding, parameters.risk));
          }
        json["scenarios"].push_back(entry);
      }
    json["fragility"]        = fragility_json(points);
    json["yearly"]           = to_json(yearly_risk);
    json["point_statistics"] = point_statistics_json(parameters.risk);
    json["notes"]            = notes;
    return json.dump(2) + '\n';
  }
} // namespace Waker
