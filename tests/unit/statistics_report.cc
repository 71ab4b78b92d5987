// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/output/files.h>
#include <waker/statistics/report.h>
#include <waker/statistics/report_tables.h>

#include "output_temporary_folder.h"
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
  namespace
  {
    using namespace Waker;

    struct Campaign
    {
      CampaignInfo                     info;
      std::vector<std::vector<Record>> records;
    };


    /// Three water levels, 400 realisations each, of which one failed
    /// numerically.
    Campaign
    make_campaign()
    {
      std::mt19937                           generator(11);
      std::uniform_real_distribution<double> uniform(0., 1.);
      Campaign                               c;
      c.info.version         = "test";
      c.info.realisations    = 400;
      c.info.swept_parameter = "Water/Level";
      c.records.resize(3);
      for (unsigned int s = 0; s < 3; ++s)
        {
          ScenarioInfo scenario;
          scenario.water_level = 4.75 - 0.5 * s;
          scenario.value       = std::to_string(scenario.water_level);
          scenario.crest_level = 5.;
          scenario.base_level  = 0.;
          c.info.scenarios.push_back(scenario);
          for (std::uint64_t i = 0; i < 400; ++i)
            {
              Record r;
              r.scenario      = s;
              r.realisation   = i;
              r.initial_width = r.residual_width = 11.;
              r.initial_height = r.residual_height = 5.;
              r.end_time                           = 8.;
              if (uniform(generator) < 0.2)
                {
                  r.outcome      = Outcome::initial_failure;
                  r.initial_time = r.initial_time_thesis =
                    2. + uniform(generator);
                  r.inward = r.first_inward = {30., 2., -1.};
                  r.residual_width          = 4. + 3. * uniform(generator);
                  r.trace = {{0., 11., 5.}, {2., 11., 5.}, {4., 6., 5.}};
                  if (uniform(generator) < 0.7 / (1 + s))
                    {
                      r.outcome       = Outcome::flooding;
                      r.flooding_time = r.end_time = 7.;
                      r.residual_width             = 0.;
                      r.residual_height            = 4.;
                      r.trace.push_back({6., 6., 5.});
                    }
                  r.trace.push_back(
                    {r.end_time, r.residual_width, r.residual_height});
                }
              c.records[s].push_back(r);
            }
          c.records[s][5]             = Record();
          c.records[s][5].outcome     = Outcome::numerical_failure;
          c.records[s][5].realisation = 5;
        }
      return c;
    }


    const std::vector<std::string> tables = {"probabilities",
                                             "probability_time",
                                             "convergence",
                                             "histograms",
                                             "residual_resistance_width",
                                             "classes",
                                             "event_tree",
                                             "fragility",
                                             "fragility_curve",
                                             "fragility_beta",
                                             "fragility_export",
                                             "fragility_export_upper"};

    /// Rows of a table as maps from title to cell; every row must be complete.
    std::vector<std::map<std::string, std::string>>
    read_table(const std::string &folder, const std::string &name)
    {
      std::istringstream lines(read_file(join_path(folder, name + ".csv")));
      const auto         split = [](const std::string &line) {
        std::vector<std::string> cells(1);
        for (const char c : line)
          if (c == ',')
            cells.emplace_back();
          else
            cells.back() += c;
        return cells;
      };
      std::string line;
      std::getline(lines, line);
      const std::vector<std::string> titles = split(line);

      std::vector<std::map<std::string, std::string>> rows;
      while (std::getline(lines, line))
        {
          const std::vector<std::string> cells = split(line);
          EXPECT_EQ(cells.size(), titles.size()) << name << ": " << line;
          rows.emplace_back();
          for (std::size_t i = 0; i < cells.size(); ++i)
            EXPECT_TRUE(rows.back().emplace(titles[i], cells[i]).second)
              << "twice: " << titles[i];
        }
      return rows;
    }


    /// How many notes of a report.json have these words.
    std::size_t
    n_notes(const nlohmann::json &report, const std::string &words)
    {
      std::size_t n = 0;
      for (const auto &note : report["notes"])
        n += note.get<std::string>().find(words) != std::string::npos;
      return n;
    }
  } // namespace


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
} // namespace statistics_report
