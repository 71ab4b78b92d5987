// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Realisations of the base case of chapter 5 as a campaign runs them, fields
// included: what an hour on one core is worth.
#include <waker/campaign/input.h>
#include <waker/campaign/realisation_runner.h>
#include <waker/program/parameter_reader.h>

#include "dyke.h"
#include <ctime>

namespace WakerBenchmarks
{
  namespace
  {
    void
    time_realisations(benchmark::State &timer)
    {
      const auto               inputs   = read_scenarios(WAKER_SOURCE_DIRECTORY
                                         "/parameters/chapter5/analysis1.prm",
                                         {});
      const Input             &input    = *inputs[0];
      const CampaignParameters campaign = input.reliability.campaign;
      RealisationRunner<2>     runner(input.simulation,
                                  input.reliability.fields,
                                  campaign.attempts,
                                  MPI_COMM_SELF);

      std::uint64_t realisation = 0, steps = 0, newton = 0, linear = 0;
      unsigned int  failed = 0, flooded = 0;
      double        field_time = 0., wall_time = 0.;
      const auto    start = std::clock();
      for (auto _ : timer)
        {
          const Record record =
            *runner.run(campaign.seed, realisation++, nullptr);
          failed += record.initial_time >= 0. ? 1 : 0;
          flooded += record.outcome == Outcome::flooding ? 1 : 0;
          steps += record.steps;
          newton += record.newton_iterations;
          linear += record.linear_iterations;
          field_time += record.field_time;
          wall_time += record.wall_time;
        }

      const double core_seconds = double(std::clock() - start) / CLOCKS_PER_SEC;

      using Counter              = benchmark::Counter;
      timer.counters["per_hour"] = 3600. * realisation / core_seconds;
      timer.counters["failed"]   = failed;
      timer.counters["flooded"]  = flooded;
      timer.counters["steps"]    = Counter(steps, Counter::kAvgIterations);
      timer.counters["newton"]   = Counter(newton, Counter::kAvgIterations);
      timer.counters["linear"]   = Counter(linear, Counter::kAvgIterations);
      timer.counters["fields_%"] = 100. * field_time / wall_time;
    }
  } // namespace


  void
  register_campaign()
  {
    // Always the same realisations: a dyke that fails takes five times as long
    // as one that holds. Of the first 100, 20 fail.
    benchmark::RegisterBenchmark("2D/6k/realisations of the base case",
                                 time_realisations)
      ->Iterations(100)
      ->Unit(benchmark::kMillisecond);
  }
} // namespace WakerBenchmarks
