// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/reliability/columns.h>
#include <waker/reliability/csv_table.h>
#include <waker/reliability/estimates.h>
#include <waker/reliability/histograms.h>
#include <waker/reliability/report_tables.h>

#include <algorithm>
#include <numeric>


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
          for (const std::uint64_t count : bin.counts)
            table.cell(count);
        }
    }
  } // namespace


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
          const ScenarioEstimate e = estimate(*scenarios[s].records);
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
      CsvTable table("scenario,value,quantity,bin_low,bin_high,count_stable,"
                     "count_initial_failure,count_flooding");
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


    namespace
    {
      template <typename Columns>
      void
      add_titles(const Columns &columns, std::string &titles)
      {
        for (const auto &column : columns)
          titles += "," + column.name;
      }


      template <typename Columns>
      void
      add_cells(const Columns        &columns,
                const AnalysedRecord &record,
                CsvTable             &table)
      {
        for (const auto &column : columns)
          table.cell(column.value(record));
      }
    } // namespace


    std::string
    realisations(const Scenarios &scenarios)
    {
      std::string titles = "scenario,value,realisation,outcome,failure_class,"
                           "still_moving,loads_change,at_box";
      add_titles(count_columns, titles);
      add_titles(real_columns, titles);
      add_titles(work_columns, titles);
      CsvTable table(titles);
      for (std::size_t s = 0; s < scenarios.size(); ++s)
        {
          const std::vector<Record> &records = *scenarios[s].records;
          std::vector<std::size_t>   order(records.size());
          std::iota(order.begin(), order.end(), std::size_t(0));
          std::sort(order.begin(),
                    order.end(),
                    [&](const std::size_t a, const std::size_t b) {
                      return records[a].realisation < records[b].realisation;
                    });
          for (const std::size_t i : order)
            {
              const std::vector<Slide> &slides = scenarios[s].slides[i];
              const AnalysedRecord      analysed{&records[i],
                                            slides,
                                            classify(records[i], slides)};
              scenario_row(table, scenarios, s)
                .cell(records[i].realisation)
                .cell(to_string(records[i].outcome))
                .cell(to_string(analysed.failure_class));
              for (bool Unrest::*const which :
                   {&Unrest::moving, &Unrest::loads_change, &Unrest::at_box})
                table.cell(records[i].unrest
                             ? std::to_string((*records[i].unrest).*which)
                             : std::string());
              add_cells(count_columns, analysed, table);
              add_cells(real_columns, analysed, table);
              add_cells(work_columns, analysed, table);
            }
        }
      return table.finish();
    }


    std::string
    classes(const Scenarios &scenarios)
    {
      CsvTable table("scenario,value,class,flooded,count,share,share_low,"
                     "share_high");
      for (std::size_t s = 0; s < scenarios.size(); ++s)
        for (const ClassCount &c :
             count_classes(*scenarios[s].records, scenarios[s].slides))
          scenario_row(table, scenarios, s)
            .cell(to_string(c.failure_class))
            .cell(c.flooded ? 1 : 0)
            .cell(c.share.count)
            .cells(c.share);
      return table.finish();
    }


    std::string
    event_tree(const Scenarios &scenarios)
    {
      CsvTable table("scenario,value,j,n_reached,n_S_j,n_F_j,P_S_j_given_not_F,"
                     "P_F_j_given_S_j,P_F_j,cumulative,cumulative_low,"
                     "cumulative_high");
      for (std::size_t s = 0; s < scenarios.size(); ++s)
        for (std::size_t j = 0; j < scenarios[s].tree.levels.size(); ++j)
          {
            const EventTreeLevel &level = scenarios[s].tree.levels[j];
            scenario_row(table, scenarios, s).cell(j + 1);
            table.cell(level.n_reached).cell(level.n_slides);
            table.cell(level.n_flooding).cell(level.slide);
            table.cell(level.flooding).cell(level.path);
            table.cell(level.cumulative).cell(level.interval.low);
            table.cell(level.interval.high);
          }
      return table.finish();
    }
  } // namespace ReportTables
} // namespace Waker
