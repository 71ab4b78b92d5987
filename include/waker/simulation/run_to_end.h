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

    /// What write_files(), looked() with the same words, and write_checkpoint()
    /// will ask for of the moment.
    virtual Wanted
    wants(const StopReason /*stop*/, const bool /*last*/)
    {
      return {};
    }

    /// The files of the moment that ranks write together, before it is looked
    /// at: on all ranks if one of them wants it.
    virtual void
    write_files()
    {}

    /// The checkpoint of the moment, which ranks write together, after it has
    /// been looked at: on all ranks if one of them wants it.
    virtual void
    write_checkpoint()
    {}

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
   *   step of which the numbers are none: the points hold them
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
        const Wanted wanted =
          realisation.wanted_by_any(watcher.wants(stop, last));
        realisation.complete(wanted);
        if (wanted.files)
          watcher.write_files();
        watcher.looked(stop, last);
        if (wanted.checkpoint)
          watcher.write_checkpoint();
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
