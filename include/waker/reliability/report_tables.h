// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_reliability_report_tables_h
#define waker_reliability_report_tables_h

#include <waker/reliability/analysis_parameters.h>
#include <waker/reliability/campaign_info.h>
#include <waker/reliability/event_tree.h>
#include <waker/reliability/fragility.h>
#include <waker/reliability/machine.h>
#include <waker/reliability/record.h>
#include <waker/reliability/slides.h>

#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  /// The records of one scenario with their slides.
  struct AnalysedScenario
  {
    const ScenarioInfo             *info;
    const std::vector<Record>      *records;
    std::vector<std::vector<Slide>> slides; // of each record
    EventTree                       tree;
  };

  /// @param records_by_scenario must outlive the result
  std::vector<AnalysedScenario>
  analyse(const CampaignInfo                     &info,
          const std::vector<std::vector<Record>> &records_by_scenario,
          const AnalysisParameters               &parameters);

  /**
   * The tables of a report as text: comma separated, one line of titles, '.'
   * as decimal point, "nan" and "inf" where there is no number. Columns P_*
   * have P_*_low and P_*_high, the 95 % interval, beside them.
   */
  namespace ReportTables
  {
    using Scenarios = std::vector<AnalysedScenario>;

    std::string
    probabilities(const Scenarios &scenarios);

    /// One line per realisation, with all columns of the store but the slides;
    /// outcome and class in words.
    std::string
    realisations(const Scenarios &scenarios);

    /// With the counts n, n_S1, n_F, as convergence().
    std::string
    probability_time(const Scenarios &scenarios);

    std::string
    convergence(const Scenarios &scenarios);

    std::string
    histograms(const Scenarios &scenarios, const HistogramParameters &bins);

    /// Each scenario, and "all" of them together if there are several.
    std::string
    residual_resistance_width(const Scenarios           &scenarios,
                              const HistogramParameters &bins);

    std::string
    classes(const Scenarios &scenarios);

    std::string
    event_tree(const Scenarios &scenarios);

    std::string
    fragility(const std::vector<FragilityPoint> &points);

    /// The interpolated curves at 101 levels; titles alone without points.
    std::string
    fragility_curve(const std::vector<FragilityPoint> &points);

    /**
     * Pairs water_level,beta of P(F|h), as other programs read them: one per
     * swept level, made to fall with h. Where no dyke (every dyke) flooded
     * beta has no finite estimate: then it is that of the upper (lower) bound.
     */
    std::string
    fragility_beta(const std::vector<FragilityPoint> &points);
  } // namespace ReportTables

  /**
   * report.json as text (see write_report()).
   *
   * @param points of the same campaign
   * @param distribution of the yearly maximum of the water level
   */
  std::string
  report_json(const CampaignInfo                     &info,
              const std::vector<AnalysedScenario>    &scenarios,
              const std::vector<FragilityPoint>      &points,
              const AnalysisParameters               &parameters,
              const std::optional<LevelDistribution> &distribution,
              const std::vector<MachineUse>          &machines = {});
} // namespace Waker

#endif
