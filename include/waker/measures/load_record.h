// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_measures_load_record_h
#define waker_measures_load_record_h

#include <waker/base/last_change.h>

#include <string>

namespace Waker
{
  /// What a load programme has done so far (control/load_programme.h): part of
  /// the state.
  struct LoadRecord
  {
    double factor = 0.; // at `time`, in the programme's unit
    double time   = 0.; // up to which it has gone, s
    /// Where a table of a watched quantity puts it in the next step.
    double next     = 0.;
    bool   held     = false; // it waits in the next step
    double held_for = 0.;    // time that it has waited so far, s
    /// Stopped for good by what it watches (s), or -1: the factor is then the
    /// ultimate load.
    double stop_time = -1.;
    /// When the factor changed last (s).
    double change_time = LastChange::never;

    bool
    is_stopped() const
    {
      return stop_time >= 0.;
    }

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &factor &time &next &held &held_for &stop_time &change_time;
    }
  };

  /// How a programme is called, and what its factor is counted in: "m", "-".
  struct LoadName
  {
    std::string name;
    std::string unit;
  };
} // namespace Waker

#endif
