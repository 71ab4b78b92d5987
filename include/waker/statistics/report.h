// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_report_h
#define waker_statistics_report_h

#include <waker/statistics/analysis_parameters.h>
#include <waker/statistics/fragility.h>
#include <waker/store/campaign_info.h>
#include <waker/store/machine.h>
#include <waker/store/record.h>

#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  /// The distribution of the yearly maximum of the water level, if there is
  /// one. Reads the table's file; a relative path begins in the folder in which
  /// the program was started.
  /// @throws UserError "Risk/Level table" with the path, or file:line
  std::optional<LevelDistribution>
  read_level_distribution(const RiskParameters &parameters);

  /**
   * Write what a campaign says: the tables of ReportTables as <name>.csv, and
   * report.json, which holds per scenario the probabilities and the event tree
   * with its critical path, then the yearly probabilities (4.13), the budget
   * (4.8-4.9) and risk (4.1), and P(FoS < 1) by point statistics. Without a
   * distribution of water levels the budget and the risk are those of each
   * scenario, given its water level.
   *
   * @param records_by_scenario as many as info.scenarios; each realisation
   *        once, in any order; a scenario may have none yet
   * @param directory must exist
   * @param machines  JournalCounts::machines
   * @throws UserError "Output/Directory" if it is not writable; as
   *         read_level_distribution(), before anything is written
   */
  void
  write_report(const CampaignInfo                     &info,
               const std::vector<std::vector<Record>> &records_by_scenario,
               const AnalysisParameters               &parameters,
               const std::string                      &directory,
               const std::vector<MachineUse>          &machines = {});

  /// For people: counts, probabilities and intervals, a few lines per
  /// scenario, budgets and risk, without a line break at the end. Reads no
  /// file. @param distribution that of read_level_distribution()
  std::string
  report_text(const CampaignInfo                     &info,
              const std::vector<std::vector<Record>> &records_by_scenario,
              const AnalysisParameters               &parameters,
              const std::optional<LevelDistribution> &distribution = {});
} // namespace Waker

#endif
