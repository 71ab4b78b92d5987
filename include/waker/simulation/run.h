// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_run_h
#define waker_simulation_run_h

#include <deal.II/base/mpi.h>

#include <waker/base/interrupt.h>
#include <waker/output/output_folder.h>

#include <functional>
#include <string>
#include <vector>

namespace Waker
{
  struct Parameters;
  template <int dim>
  struct Case;
  template <int dim>
  struct State;


  /// Changes the state at t = 0: gives the points properties of their own.
  /// Returns lines for the log.
  template <int dim>
  using InitialSetup =
    std::function<std::vector<std::string>(const Case<dim> &, State<dim> &)>;

  struct RunOptions
  {
    bool      validate_only = false; // check everything, write nothing
    bool      resume        = false; // go on from the last checkpoint
    bool      overwrite     = false; // of results of an earlier run
    bool      quiet         = false; // say nothing on the screen
    Interrupt interrupt;             // ends it cleanly with a checkpoint
    /// Called when the set-up, which may take minutes, is over, before the
    /// first thing is written: until then a program may end at any moment and
    /// leaves nothing behind. May be empty.
    std::function<void()> before_writing;
  };

  /// What a run with these options does with its folder.
  FolderMode
  folder_mode(const RunOptions &options);

  enum class RunStatus
  {
    completed,
    numerical_failure, // recorded in the summary
    interrupted        // a checkpoint is there
  };

  /**
   * Run one realisation with full output to the folder Output/Directory.
   *
   * @param setup of the first state; may be empty
   * @throws UserError before anything is written
   */
  template <int dim>
  RunStatus
  run(const Parameters        &parameters,
      const RunOptions        &options,
      const MPI_Comm           communicator,
      const InitialSetup<dim> &setup = {});

  /// Which strengths a strength reduction starts from.
  template <int dim>
  struct StrengthsToReduce
  {
    std::string       name = "those of the materials"; // for log and JSON
    InitialSetup<dim> setup;                           // may be empty
    /// Attempts at a trial that fails numerically, each with half the time
    /// step.
    unsigned int attempts = 1;
    /// What, beside the name, tells the trials of this case from those of
    /// others; empty: the parameters' hash and end time.
    std::string key;
  };


  /**
   * Find the factor of safety by strength reduction: realisations with all
   * strengths divided by a factor (MaterialVariable::Role), softening modulus
   * kept, until the factors of a stable and of a failed one are closer than the
   * tolerance. Failed = initial failure before the end time. A trial that fails
   * numerically in all its attempts is neither (FactorSearch). Writes
   * strength_reduction.csv (one line a factor) and strength_reduction.json.
   *
   * @return numerical_failure if such trials are left inside the bracket
   * @throws UserError before anything is written
   */
  template <int dim>
  RunStatus
  run_strength_reduction(const Parameters             &parameters,
                         const RunOptions             &options,
                         const MPI_Comm                communicator,
                         const StrengthsToReduce<dim> &strengths = {});
} // namespace Waker

#endif
