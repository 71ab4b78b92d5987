// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_run_to_end_h
#define waker_simulation_run_to_end_h

#include <waker/simulation/realisation.h>

namespace Waker
{
  /// Sees a realisation pass. This one lets it.
  class Watcher
  {
  public:
    virtual ~Watcher() = default;

    /// The realisation has looked at a moment, and stops for this reason, if
    /// any.
    /// @return shall it go on?
    virtual bool
    looked(const StopReason)
    {
      return true;
    }

    /// It has made a step, at the end of which it has not looked yet.
    virtual void
    advanced()
    {}
  };


  /**
   * Turn the handle until the realisation stops: the one loop over a run.
   *
   * @return why it has stopped; StopReason::none if the watcher has left it
   * @throws NumericalFailure; the state is then the last good one, but for a
   *   step of which the numbers are none: State::points holds them
   */
  template <int dim>
  StopReason
  run_to_end(Realisation<dim> &realisation, Watcher &watcher)
  {
    while (true)
      {
        const StopReason stop = realisation.look();
        if (!watcher.looked(stop) || stop != StopReason::none)
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
