// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_report_campaign_h
#define waker_tests_report_campaign_h

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

/// A campaign of three water levels, and its tables read again.
namespace ReportCampaign
{
  using namespace Waker;

  struct Campaign
  {
    CampaignInfo                     info;
    std::vector<std::vector<Record>> records;
  };


  /// Three water levels, 400 realisations each, of which one failed
  /// numerically.
  inline Campaign
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
  inline std::vector<std::map<std::string, std::string>>
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
  inline std::size_t
  n_notes(const nlohmann::json &report, const std::string &words)
  {
    std::size_t n = 0;
    for (const auto &note : report["notes"])
      n += note.get<std::string>().find(words) != std::string::npos;
    return n;
  }
} // namespace ReportCampaign

#endif
