// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_run_watcher_h
#define waker_source_simulation_run_watcher_h

#include <waker/base/log.h>
#include <waker/simulation/recorder.h>
#include <waker/simulation/run_to_end.h>

#include <vector>

namespace Waker
{
  /// Writes the files of a run, and says in the log what happens.
  template <int dim>
  class RunWatcher : public Watcher
  {
  public:
    /// All are kept by reference.
    /// @param resumed the moment that the state is of is in the files
    RunWatcher(const Parameters &parameters,
               const bool        resumed,
               const State<dim> &state,
               Realisation<dim> &realisation,
               Recorder<dim>    &recorder,
               Log              &log);

    void
    looked(const StopReason stop, const bool last) override;

    Wanted
    wants(const StopReason stop, const bool last) override;

    void
    write_files() override;

    void
    write_checkpoint() override;

    void
    advanced() override;

  private:
    const Parameters &parameters;
    const State<dim> &state;
    Realisation<dim> &realisation;
    Recorder<dim>    &recorder;
    Log              &log;

    // As of the moment before.
    FailureRecord               failure;
    std::size_t                 n_sliding_masses;
    std::vector<TractionRecord> tractions;
    std::vector<LoadRecord>     loads;

    bool          is_new;                // this moment is not in the files yet
    bool          held          = false; // domains, at the size of a cell
    bool          levels_failed = false; // was multigrid once not set up?
    std::uint64_t unconverged;
    LongSteps     long_steps;
  };
} // namespace Waker

#endif
