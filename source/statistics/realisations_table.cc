// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/statistics/columns.h>
#include <waker/statistics/csv_table.h>
#include <waker/statistics/field_columns.h>
#include <waker/statistics/report_tables.h>

#include <algorithm>
#include <numeric>

namespace Waker
{
  namespace ReportTables
  {
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
      add_titles(sliding_columns, titles);
      add_titles(sliding_count_columns, titles);
      add_titles(work_columns, titles);
      std::vector<const std::vector<Record> *> all;
      for (const auto &scenario : scenarios)
        all.push_back(scenario.records);
      const std::vector<FieldColumn> of_fields = field_columns(all);
      add_titles(of_fields, titles);
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
              const AnalysedRecord      analysed{
                &records[i],
                slides,
                classify(records[i], slides, scenarios[s].info->base_level)};
              table.row()
                .cell(s)
                .cell(scenarios[s].info->value)
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
              add_cells(sliding_columns, analysed, table);
              add_cells(sliding_count_columns, analysed, table);
              add_cells(work_columns, analysed, table);
              for (const FieldColumn &column : of_fields)
                table.cell(column.value(records[i]));
            }
        }
      return table.finish();
    }
  } // namespace ReportTables
} // namespace Waker
