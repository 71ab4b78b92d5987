// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/numbers.h>
#include <waker/statistics/csv_table.h>
#include <waker/statistics/report_tables.h>


namespace Waker
{
  namespace
  {
    void
    add_risk(CsvTable &table, const BoundedProbability &flooding, const Risk &r)
    {
      table.cells(flooding);
      for (const auto *const budget : {&r.all_mechanisms, &r.macro_instability})
        table.cell(*budget ? (*budget)->budget : nan)
          .cell(*budget ? to_string((*budget)->verdict)
                        : std::string("unknown"));
      const Amount euro =
        r.risk.value_or(Amount{nan, nan, nan, EstimateKind::unknown});
      table.cell(euro.estimate).cell(euro.low).cell(euro.high);
      table.cell(to_string(euro.kind));
    }
  } // namespace


  std::string
  ReportTables::risk(const Scenarios                        &scenarios,
                     const std::optional<LevelDistribution> &distribution,
                     const std::optional<Yearly>            &yearly,
                     const RiskParameters                   &parameters)
  {
    CsvTable table("scope,scenario,value" + titles_of("P_F") +
                   ",budget_all_mechanisms,verdict_all_mechanisms,"
                   "budget_macro_instability,verdict_macro_instability,"
                   "risk_euro,risk_euro_low,risk_euro_high,risk_kind" +
                   titles_of("P_S1") +
                   ",P_level_above_the_highest,share_from_above_the_highest,"
                   "P_level_above_the_crest,note");
    if (yearly)
      {
        table.row().cell(std::string("year")).cell(std::string("all"));
        table.cell(std::string());
        add_risk(table, yearly->flooding, yearly->risk);
        table.cells(yearly->initial);
        table.cell(yearly->above_the_highest);
        table.cell(yearly->share_from_above).cell(yearly->above_the_crest);
        table.cell(yearly->undecided);
      }
    if (distribution) // risks given a level are none per year
      return table.finish();
    for (std::size_t s = 0; s < scenarios.size(); ++s)
      {
        const ScenarioEstimate   e        = scenarios[s].estimate();
        const BoundedProbability flooding = e.flooding();
        table.row().cell(std::string("given the level")).cell(s);
        table.cell(scenarios[s].info->value);
        add_risk(table, flooding, assess_risk(flooding, parameters));
        table.cells(e.initial());
        table.cell(nan).cell(nan).cell(nan);
        table.cell(undecided_text(e.n_lost(), e.n_not_final, e.n + e.n_lost()));
      }
    return table.finish();
  }
} // namespace Waker
