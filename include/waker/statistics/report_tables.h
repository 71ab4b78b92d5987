// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_report_tables_h
#define waker_statistics_report_tables_h

#include <waker/statistics/analysis_parameters.h>
#include <waker/statistics/estimates.h>
#include <waker/statistics/event_tree.h>
#include <waker/statistics/fragility.h>
#include <waker/statistics/slides.h>
#include <waker/statistics/yearly.h>
#include <waker/store/campaign_info.h>
#include <waker/store/machine.h>
#include <waker/store/record.h>

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

    ScenarioEstimate
    estimate() const
    {
      return Waker::estimate(*records, info->may_flood());
    }
  };

  /// P(F) of a scenario, given its water level; ScenarioEstimate::flooding().
  BoundedProbability
  flooding_of(const AnalysedScenario &scenario);

  /// @param records_by_scenario must outlive the result
  std::vector<AnalysedScenario>
  analyse(const CampaignInfo                     &info,
          const std::vector<std::vector<Record>> &records_by_scenario,
          const AnalysisParameters               &parameters);

  /**
   * The tables of a report as text: comma separated, one line of titles, '.'
   * as decimal point, "nan" where there is no finite number. Columns P_* have
   * P_*_low and P_*_high, the 95 % interval, beside them, and P_*_kind, what
   * the estimate says (EstimateKind).
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

    /// See quantities(): number, mean, deviation, least, 5 %, median, 95 %,
    /// largest.
    std::string
    quantities(const Scenarios &scenarios);

    std::string
    event_tree(const Scenarios &scenarios);

    std::string
    fragility(const std::vector<FragilityPoint> &points);

    /// The interpolated curves at 101 levels; titles alone without points.
    std::string
    fragility_curve(const std::vector<FragilityPoint> &points);

    /**
     * Reliability index of P(F|h), made to fall with h: estimate, the index of
     * the upper and of the lower bound of P, and what beta is. Where no dyke
     * (every dyke) flooded beta is NaN, and only beta_low (beta_high) says
     * anything: kind is then "lower bound" ("upper bound"). Each column falls
     * with h; no column mixes estimates and bounds.
     */
    std::string
    fragility_beta(const std::vector<FragilityPoint> &points);

    /// Lines hydraulicload,failure_probability of P(F|h), made to rise with h,
    /// as other programs read them: levels with a finite estimate only.
    std::string
    fragility_export(const std::vector<FragilityPoint> &points);

    /// The same of the upper ends of the intervals, at every level.
    std::string
    fragility_export_upper(const std::vector<FragilityPoint> &points);

    /// Probability, budget and risk: per year, or of each scenario given its
    /// water level if there is no distribution of levels. Verdicts are
    /// "unknown" without an allowed probability.
    std::string
    risk(const Scenarios                        &scenarios,
         const std::optional<LevelDistribution> &distribution,
         const std::optional<Yearly>            &yearly,
         const RiskParameters                   &parameters);
  } // namespace ReportTables

  /**
   * report.json as text (see write_report()).
   *
   * @param points of the same campaign
   * @param distribution of the yearly maximum of the water level
   * @param yearly_risk  what follows from both
   * @param notes        for readers
   */
  std::string
  report_json(const CampaignInfo                     &info,
              const std::vector<AnalysedScenario>    &scenarios,
              const std::vector<FragilityPoint>      &points,
              const AnalysisParameters               &parameters,
              const std::optional<LevelDistribution> &distribution,
              const std::optional<Yearly>            &yearly_risk,
              const std::vector<std::string>         &notes,
              const std::vector<MachineUse>          &machines = {});
} // namespace Waker

#endif
