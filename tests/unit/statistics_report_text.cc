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

namespace statistics_report_text
{
  using namespace Waker;
  using namespace ReportCampaign;

  TEST(Report, text_for_people)
  {
    const Campaign    c = make_campaign();
    const std::string text =
      report_text(c.info, c.records, AnalysisParameters());
    for (const char *const part : {"Water/Level = 4.75",
                                   "P(F|S1)",
                                   " of 399",
                                   "retrogressive, flooded",
                                   "1 numerical failure"})
      EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
    EXPECT_NE(text.back(), '\n');
    EXPECT_EQ(text.find("beyond a law"), std::string::npos) << text;
  }


  TEST(Report, text_of_draws_beyond_a_law)
  {
    Campaign c = make_campaign();
    for (Record &record : c.records[0])
      record.points_beyond_law = 0;
    c.records[0][7].points_beyond_law  = 12;
    c.records[0][5].points_beyond_law  = 34; // a numerical failure
    c.records[0][11].points_beyond_law = 3;
    const std::string text =
      report_text(c.info, c.records, AnalysisParameters());
    EXPECT_NE(text.find("\n  3 whose draw is beyond a law at points, at up to "
                        "34 of them"),
              std::string::npos)
      << text;
    const TemporaryFolder folder;
    write_report(c.info, c.records, AnalysisParameters(), folder.path);
    const auto json =
      nlohmann::json::parse(read_file(join_path(folder.path, "report.json")));
    EXPECT_EQ(json["scenarios"][0]["n_beyond_law"], 3);
    EXPECT_EQ(json["scenarios"][0]["most_points_beyond_law"], 34);
    EXPECT_EQ(json["scenarios"][1]["n_beyond_law"], 0);
    // Of the others it is not known, which is not 0.
    const auto rows = read_table(folder.path, "realisations");
    EXPECT_EQ(rows.at(7).at("points_beyond_law"), "12");
    EXPECT_EQ(rows.at(8).at("points_beyond_law"), "0");
    EXPECT_EQ(rows.at(400).at("points_beyond_law"), "-1");
  }


  TEST(Report, text_of_no_flood_is_a_bound)
  {
    Campaign c = make_campaign();
    for (Record &record : c.records[0])
      record = Record();
    const std::string text =
      report_text(c.info, c.records, AnalysisParameters());
    EXPECT_NE(text.find("P(F)     at most 0.00918"), std::string::npos) << text;
    EXPECT_NE(text.find(" 0 of 400"), std::string::npos) << text;

    // given its level, if that is all there is
    AnalysisParameters parameters;
    parameters.risk.allowed_probability = 0.5;
    const std::string budget = report_text(c.info, c.records, parameters);
    EXPECT_NE(budget.find("budget of macro-instability, 0.02: met"),
              std::string::npos)
      << budget;
  }


  TEST(Report, text_without_water_has_no_floods)
  {
    Campaign c = make_campaign();
    for (Record &record : c.records[0])
      record = Record();
    for (ScenarioInfo &scenario : c.info.scenarios)
      scenario.water_level = std::numeric_limits<double>::quiet_NaN();
    c.info.swept_parameter.clear();
    c.info.scenarios.resize(1);
    c.records.resize(1);
    const std::string text =
      report_text(c.info, c.records, AnalysisParameters());
    EXPECT_NE(text.find("P(S1)"), std::string::npos) << text;
    EXPECT_EQ(text.find("P(F)"), std::string::npos) << text;
    EXPECT_NE(text.find("nothing can flood"), std::string::npos) << text;
  }


  TEST(Report, level_table_is_read_before_anything_is_written)
  {
    const TemporaryFolder folder;
    const Campaign        c = make_campaign();
    AnalysisParameters    parameters;
    parameters.risk.distribution = LevelSource::table;
    parameters.risk.level_table  = join_path(folder.path, "levels.csv");
    try
      {
        write_report(c.info, c.records, parameters, folder.path);
        FAIL();
      }
    catch (const UserError &error)
      {
        EXPECT_EQ(error.where, "Risk/Level table");
        EXPECT_NE(error.problem.find("'" + parameters.risk.level_table + "'"),
                  std::string::npos)
          << error.problem;
      }
    EXPECT_FALSE(std::filesystem::exists(folder.file("classes.csv")));

    write_file(parameters.risk.level_table,
               "level,probability\n3.9,0.1\n4.4,0.01\n");
    write_report(c.info, c.records, parameters, folder.path);
    const auto json =
      nlohmann::json::parse(read_file(join_path(folder.path, "report.json")));
    EXPECT_EQ(n_notes(json, "are taken as constant"), 1U);
    EXPECT_EQ(n_notes(json, "level table does not reach"), 1U);
    EXPECT_EQ(n_notes(json, "No yearly probability"), 0U);
  }


  TEST(Report, nothing_yearly_without_a_sweep_of_the_water_level)
  {
    AnalysisParameters parameters;
    parameters.risk.distribution        = LevelSource::gumbel;
    parameters.risk.location            = 3.;
    parameters.risk.scale               = 0.3;
    parameters.risk.allowed_probability = 0.01;
    parameters.risk.consequence         = 1e8;
    const Campaign c                    = make_campaign();

    Campaign one_level = c;
    one_level.info.scenarios.resize(1);
    one_level.records.resize(1);
    Campaign no_sweep             = one_level;
    no_sweep.info.swept_parameter = "";
    Campaign one_run              = c; // of three levels
    one_run.records[1].clear();
    one_run.records[2].clear();
    Campaign another             = c;
    another.info.swept_parameter = "Soil profile/dyke/Polygon";
    for (const Campaign &campaign : {one_level, no_sweep, one_run, another})
      {
        const TemporaryFolder folder;
        write_report(campaign.info, campaign.records, parameters, folder.path);
        const std::string text =
          read_file(join_path(folder.path, "report.json"));
        const auto json = nlohmann::json::parse(text);
        EXPECT_TRUE(json["yearly"].is_null());
        EXPECT_EQ(n_notes(json, "this takes a sweep of Water/Level"), 1U);
        EXPECT_EQ(n_notes(json, "are taken as constant"), 0U);
        EXPECT_EQ(text.find("verdict"), std::string::npos);
        EXPECT_EQ(text.find("risk_euro"), std::string::npos);
      }
  }


  TEST(Report, names_the_machines)
  {
    const TemporaryFolder folder;
    const Campaign        c = make_campaign();
    MachineUse            use;
    use.machine.host   = "node7";
    use.n_realisations = 1200;
    use.wall_time      = 360.5;
    write_report(c.info, c.records, AnalysisParameters(), folder.path, {use});
    const auto json =
      nlohmann::json::parse(read_file(join_path(folder.path, "report.json")));
    ASSERT_EQ(json["machines"].size(), 1U);
    EXPECT_EQ(json["machines"][0]["host"], "node7");
    EXPECT_EQ(json["machines"][0]["realisations"], 1200);
    EXPECT_EQ(json["machines"][0]["wall_time"], 360.5);
  }


  TEST(Report, cells_with_commas_are_quoted)
  {
    Campaign c                = make_campaign();
    c.info.scenarios[0].value = "a, \"b\"";
    const auto scenarios   = analyse(c.info, c.records, AnalysisParameters());
    const std::string text = ReportTables::probabilities(scenarios);
    EXPECT_NE(text.find("\n0,\"a, \"\"b\"\"\",399,"), std::string::npos);
  }
} // namespace statistics_report_text
