// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_recorder_h
#define waker_simulation_recorder_h

#include <waker/case/parameters.h>
#include <waker/case/state.h>
#include <waker/control/outcome.h>
#include <waker/observers/observer.h>
#include <waker/output/checkpoint.h>
#include <waker/output/statistics.h>
#include <waker/output/summary.h>
#include <waker/simulation/field_files.h>

#include <memory>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * Writes a run to its folder: statistics, ParaView files, checkpoints,
   * summary. Its own progress goes into the checkpoints, so that a run which is
   * killed and resumed leaves the same files as one that was not.
   */
  template <int dim>
  class Recorder
  {
  public:
    /// A new run in a prepared folder.
    explicit Recorder(const Parameters &parameters);

    /// Go on from the last checkpoint, which sets `state`.
    /// @throws UserError "Output/Directory" if there is none that fits
    Recorder(const Parameters &parameters, State<dim> &state);

    /// A line for the user about the checkpoint, or empty.
    const std::string &
    warning() const
    {
      return resume_warning;
    }

    /// What ParaView files and a checkpoint at this time (s) need, if it is
    /// time for them.
    /// @param stops the run ends with this moment: files are always written
    /// @param last so is a checkpoint, also where it is interrupted
    Wanted
    wants(const double time, const bool stops, const bool last) const;

    /// ParaView files. Collective: see FieldFiles.
    void
    write_files(const StepView<dim> &view, const OwnPoints<dim> &own);

    /// A row of statistics. Comes after write_files().
    void
    record(const StepView<dim> &view);

    /// A checkpoint. Comes after record(). Collective: on other ranks
    /// CheckpointSlots::write().
    void
    checkpoint(const State<dim> &state, const OwnPoints<dim> &own);

    void
    write_summary(const State<dim>               &state,
                  const std::vector<LoadName>    &load_names,
                  const Outcome                   outcome,
                  const Unrest                   &unrest,
                  const std::string              &stop_reason,
                  const double                    wall_time,
                  const std::vector<std::string> &warnings) const;

  private:
    const Parameters *parameters;
    CheckpointSlots   slots;
    FieldFiles<dim>   fields;
    std::string       resume_warning;

    std::vector<std::unique_ptr<Observer<dim>>> observers;
    std::unique_ptr<Statistics>                 statistics;

    double next_fields     = 0.;    // time of the next ParaView files, s
    double next_checkpoint = 0.;    // s
    bool   files_are_new   = false; // those of a moment without a row yet
  };
} // namespace Waker

#endif
