// SPDX-License-Identifier: LGPL-2.1-or-later
#include "storm_warnings.h"

#include <waker/base/numbers.h>
#include <waker/base/time_function.h>
#include <waker/mechanics/time_scheme.h>

#include <sstream>

namespace Waker
{
  namespace
  {
    /// More short steps than this are a matter of hours.
    constexpr double many_steps = 2e5;
  } // namespace


  std::vector<std::string>
  storm_warnings(const Parameters &p)
  {
    std::vector<std::string> warnings;
    if (!p.water.stands())
      return warnings;
    const TimeFunction rise(p.water.rise, "Water/Rise");
    const double       peak = rise.time_of_largest();
    if (peak > p.time.end_time)
      {
        std::ostringstream text;
        text << "Time stepping/End time is " << in_digits(p.time.end_time)
             << " s, before the peak of Water/Rise, "
             << in_digits(rise.value(peak)) << " m at " << in_digits(peak)
             << " s: the dyke never meets it";
        warnings.push_back(text.str());
      }
    const SchemeTraits scheme = scheme_traits(p.time);
    const double       steps  = p.time.end_time / p.time.time_step;
    if (rise.moves() && scheme.has_inertia && scheme.is_implicit &&
        !scheme.has_long_steps && steps > many_steps)
      {
        std::ostringstream text;
        text << "Time stepping/Scheme is " << name_of(p.time.scheme)
             << ", with " << in_digits(steps) << " steps to the end time; "
             << name_of(Scheme::static_at_rest)
             << " takes long ones while the dyke rests";
        warnings.push_back(text.str());
      }
    return warnings;
  }
} // namespace Waker
