// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/output/files.h>
#include <waker/statistics/report.h>
#include <waker/statistics/report_tables.h>

#include "output_temporary_folder.h"
#include "report_campaign.h"
#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

namespace statistics_report
{
  using namespace Waker;
  using namespace ReportCampaign;

  TEST(Report, tables_and_json_say_the_same)
  {
    const TemporaryFolder folder;
    const Campaign        c = make_campaign();
    AnalysisParameters    parameters;
    parameters.risk.distribution        = LevelSource::gumbel;
    parameters.risk.location            = 3.;
    parameters.risk.scale               = 0.3;
    parameters.risk.allowed_probability = 0.01;
    parameters.risk.consequence         = 1e8;
    parameters.risk.factor_of_safety    = 1.3;
    parameters.risk.strength_cov        = 0.2;
    write_report(c.info, c.records, parameters, folder.path);

    for (const std::string &name : tables)
      EXPECT_GT(read_table(folder.path, name).size(), 2U) << name;
    for (const char *const name : {"probability_time", "convergence"})
      for (const auto &row : read_table(folder.path, name))
        {
          const double n          = std::stod(row.at("n")),
                       n_initial  = std::stod(row.at("n_S1")),
                       n_flooding = std::stod(row.at("n_F"));
          EXPECT_NEAR(std::stod(row.at("P_S1")), n_initial / n, 1e-11);
          EXPECT_NEAR(std::stod(row.at("P_F")), n_flooding / n, 1e-11);
          if (n_initial > 0.)
            {
              EXPECT_NEAR(std::stod(row.at("P_F_given_S1")),
                          n_flooding / n_initial,
                          1e-11);
            }
        }

    // Of each realisation all there is, in order of number.
    const auto  all  = read_table(folder.path, "realisations");
    std::size_t line = 0;
    for (std::size_t s = 0; s < c.records.size(); ++s)
      {
        std::vector<Record> sorted = c.records[s];
        std::sort(sorted.begin(),
                  sorted.end(),
                  [](const Record &a, const Record &b) {
                    return a.realisation < b.realisation;
                  });
        for (const Record &record : sorted)
          {
            ASSERT_LT(line, all.size());
            const auto &row = all[line++];
            EXPECT_EQ(row.at("scenario"), std::to_string(s));
            EXPECT_EQ(row.at("realisation"),
                      std::to_string(record.realisation));
            EXPECT_EQ(row.at("outcome"), to_string(record.outcome));
            EXPECT_NEAR(std::stod(row.at("residual_width")),
                        record.residual_width,
                        1e-9);
            EXPECT_EQ(row.at("flooding_time") == "nan",
                      record.flooding_time < 0.);
            EXPECT_EQ(row.at("steps"), std::to_string(record.steps));
          }
      }
    EXPECT_EQ(line, all.size());

    const auto json =
      nlohmann::json::parse(read_file(join_path(folder.path, "report.json")));
    const auto rows = read_table(folder.path, "probabilities");
    const auto tree = read_table(folder.path, "event_tree");
    ASSERT_EQ(rows.size(), 3U);
    for (unsigned int s = 0; s < 3; ++s)
      {
        const auto &scenario = json["scenarios"][s];
        const auto &flooding = scenario["by_geometry"]["P_F"];
        EXPECT_EQ(scenario["n"], 399);
        EXPECT_EQ(scenario["n_numerical_failure"], 1);
        EXPECT_EQ(std::stoi(rows[s].at("n_F")), flooding["count"]);
        EXPECT_NEAR(std::stod(rows[s].at("P_F_high")), flooding["high"], 1e-11);
        // the tree, fed with the slides found, is the direct count
        EXPECT_NEAR(scenario["event_tree"]["probability"].get<double>(),
                    flooding["estimate"].get<double>(),
                    1e-14);
        EXPECT_EQ(scenario["event_tree"]["critical_slide"], 2);
        double last = 0.;
        for (const auto &row : tree)
          if (row.at("scenario") == std::to_string(s))
            last = std::stod(row.at("cumulative"));
        EXPECT_NEAR(last, flooding["estimate"], 1e-11);
      }

    // classes: all realisations that count
    unsigned int n = 0;
    for (const auto &row : read_table(folder.path, "classes"))
      n += std::stoi(row.at("count"));
    EXPECT_EQ(n, 3U * 399U);

    const auto &yearly = json["yearly"];
    EXPECT_LT(yearly["P_F"]["low"], yearly["P_F"]["estimate"]);
    EXPECT_LT(yearly["P_F"]["estimate"],
              json["scenarios"][0]["by_geometry"]["P_F"]["estimate"]);
    const LevelDistribution gumbel = LevelDistribution::gumbel(3., 0.3);
    EXPECT_NEAR(
      yearly["share_from_above_the_highest"].get<double>() *
        yearly["P_F"]["estimate"].get<double>(),
      gumbel.exceedance(4.75) *
        json["scenarios"][0]["by_geometry"]["P_F"]["estimate"].get<double>(),
      1e-12);
    EXPECT_NEAR(yearly["P_level_above_the_crest"],
                gumbel.exceedance(5.),
                1e-15);
    EXPECT_NEAR(yearly["risk"]["risk_euro"]["high"].get<double>(),
                1e8 * yearly["P_F"]["high"].get<double>(),
                1e-3);
    EXPECT_EQ(yearly["risk"]["macro_instability"]["verdict"], "not met");
    const auto risks = read_table(folder.path, "risk");
    ASSERT_EQ(risks.size(), 1U);
    EXPECT_EQ(risks[0].at("scope"), "year");
    EXPECT_NEAR(std::stod(risks[0].at("P_F_high")),
                yearly["P_F"]["high"],
                1e-11);
    EXPECT_NEAR(std::stod(risks[0].at("P_S1")),
                yearly["P_S1"]["estimate"],
                1e-11);
    EXPECT_EQ(risks[0].at("verdict_macro_instability"), "not met");
    EXPECT_NEAR(std::stod(risks[0].at("budget_macro_instability")),
                4e-4,
                1e-15);
    EXPECT_NEAR(std::stod(risks[0].at("risk_euro_high")) /
                  yearly["risk"]["risk_euro"]["high"].get<double>(),
                1.,
                1e-10);
    // and on the screen
    const std::string text = report_text(
      c.info, c.records, parameters, read_level_distribution(parameters.risk));
    for (const char *const part : {"Per year",
                                   "macro-instability, 0.0004: not met",
                                   "above the highest level of the sweep",
                                   "euro",
                                   "taken as constant"})
      EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;

    // no row of any table has an infinite number; kinds stand beside
    // probabilities
    std::vector<std::string> files;
    for (const auto &entry : std::filesystem::directory_iterator(folder.path))
      {
        files.push_back(entry.path().filename().string());
        const std::string contents = read_file(entry.path().string());
        EXPECT_EQ(contents.find("inf"), std::string::npos) << files.back();
      }
    for (const auto &row : read_table(folder.path, "probability_time"))
      {
        EXPECT_EQ(row.at("P_S1_kind"),
                  row.at("n_S1") == "0" ? "upper bound" : "estimate");
        EXPECT_EQ(row.at("P_F_given_S1_kind") == "unknown",
                  row.at("n_S1") == "0");
      }
    for (const auto &row : tree)
      {
        EXPECT_LE(std::stod(row.at("P_F_j_low")), std::stod(row.at("P_F_j")));
        EXPECT_EQ(row.at("P_F_j_kind"),
                  row.at("n_F_j") == "0" ? "upper bound" : "estimate");
      }
    ASSERT_EQ(json["fragility"].size(), 3U);
    const auto curve = read_table(folder.path, "fragility");
    for (unsigned int i = 0; i < 3; ++i)
      {
        EXPECT_NEAR(std::stod(curve[i].at("P_F_monotone")),
                    json["fragility"][i]["P_F_monotone"]["estimate"],
                    1e-11);
        EXPECT_EQ(curve[i].at("P_F_kind"), json["fragility"][i]["P_F"]["kind"]);
      }
    EXPECT_NEAR(json["point_statistics"]["P_factor_below_1"], 0.1243, 5e-5);
    EXPECT_FALSE(json["notes"].empty());
    EXPECT_EQ(read_table(folder.path, "fragility")[0].at("freeboard"), "1.25");
    EXPECT_EQ(read_table(folder.path, "residual_resistance_width")
                .back()
                .at("scenario"),
              "all");
  }


  TEST(Report, does_not_depend_on_the_order_of_records)
  {
    const TemporaryFolder one, two;
    Campaign              c = make_campaign();
    write_report(c.info, c.records, AnalysisParameters(), one.path);
    for (auto &records : c.records)
      std::shuffle(records.begin(), records.end(), std::mt19937(2));
    write_report(c.info, c.records, AnalysisParameters(), two.path);
    for (const std::string &name : tables)
      EXPECT_EQ(read_file(join_path(one.path, name + ".csv")),
                read_file(join_path(two.path, name + ".csv")));
    EXPECT_EQ(read_file(join_path(one.path, "report.json")),
              read_file(join_path(two.path, "report.json")));
  }


  TEST(Report, of_a_campaign_without_results)
  {
    const TemporaryFolder folder;
    CampaignInfo          info;
    info.scenarios.resize(1);
    write_report(info, {{}}, AnalysisParameters(), folder.path);
    EXPECT_EQ(read_table(folder.path, "probabilities")[0].at("P_F"), "nan");
    EXPECT_TRUE(read_table(folder.path, "fragility").empty());
    const auto json =
      nlohmann::json::parse(read_file(join_path(folder.path, "report.json")));
    EXPECT_TRUE(
      json["scenarios"][0]["by_geometry"]["P_F"]["estimate"].is_null());
    EXPECT_EQ(json["scenarios"][0]["by_geometry"]["P_F"]["kind"], "unknown");
    EXPECT_TRUE(json["scenarios"][0]["event_tree"]["probability"].is_null());
    EXPECT_TRUE(json["scenarios"][0]["event_tree"]["critical_path"].is_null());
    EXPECT_TRUE(json["yearly"].is_null());
    EXPECT_NE(
      report_text(info, {{}}, AnalysisParameters()).find("no realisation"),
      std::string::npos);
  }
} // namespace statistics_report
