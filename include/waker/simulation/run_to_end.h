// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_run_to_end_h
#define waker_simulation_run_to_end_h

#include <waker/base/interrupt.h>
#include <waker/simulation/realisation.h>

namespace Waker
{
  /// Sees a realisation pass. This one lets it.
  class Watcher
  {
  public:
    virtual ~Watcher() = default;

    /// The realisation has looked at a moment.
    /// @param stop why it stops here; StopReason::none: it does not
    /// @param last is there no step after it, as it stops or is interrupted?
    virtual void
    looked(const StopReason /*stop*/, const bool /*last*/)
    {}

    /// Will looked() ask for more of the moment than what each step leaves:
    /// places and velocities of the points, and what is measured? Not asked of
    /// the last moment, which has all.
    virtual bool
    wants_all()
    {
      return false;
    }

    /// It has made a step, at the end of which it has not looked yet.
    virtual void
    advanced()
    {}
  };


  /**
   * Turn the handle until the realisation stops, or is interrupted: the one
   * loop over a run.
   *
   * @return why it has stopped; StopReason::none if it was interrupted
   * @throws NumericalFailure; the state is then the last good one, but for a
   *   step of which the numbers are none: State::points holds them
   */
  template <int dim>
  StopReason
  run_to_end(Realisation<dim> &realisation,
             Watcher          &watcher,
             const Interrupt  &interrupt = {})
  {
    while (true)
      {
        const StopReason stop = realisation.look();
        const bool       last =
          stop != StopReason::none || realisation.any(interrupt.has_come());
        if (realisation.any(last || watcher.wants_all()))
          realisation.complete();
        watcher.looked(stop, last);
        if (last)
          return stop;
        realisation.advance();
        watcher.advanced();
      }
  }


  template <int dim>
  StopReason
  run_to_end(Realisation<dim> &realisation)
  {
    Watcher nobody;
    return run_to_end(realisation, nobody);
  }
} // namespace Waker

#endif
