// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/statistics/csv_table.h>
#include <waker/statistics/estimates.h>
#include <waker/statistics/histograms.h>
#include <waker/statistics/quantities.h>
#include <waker/statistics/report_tables.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>


namespace Waker
{
  namespace
  {
    std::string
    titles_of_estimate()
    {
      return titles_of("P_S1") + titles_of("P_F") + titles_of("P_F_given_S1");
    }


    /// A new row that begins with number and value of scenario s.
    CsvTable &
    scenario_row(CsvTable                      &table,
                 const ReportTables::Scenarios &scenarios,
                 const std::size_t              s)
    {
      return table.row().cell(s).cell(scenarios[s].info->value);
    }


    /// n, n_S1, n_F and the probabilities.
    void
    add_estimate(CsvTable &table, const Estimate &e)
    {
      table.cell(e.initial.n).cell(e.initial.count).cell(e.flooding.count);
      table.cells(e);
    }


    void
    add_rows(CsvTable                        &table,
             const ReportTables::Scenarios   &scenarios,
             const std::size_t                s,
             const std::string               &quantity,
             const std::vector<OutcomeValue> &values,
             const double                     bin_width)
    {
      for (const HistogramBin &bin : histogram(values, bin_width))
        {
          scenario_row(table, scenarios, s).cell(quantity);
          table.cell(bin.low).cell(bin.high);
          for (const Outcome outcome : all_outcomes())
            if (is_decided(outcome))
              table.cell(bin.counts[static_cast<unsigned int>(outcome)]);
        }
    }
  } // namespace


  BoundedProbability
  flooding_of(const AnalysedScenario &scenario)
  {
    return scenario.estimate().flooding();
  }


  std::vector<AnalysedScenario>
  analyse(const CampaignInfo                     &info,
          const std::vector<std::vector<Record>> &records_by_scenario,
          const AnalysisParameters               &parameters)
  {
    AssertDimension(info.scenarios.size(), records_by_scenario.size());
    std::vector<AnalysedScenario> result;
    for (std::size_t s = 0; s < info.scenarios.size(); ++s)
      {
        const std::vector<Record>      &records = records_by_scenario[s];
        std::vector<std::vector<Slide>> slides;
        slides.reserve(records.size());
        for (const Record &record : records)
          slides.push_back(find_slides(record, parameters.slides));
        const EventTree tree =
          build_event_tree(slide_sequences(records, slides),
                           parameters.risk.event_tree_length);
        result.push_back(
          {&info.scenarios[s], &records, std::move(slides), tree});
      }
    return result;
  }


  namespace ReportTables
  {
    std::string
    probabilities(const Scenarios &scenarios)
    {
      CsvTable table(
        "scenario,value,n,n_numerical_failure,n_still_moving,n_loads_change,"
        "n_stopped_by_box,n_S1_not_final,n_S1" +
        titles_of("P_S1") + ",n_S1_geometry" + titles_of("P_S1_geometry") +
        ",n_S1_thesis" + titles_of("P_S1_thesis") + ",n_S1_displacement" +
        titles_of("P_S1_displacement") + ",n_inner_slide" +
        titles_of("P_inner_slide") + ",n_outer_slide" +
        titles_of("P_outer_slide") + ",n_F" + titles_of("P_F") +
        titles_of("P_F_given_S1") + titles_of("P_F_given_S1_thesis") +
        titles_of("P_S1_if_all_failed") + titles_of("P_F_if_all_failed") +
        titles_of("P_S1_if_none_failed") + titles_of("P_F_if_none_failed") +
        ",cov_S1,cov_F");
      for (std::size_t s = 0; s < scenarios.size(); ++s)
        {
          const ScenarioEstimate e = scenarios[s].estimate();
          const Proportion      &f = e.by_any.flooding;
          scenario_row(table, scenarios, s).cell(e.n).cell(e.n_numerical);
          table.cell(e.n_still_moving).cell(e.n_loads_change);
          table.cell(e.n_stopped_by_box).cell(e.n_not_final);
          for (const Proportion &p : {e.by_any.initial,
                                      e.by_geometry.initial,
                                      e.by_width.initial,
                                      e.by_displacement.initial,
                                      e.inner_slides,
                                      e.outer_slides,
                                      f})
            table.cell(p.count).cells(p);
          table.cells(e.by_any.flooding_given);
          table.cells(e.by_width.flooding_given);
          table.cells(e.if_all_failed.initial);
          table.cells(e.if_all_failed.flooding);
          table.cells(e.if_none_failed.initial);
          table.cells(e.if_none_failed.flooding);
          table.cell(coefficient_of_variation(e.by_any.initial.count, e.n));
          table.cell(coefficient_of_variation(f.count, e.n));
        }
      return table.finish();
    }


    std::string
    probability_time(const Scenarios &scenarios)
    {
      CsvTable table("scenario,value,time,n,n_S1,n_F" + titles_of_estimate());
      for (std::size_t s = 0; s < scenarios.size(); ++s)
        for (const EstimateRow &row :
             estimate_against_time(*scenarios[s].records))
          add_estimate(scenario_row(table, scenarios, s).cell(row.position),
                       row.estimate);
      return table.finish();
    }


    std::string
    convergence(const Scenarios &scenarios)
    {
      CsvTable table("scenario,value,n,n_S1,n_F" + titles_of_estimate());
      for (std::size_t s = 0; s < scenarios.size(); ++s)
        for (const EstimateRow &row :
             estimate_convergence(*scenarios[s].records))
          add_estimate(scenario_row(table, scenarios, s), row.estimate);
      return table.finish();
    }


    std::string
    histograms(const Scenarios &scenarios, const HistogramParameters &bins)
    {
      std::string titles = "scenario,value,quantity,bin_low,bin_high";
      for (const Outcome outcome : all_outcomes())
        if (is_decided(outcome))
          titles +=
            ",count_" + boost::replace_all_copy(to_string(outcome), " ", "_");
      CsvTable table(titles);
      for (std::size_t s = 0; s < scenarios.size(); ++s)
        {
          const AnalysedScenario    &scenario = scenarios[s];
          const std::vector<Record> &records  = *scenario.records;
          add_rows(table,
                   scenarios,
                   s,
                   "residual_height_above_water",
                   residual_heights(records, scenario.info->water_level),
                   bins.height_bin);
          add_rows(table,
                   scenarios,
                   s,
                   "residual_width",
                   residual_widths(records),
                   bins.width_bin);
          add_rows(table,
                   scenarios,
                   s,
                   "width_after_first_slide",
                   widths_after_first_slide(records, scenario.slides),
                   bins.width_bin);
        }
      return table.finish();
    }


    std::string
    residual_resistance_width(const Scenarios           &scenarios,
                              const HistogramParameters &bins)
    {
      CsvTable   table("scenario,value,bin_low,bin_high,n,n_F" +
                     titles_of("P_F_given_S1"));
      const auto add = [&](const std::string               &scenario,
                           const std::string               &value,
                           const std::vector<OutcomeValue> &widths) {
        for (const ResistanceBin &bin :
             residual_resistance(widths, bins.resistance_bin))
          table.row()
            .cell(scenario)
            .cell(value)
            .cell(bin.low)
            .cell(bin.high)
            .cell(bin.flooding.n)
            .cell(bin.flooding.count)
            .cells(bin.flooding);
      };

      std::vector<OutcomeValue> all;
      for (std::size_t s = 0; s < scenarios.size(); ++s)
        {
          const std::vector<OutcomeValue> widths =
            widths_after_first_slide(*scenarios[s].records,
                                     scenarios[s].slides);
          add(std::to_string(s), scenarios[s].info->value, widths);
          all.insert(all.end(), widths.begin(), widths.end());
        }
      if (scenarios.size() > 1)
        add("all", "", all);
      return table.finish();
    }


    std::string
    classes(const Scenarios &scenarios)
    {
      CsvTable table("scenario,value,class,flooded,count" + titles_of("share"));
      for (std::size_t s = 0; s < scenarios.size(); ++s)
        for (const ClassCount &c : count_classes(*scenarios[s].records,
                                                 scenarios[s].slides,
                                                 scenarios[s].info->base_level))
          scenario_row(table, scenarios, s)
            .cell(to_string(c.failure_class))
            .cell(c.flooded ? 1 : 0)
            .cell(c.share.count)
            .cells(c.share);
      return table.finish();
    }


    std::string
    quantities(const Scenarios &scenarios)
    {
      CsvTable table("scenario,value,quantity,unit,n,mean,standard_deviation,"
                     "least,p05,median,p95,largest");
      for (std::size_t s = 0; s < scenarios.size(); ++s)
        for (const Quantity &q : Waker::quantities(*scenarios[s].records))
          {
            scenario_row(table, scenarios, s).cell(q.name).cell(q.unit);
            table.cell(std::uint64_t(q.values.size()));
            table.cell(q.mean()).cell(q.standard_deviation());
            for (const double p : {0., 0.05, 0.5, 0.95, 1.})
              table.cell(q.quantile(p));
          }
      return table.finish();
    }


    std::string
    event_tree(const Scenarios &scenarios)
    {
      CsvTable table("scenario,value,j,n_reached,n_S_j,n_F_j" +
                     titles_of("P_S_j_given_not_F") +
                     titles_of("P_F_j_given_S_j") + titles_of("P_F_j") +
                     titles_of("cumulative"));
      for (std::size_t s = 0; s < scenarios.size(); ++s)
        {
          const EventTree    &tree      = scenarios[s].tree;
          const std::uint64_t n         = tree.direct.n;
          std::uint64_t       n_flooded = 0;
          for (std::size_t j = 0; j < tree.levels.size(); ++j)
            {
              const EventTreeLevel &level = tree.levels[j];
              n_flooded += level.n_flooding;
              scenario_row(table, scenarios, s).cell(j + 1);
              table.cell(level.n_reached).cell(level.n_slides);
              table.cell(level.n_flooding);
              // counts of whole sequences: the products of (4.21) telescope
              table.cells(proportion(level.n_slides, level.n_reached));
              table.cells(proportion(level.n_flooding, level.n_slides));
              table.cells(proportion(level.n_flooding, n));
              table.cells(proportion(n_flooded, n));
            }
        }
      return table.finish();
    }
  } // namespace ReportTables
} // namespace Waker
