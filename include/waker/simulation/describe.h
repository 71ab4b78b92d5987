// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_describe_h
#define waker_simulation_describe_h

#include <waker/case/case.h>
#include <waker/case/state.h>
#include <waker/control/outcome.h>

#include <string>

namespace Waker
{
  class Log;

  /// What the run is about to do, and the checks that a modeller would make:
  /// size, wave CFL, points per cell, initial stress, memory.
  template <int dim>
  void
  describe_case(const Case<dim> &the_case, Log &log);

  /// Says how far a plastic initial stress is: "load step 12 of 100000". To be
  /// ended with Log::end_progress().
  /// @param log is kept by reference
  BalanceWatcher
  initial_stress_progress(const InitialStressParameters &parameters, Log &log);

  /// "W 18.75 -> 11.02 m, H 5.00 -> 4.81 m", without W where it is not
  /// measured.
  std::string
  geometry_text(const FailureRecord &failure);

  /// "foundation: 0.31 m, stopped at t = 2.4 s".
  std::string
  load_text(const LoadRecord &load, const LoadName &name);

  /// What came out, in a few lines.
  /// @param wall_time, steps_done of this start of the program
  template <int dim>
  void
  describe_result(const State<dim>            &state,
                  const std::vector<LoadName> &load_names,
                  const Outcome                outcome,
                  const Unrest                &unrest,
                  const std::string           &reason,
                  const double                 wall_time,
                  const std::uint64_t          steps_done,
                  Log                         &log);

  /// What the first of several ranks told the others in a step.
  void
  describe_traffic(const NodeExchange::Traffic &sent,
                   const unsigned int           n_ranks,
                   const std::uint64_t          n_steps,
                   Log                         &log);
} // namespace Waker

#endif
