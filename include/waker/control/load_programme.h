// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_control_load_programme_h
#define waker_control_load_programme_h

#include <waker/base/time_function.h>
#include <waker/control/load_programme_parameters.h>
#include <waker/measures/load_record.h>

#include <limits>

namespace Waker
{
  /// What a load programme has seen at the end of a step; NaN: it watches
  /// nothing.
  struct LoadWatch
  {
    double hold  = std::numeric_limits<double>::quiet_NaN();
    double stop  = std::numeric_limits<double>::quiet_NaN();
    double table = std::numeric_limits<double>::quiet_NaN();
  };

  /**
   * A load as a function of what was observed: numbers in, a factor out. Steps
   * that are tried and given up leave no trace: the record changes with
   * accepted steps only, and growth is a rate, not an increment of a step.
   *
   *   record = start();
   *   each step: watch() at its start, factor() at the end that is tried,
   *              proceed() when it is accepted.
   */
  class LoadProgramme
  {
  public:
    /// @throws UserError "Load programmes/<name>/..."
    explicit LoadProgramme(const LoadProgrammeParameters &parameters);

    const LoadProgrammeParameters &
    parameters() const
    {
      return given;
    }

    /// The record at t = 0, of a body to which nothing has happened.
    LoadRecord
    start() const;

    /// Decide, by what was seen at record.time, what the next step brings.
    /// Idempotent.
    void
    watch(const LoadWatch &seen, LoadRecord &record) const;

    /// The factor at a time (s) of the step that begins at record.time.
    double
    factor(const LoadRecord &record, const double time) const;

    /// A step that ends at this time (s) is accepted.
    void
    proceed(const double time, LoadRecord &record) const;

    /// Will it never change again, whatever happens?
    bool
    is_over(const LoadRecord &record) const;

    /**
     * The last time at which the factor changes (s): see LastChange. Of a
     * growth that is not over it is not known, also while it waits. A table of
     * a quantity changes only as the body moves: what is at rest keeps its
     * load.
     */
    double
    last_change(const LoadRecord &record) const;

    /// Does it change after a time (s) whatever happens until then?
    bool
    changes_after(const double time) const;

  private:
    LoadProgrammeParameters given;
    TimeFunction            table; // of t (s), or of what is watched
    double                  end;   // of a growth: the factor at which it ends
  };
} // namespace Waker

#endif
