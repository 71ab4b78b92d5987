// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_water_level_h
#define waker_loads_water_level_h

#include <waker/base/last_change.h>
#include <waker/base/time_function.h>
#include <waker/loads/parameters.h>

namespace Waker
{
  /// The level of the water in time: Water/Level + Water/Rise, and what a load
  /// programme adds. Where no water stands, nothing changes.
  class WaterLevel
  {
  public:
    explicit WaterLevel(const WaterParameters &parameters)
      : stands(parameters.stands())
      , datum(parameters.level)
      , rise(parameters.rise, "Water/Rise")
    {}

    /// At time t (s), in m.
    double
    at(const double t) const
    {
      return datum + rise.value(t) + added;
    }

    /// What a load programme adds from now on (m).
    void
    set_added_rise(const double height)
    {
      added = height;
    }

    /// Does it depend on the time, whatever is added?
    bool
    moves() const
    {
      return stands && rise.moves();
    }

    /// The last time at which it changes (s): see LastChange.
    double
    last_change() const
    {
      return stands ? rise.last_change() : LastChange::never;
    }

    /// Does it change between two times?
    bool
    varies(const double from, const double to) const
    {
      return stands && rise.varies(from, to);
    }

    /**
     * The longest step from t on in which the level stays near what it is at t,
     * and in which a table has no corner.
     * @param longest step (s)
     * @param most that the level may change (m)
     * @param least step (s), whatever the level does
     */
    double
    longest_step(const double t,
                 const double longest,
                 const double most,
                 const double least) const;

  private:
    bool         stands;
    double       datum;      // m
    double       added = 0.; // m
    TimeFunction rise;
  };
} // namespace Waker

#endif
